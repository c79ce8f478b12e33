# SPDX-License-Identifier: MIT
# The README's examples, compiled and run as they stand there.
find_package(Python3 COMPONENTS Interpreter)
if(Python3_Interpreter_FOUND AND CMAKE_C_COMPILER_ID MATCHES "GNU|Clang" AND UNIX
   AND NOT CMAKE_C_FLAGS MATCHES "-fsanitize")
  scarp_add_test(readme package ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/test_readme.py
                 ${PROJECT_SOURCE_DIR}/README.md $<TARGET_FILE:scarp> ${PROJECT_SOURCE_DIR}/include
                 ${CMAKE_CURRENT_BINARY_DIR}/readme ${CMAKE_C_COMPILER}
                 ${CMAKE_CROSSCOMPILING_EMULATOR})
else()
  message(STATUS "The README's examples are not tested: that needs python3, gcc or clang, no sanitizer")
endif()
