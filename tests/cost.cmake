# SPDX-License-Identifier: MIT
# Compares instructions per point with the committed figures. A busy machine does not change them.

set(cost_processor ${CMAKE_SYSTEM_PROCESSOR})
if(CMAKE_CROSSCOMPILING_EMULATOR)
  set(cost_processor emulated)
endif()
scarp_test_program(test_cost)
scarp_add_test(cost cost IN thorough NEEDS python3 valgrind
               COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/test_cost.py
               $<TARGET_FILE:test_cost> ${CMAKE_CURRENT_SOURCE_DIR}/cost.txt
               ${CMAKE_CURRENT_BINARY_DIR} "processor: ${cost_processor}"
               "${CMAKE_C_COMPILER_ID} ${CMAKE_C_COMPILER_VERSION}"
               "build type: $<CONFIG>" "flags: ${CMAKE_C_FLAGS}")
