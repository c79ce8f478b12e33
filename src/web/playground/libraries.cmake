# SPDX-License-Identifier: MIT
# Has npm put the libraries of the page into the folder TO. Where it cannot, a line tells so, and
# there is no page; the rest of the build goes on.
file(MAKE_DIRECTORY ${TO})
file(COPY ${FROM}/package.json ${FROM}/package-lock.json DESTINATION ${TO})
execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
                WORKING_DIRECTORY ${TO} OUTPUT_QUIET ERROR_VARIABLE said RESULT_VARIABLE failed)
if(failed)
  string(REGEX REPLACE "\n.*" "" said "${said}")
  message(STATUS "npm cannot get the libraries of the playground, which is not built: ${said}")
  file(REMOVE_RECURSE ${TO}/node_modules)
else()
  file(TOUCH ${TO}/stamp)
endif()
