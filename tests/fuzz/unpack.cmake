# SPDX-License-Identifier: MIT
# Unpacks the inputs that are kept in ${KEPT} into ${FOUND}/kept, and lists them as `kept`. A new target
# has none.

file(REMOVE_RECURSE ${FOUND}/kept)
file(MAKE_DIRECTORY ${FOUND}/kept)
if(EXISTS ${KEPT})
  execute_process(COMMAND ${PACK} unpack ${KEPT} ${FOUND}/kept COMMAND_ERROR_IS_FATAL ANY)
endif()
file(GLOB kept ${FOUND}/kept/*)
