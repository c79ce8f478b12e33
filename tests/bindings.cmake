# SPDX-License-Identifier: MIT
# The bindings: the description of the header, and the module for Python

set(bindings ${CMAKE_CURRENT_SOURCE_DIR}/bindings)

# Python loads no library with instruments in it, nor one of another processor.
set(loads ON)
if(CMAKE_C_FLAGS MATCHES "-fsanitize" OR CMAKE_CROSSCOMPILING OR CMAKE_CROSSCOMPILING_EMULATOR)
  set(loads OFF)
endif()

# scarp_add_python_test(NAME [IN leg...] [ARGUMENTS argument...]): bindings/test_NAME.py, by a Python that has
# NumPy
function(scarp_add_python_test name)
  cmake_parse_arguments(arg "" "" "IN;ARGUMENTS" ${ARGN})
  scarp_add_test(python.${name} python IN without-numpy ${arg_IN} NEEDS numpy posix
                 COMMAND "${SCARP_NUMPY}" -B ${bindings}/test_${name}.py ${PROJECT_SOURCE_DIR}
                 $<TARGET_FILE:scarp> ${arg_ARGUMENTS})
  if(TEST python.${name})
    set_tests_properties(python.${name} PROPERTIES ENVIRONMENT SCARP_LOADS=${loads})
  endif()
endfunction()

# The description and what is made of it are current. Other compilers than gcc and clang have other
# options.
set(compiler ${CMAKE_C_COMPILER})
if(CMAKE_C_COMPILER_TARGET)
  list(APPEND compiler --target=${CMAKE_C_COMPILER_TARGET})
endif()
if(NOT CMAKE_C_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
  scarp_add_test(python.interface python IN nobody without-numpy NEEDS python3
                 COMMAND ${Python3_EXECUTABLE} -B ${bindings}/test_interface.py
                 ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/interface ${compiler})
endif()

add_executable(bindings_hashes bindings/hashes.c)
scarp_compile_rules(bindings_hashes)
target_link_libraries(bindings_hashes PRIVATE scarp ${SCARP_LIBM})
scarp_add_python_test(hashes ARGUMENTS $<TARGET_FILE:bindings_hashes>)
scarp_add_python_test(module)
scarp_add_python_test(stubs IN nobody)
scarp_add_python_test(wheel IN thorough ARGUMENTS ${CMAKE_CURRENT_BINARY_DIR}/wheel)

# Scarp.cs, by Mono. It loads no library with instruments in it, nor one of another processor.

scarp_add_test(csharp csharp IN without-mono NEEDS mono posix python3
               COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/bindings/test_csharp.py
               ${PROJECT_SOURCE_DIR} ${SCARP_MCS} ${SCARP_MONO} $<TARGET_FILE:scarp>
               $<TARGET_FILE:bindings_hashes> ${CMAKE_CURRENT_BINARY_DIR}/csharp)

# The figures of its README: from C, and by `test_csharp.py ... overhead ...` from C#
add_executable(bindings_overhead EXCLUDE_FROM_ALL bindings/overhead.c)
scarp_compile_rules(bindings_overhead)
target_link_libraries(bindings_overhead PRIVATE scarp ${SCARP_LIBM})

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

# The extension for Godot, which a program that plays the part of Godot loads. Godot's header is not
# here: SCARP_GODOT_HEADERS is its folder.

if("godot" IN_LIST scarp_found)
  set(GODOT_HEADERS ${SCARP_GODOT_HEADERS})
  add_subdirectory(${PROJECT_SOURCE_DIR}/src/bindings/godot ${PROJECT_BINARY_DIR}/godot)
  scarp_compile_rules(scarp_godot)
  add_executable(godot_host bindings/godot_host.c)
  scarp_compile_rules(godot_host)
  target_include_directories(godot_host PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_include_directories(godot_host SYSTEM PRIVATE ${SCARP_GODOT_HEADERS})
  target_link_libraries(godot_host PRIVATE scarp ${CMAKE_DL_LIBS} ${SCARP_LIBM})
  add_dependencies(godot_host scarp_godot)
  scarp_add_test(godot bindings IN without-glslang COMMAND godot_host $<TARGET_FILE:scarp_godot>
                 ${PROJECT_SOURCE_DIR}/include/scarp.glsl)
else()
  scarp_add_test(godot bindings IN without-glslang NEEDS godot)
endif()

# The shader of its page
scarp_add_test(godot.shader shader IN without-glslang NEEDS glslang python3 scarp
               COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/bindings/test_godot_shader.py
               ${PROJECT_SOURCE_DIR} "${SCARP_GLSLANG}" ${CMAKE_CURRENT_BINARY_DIR}/godot
               ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:scarp-cli>)
