# SPDX-License-Identifier: MIT
# The crate for Rust: `cmake --build build --target crate` puts it together in build/crate, with the
# library as one file, from where `cargo package` and `cargo build` work without a network.

add_custom_target(crate
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D SINGLE=${PROJECT_BINARY_DIR}/single
          -D OUTPUT=${PROJECT_BINARY_DIR}/crate -D REPOSITORY=${SCARP_REPOSITORY}
          -P ${PROJECT_SOURCE_DIR}/cmake/crate.cmake
  COMMENT "Putting the crate together"
  VERBATIM)
add_dependencies(crate single)
