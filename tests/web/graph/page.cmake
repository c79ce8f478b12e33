# SPDX-License-Identifier: MIT
# Bundles the page of the tests of the graph into the folder TO, if its libraries are there.
file(MAKE_DIRECTORY ${TO})
if(EXISTS ${MODULES})
  execute_process(COMMAND ${NODE} ${FROM}/build.mjs ${MODULES} ${PACKAGE} ${TO}
                  COMMAND_ERROR_IS_FATAL ANY)
else()
  file(TOUCH ${TO}/page.js)
endif()
