# SPDX-License-Identifier: MIT
# Runs the recipes for farms of src/cli/README.md as they are there, with processes that are
# killed: one test per file farm/test_*.py, four of test_killed.py. SCARP_TEST_FARM=1 in the environment also runs
# those that start daemons, and fails where a tool is missing.

if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  add_library(without_locks MODULE farm/without_locks.c)
  scarp_compile_rules(without_locks)
  set_target_properties(without_locks PROPERTIES C_VISIBILITY_PRESET default)
endif()
foreach(name same locks mpirun parallel kubernetes levels gdal slurm)
  set(script ${CMAKE_CURRENT_SOURCE_DIR}/farm/test_${name}.py)
  if(NOT EXISTS ${script})
    set(script ${CMAKE_CURRENT_SOURCE_DIR}/farm/test_killed.py ${name})
  endif()
  scarp_add_test(farm.${name} farm IN thorough NEEDS scarp python3 linux full-speed COMMAND
                 ${Python3_EXECUTABLE} -B ${script}
                 $<TARGET_FILE:scarp-cli> ${PROJECT_SOURCE_DIR}/src/cli/README.md
                 ${CMAKE_CURRENT_BINARY_DIR}/farm $<TARGET_FILE:without_locks>)
  # They keep all cores busy, but for slurm, which waits for its daemons most of the time.
  set_tests_properties(farm.${name} PROPERTIES TIMEOUT 300)
  if(NOT name STREQUAL slurm)
    set_tests_properties(farm.${name} PROPERTIES PROCESSORS 2)
  endif()
endforeach()
