# SPDX-License-Identifier: MIT
# The bindings: the description of the header, and the module for Python

set(bindings ${CMAKE_CURRENT_SOURCE_DIR}/bindings)

# Python loads no library with instruments in it, nor one of another processor.
set(loads ON)
if(CMAKE_C_FLAGS MATCHES "-fsanitize" OR CMAKE_CROSSCOMPILING OR CMAKE_CROSSCOMPILING_EMULATOR)
  set(loads OFF)
endif()

# scarp_add_python_test(NAME [IN leg...] [ARGUMENTS argument...]): bindings/test_NAME.py, by a Python that has
# NumPy
function(scarp_add_python_test name)
  cmake_parse_arguments(arg "" "" "IN;ARGUMENTS" ${ARGN})
  scarp_add_test(python.${name} python IN without-numpy ${arg_IN} NEEDS numpy posix
                 COMMAND "${SCARP_NUMPY}" -B ${bindings}/test_${name}.py ${PROJECT_SOURCE_DIR}
                 $<TARGET_FILE:scarp> ${arg_ARGUMENTS})
  if(TEST python.${name})
    set_tests_properties(python.${name} PROPERTIES ENVIRONMENT SCARP_LOADS=${loads})
  endif()
endfunction()

# The description and what is made of it are current. Other compilers than gcc and clang have other
# options.
set(compiler ${CMAKE_C_COMPILER})
if(CMAKE_C_COMPILER_TARGET)
  list(APPEND compiler --target=${CMAKE_C_COMPILER_TARGET})
endif()
if(NOT CMAKE_C_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
  scarp_add_test(python.interface python IN nobody without-numpy NEEDS python3
                 COMMAND ${Python3_EXECUTABLE} -B ${bindings}/test_interface.py
                 ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/interface ${compiler})
endif()

add_executable(bindings_hashes bindings/hashes.c)
scarp_compile_rules(bindings_hashes)
target_link_libraries(bindings_hashes PRIVATE scarp ${SCARP_LIBM})
scarp_add_python_test(hashes ARGUMENTS $<TARGET_FILE:bindings_hashes>)
scarp_add_python_test(module)
scarp_add_python_test(stubs IN nobody)
scarp_add_python_test(wheel IN thorough ARGUMENTS ${CMAKE_CURRENT_BINARY_DIR}/wheel)
