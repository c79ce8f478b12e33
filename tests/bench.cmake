# SPDX-License-Identifier: MIT
# Tests from outside that scarp-bench measures and reports, not how fast anything is.

set(program ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:scarp-bench>)
set(script ${CMAKE_CURRENT_LIST_DIR}/test_bench.py)
foreach(group Selection Results Errors)
  string(TOLOWER ${group} name)
  scarp_add_test(bench.${name} bench NEEDS scarp-bench python3
                 COMMAND ${Python3_EXECUTABLE} ${script} ${group} ${program})
endforeach()
