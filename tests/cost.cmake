# SPDX-License-Identifier: MIT
# Instructions per point against committed figures. Counts, not times: the same on a busy machine.
find_package(Python3 COMPONENTS Interpreter)
if(Python3_Interpreter_FOUND AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$"
   AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
  scarp_test_program(test_cost)
  scarp_add_test(cost cost ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/test_cost.py
                 $<TARGET_FILE:test_cost> ${CMAKE_CURRENT_SOURCE_DIR}/cost.txt
                 ${CMAKE_CURRENT_BINARY_DIR} "${CMAKE_C_COMPILER_ID} ${CMAKE_C_COMPILER_VERSION}"
                 "${CMAKE_BUILD_TYPE}" "flags: ${CMAKE_C_FLAGS}")
else()
  message(STATUS "Instructions are not counted: that needs x86-64, python3 and no emulator")
endif()
