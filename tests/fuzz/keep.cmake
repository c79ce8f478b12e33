# SPDX-License-Identifier: MIT
# Adds to a corpus the inputs that tests of a fuzz target have found, as far as they reach what none of
# the corpus reaches.
#
#   cmake -D PROGRAM=... -D KEPT=corpus/NAME -D FOUND=folder -P keep.cmake

file(GLOB folders ${FOUND}/corpus)
if(folders)
  file(MAKE_DIRECTORY ${KEPT})
  execute_process(COMMAND ${PROGRAM} -merge=1 ${KEPT} ${folders} ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
endif()
