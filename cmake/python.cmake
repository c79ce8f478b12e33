# SPDX-License-Identifier: MIT
# The module for Python: a wheel for this platform (`cmake --build build --target wheel`), which has
# the shared library inside and is made without a network, and the files of Debian's package.

set(python_module ${PROJECT_SOURCE_DIR}/src/bindings/python)
find_package(Python3 COMPONENTS Interpreter QUIET)
if(Python3_Interpreter_FOUND AND NOT CMAKE_CROSSCOMPILING)
  add_custom_target(wheel
    COMMAND ${Python3_EXECUTABLE} -B ${python_module}/wheel.py $<TARGET_FILE:scarp>
            ${PROJECT_BINARY_DIR}/wheel
    COMMENT "Making a wheel"
    VERBATIM)
  add_dependencies(wheel scarp)
endif()

# Debian's own place for modules, which serve every version of Python 3.
set(python_place lib/python3/dist-packages)
install(DIRECTORY ${python_module}/scarp DESTINATION ${python_place}
  COMPONENT python EXCLUDE_FROM_ALL
  FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed"
  PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/cli/presets/ DESTINATION ${python_place}/scarp/presets
  COMPONENT python EXCLUDE_FROM_ALL FILES_MATCHING PATTERN "*.recipe")
