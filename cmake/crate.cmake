# SPDX-License-Identifier: MIT
# Puts the crate together, with the single file inside, so that cargo packages and builds it there:
#
#   cmake -D SOURCE=<source tree> -D SINGLE=<directory of scarp_single.c> -D OUTPUT=<directory>
#         [-D REPOSITORY=<URL>] -P crate.cmake

set(crate ${SOURCE}/src/bindings/rust)
foreach(part IN ITEMS c examples presets src tests)
  file(REMOVE_RECURSE ${OUTPUT}/${part})
endforeach()
foreach(part IN ITEMS examples src tests build.rs Cargo.lock README.md)
  file(COPY ${crate}/${part} DESTINATION ${OUTPUT} NO_SOURCE_PERMISSIONS)
endforeach()
file(COPY ${SOURCE}/LICENSE DESTINATION ${OUTPUT} NO_SOURCE_PERMISSIONS)
file(COPY ${SINGLE}/scarp_single.c ${SINGLE}/scarp.h DESTINATION ${OUTPUT}/c NO_SOURCE_PERMISSIONS)
file(GLOB presets ${SOURCE}/src/cli/presets/*.recipe)
file(COPY ${presets} DESTINATION ${OUTPUT}/presets NO_SOURCE_PERMISSIONS)

file(READ ${crate}/Cargo.toml text)
if(REPOSITORY)
  string(REPLACE "\nlicense = " "\nrepository = \"${REPOSITORY}\"\nlicense = " text "${text}")
endif()
file(WRITE ${OUTPUT}/Cargo.toml "${text}")
