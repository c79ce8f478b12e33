# SPDX-License-Identifier: MIT
# Bundles the page into the folder TO, if its libraries are there.
file(MAKE_DIRECTORY ${TO})
if(EXISTS ${MODULES})
  execute_process(COMMAND ${NODE} ${FROM}/build.mjs ${MODULES} ${TO} ${LANGUAGE} ${RECIPES}
                  COMMAND_ERROR_IS_FATAL ANY)
  file(COPY ${FROM}/index.html ${FROM}/../NOTICE ${FROM}/../../../LICENSE ${FROM}/../../../include/scarp.wgsl
       DESTINATION ${TO})
  file(TOUCH ${TO}/index.html)
  message("The page is in ${TO}: python3 -m http.server -d ${TO}")
endif()
