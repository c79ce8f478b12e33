# SPDX-License-Identifier: MIT
# The crate for Rust, by a cargo without a network. Each test compiles it anew where it changed.

get_filename_component(rust_tools "${SCARP_CARGO}" DIRECTORY)

# scarp_add_rust_test(NAME COMMAND command...): cargo's results are in the build directory, and
# the library is that of this build.
function(scarp_add_rust_test name)
  cmake_parse_arguments(arg "" "" "NEEDS;COMMAND" ${ARGN})
  scarp_add_test(rust.${name} rust IN thorough NEEDS cargo posix ${arg_NEEDS} COMMAND ${arg_COMMAND})
  if(NOT TEST rust.${name})
    return()
  endif()
  set_tests_properties(rust.${name} PROPERTIES
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/src/bindings/rust
    RESOURCE_LOCK cargo
    ENVIRONMENT "CARGO_TARGET_DIR=${CMAKE_CURRENT_BINARY_DIR}/rust;\
CARGO_INCREMENTAL=0;CARGO_PROFILE_DEV_DEBUG=0;CARGO_PROFILE_TEST_DEBUG=0;RUSTFLAGS=-Dwarnings;\
RUSTDOCFLAGS=-Dwarnings;RUSTC=${rust_tools}/rustc;RUSTDOC=${rust_tools}/rustdoc;\
SCARP_LIB_DIR=$<TARGET_FILE_DIR:scarp>;SCARP_HASHES=$<TARGET_FILE:bindings_hashes>"
    ENVIRONMENT_MODIFICATION "LD_LIBRARY_PATH=path_list_prepend:$<TARGET_FILE_DIR:scarp>;\
DYLD_LIBRARY_PATH=path_list_prepend:$<TARGET_FILE_DIR:scarp>")
endfunction()

# Bits, mistakes, the layout of structures; then what the documents show.
scarp_add_rust_test(calls COMMAND ${SCARP_CARGO} test --offline --locked --tests --examples)
scarp_add_rust_test(documents COMMAND ${SCARP_CARGO} test --offline --locked --doc)

# The package; the library compiled by build.rs, from it and from the tree; pkg-config
scarp_add_rust_test(package NEEDS sh pkg-config
                    COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/bindings/crate.sh ${package_settings} ${SCARP_CARGO})
