# SPDX-License-Identifier: MIT
# Adds to a corpus the inputs that tests of a fuzz target have found, as far as they reach what none of
# the corpus reaches.
#
#   cmake -D PROGRAM=... -D PACK=fuzz_pack -D KEPT=corpus/NAME.bin -D FOUND=folder -P keep.cmake

file(GLOB found ${FOUND}/corpus/*)
if(found)
  include(${CMAKE_CURRENT_LIST_DIR}/unpack.cmake)
  execute_process(COMMAND ${PROGRAM} -merge=1 ${FOUND}/kept ${FOUND}/corpus ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB kept ${FOUND}/kept/*)
  execute_process(COMMAND ${PACK} add ${KEPT} ${kept} COMMAND_ERROR_IS_FATAL ANY)
endif()
