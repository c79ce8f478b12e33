# SPDX-License-Identifier: MIT
# Tests the ways to get at the library (installed, as a subdirectory, without a build system) and
# the symbols and instructions in its binary. The shell scripts in package/ read their
# settings from a file written here.

set(package_dir ${CMAKE_CURRENT_BINARY_DIR}/package)
set(package_settings ${package_dir}/settings-$<CONFIG>.sh)
list(JOIN CMAKE_CROSSCOMPILING_EMULATOR " " emulator)
file(GENERATE OUTPUT ${package_settings} CONTENT "# Written by package.cmake
cmake='${CMAKE_COMMAND}'
ctest='${CMAKE_CTEST_COMMAND}'
cpack='${CMAKE_CPACK_COMMAND}'
abidiff='${SCARP_ABIDIFF}'
abidw='${SCARP_ABIDW}'
install_prefix='${CMAKE_INSTALL_PREFIX}'
generator='${CMAKE_GENERATOR}'
make_program='${CMAKE_MAKE_PROGRAM}'
toolchain='${CMAKE_TOOLCHAIN_FILE}'
cross='$<BOOL:${CMAKE_CROSSCOMPILING}>'
emulator='${emulator}'
processor='${CMAKE_SYSTEM_PROCESSOR}'
system='${CMAKE_SYSTEM_NAME}'
pointer_size='${CMAKE_SIZEOF_VOID_P}'
config='$<CONFIG>'
c_compiler='${CMAKE_C_COMPILER}'
c_compiler_id='${CMAKE_C_COMPILER_ID}'
cxx_compiler='${SCARP_CXX}'
c_flags='${CMAKE_C_FLAGS}'
sets='${SCARP_SETS}'
thorough='$<$<BOOL:${SCARP_TEST_THOROUGH}>:ON>'
werror='$<$<BOOL:${SCARP_WERROR}>:-Werror>'
link_flags='${CMAKE_EXE_LINKER_FLAGS}'
nm='${CMAKE_NM}'
objdump='${CMAKE_OBJDUMP}'
pkg_config='${SCARP_PKG_CONFIG}'
python='${Python3_EXECUTABLE}'
version='${PROJECT_VERSION}'
source_dir='${PROJECT_SOURCE_DIR}'
build_dir='${PROJECT_BINARY_DIR}'
scratch='${package_dir}/$<CONFIG>'
libdir='${CMAKE_INSTALL_LIBDIR}'
includedir='${CMAKE_INSTALL_INCLUDEDIR}'
library='$<TARGET_FILE:scarp>'
library_name='$<TARGET_FILE_NAME:scarp>'
library_type='$<TARGET_PROPERTY:scarp,TYPE>'
objects='${package_dir}/objects-$<CONFIG>.txt'
abi='${SCARP_ABI}'
map='${SCARP_MAP}'
unfused_objects='${package_dir}/unfused-$<CONFIG>.txt'
")
file(GENERATE OUTPUT ${package_dir}/objects-$<CONFIG>.txt
     CONTENT "$<JOIN:$<TARGET_OBJECTS:scarp>,\n>\n")

# The kernels whose vf_exact_fma is fused, as the library has them but for that operation.
if(SCARP_TEST_THOROUGH)
  set(unfused_sources ${scarp_sources})
  list(FILTER unfused_sources INCLUDE REGEX "kernels_(avx2|avx512|neon)")
  list(TRANSFORM unfused_sources PREPEND ${PROJECT_SOURCE_DIR}/)
  add_library(scarp_unfused OBJECT ${unfused_sources})
  scarp_compile_rules(scarp_unfused)
  scarp_library_rules(scarp_unfused)
  target_compile_definitions(scarp_unfused PRIVATE VEC_UNFUSED)
  if(CMAKE_C_FLAGS MATCHES "-fsanitize")
    target_compile_options(scarp_unfused PRIVATE -fno-sanitize=all) # nobody runs it
  endif()
  file(GENERATE OUTPUT ${package_dir}/unfused-$<CONFIG>.txt
       CONTENT "$<JOIN:$<TARGET_OBJECTS:scarp_unfused>,\n>\n")
endif()

# scarp_add_package_test(SCRIPT [CXX] [SETUP fixture] [AFTER fixture] [IN leg...] [NEEDS tool...]):
# package/SCRIPT.sh as the test package.SCRIPT, or package.SCRIPT.cxx where the consumer is in C++
function(scarp_add_package_test script)
  cmake_parse_arguments(arg "CXX" "SETUP;AFTER" "IN;NEEDS" ${ARGN})
  set(name package.${script})
  set(language C)
  if(arg_CXX)
    string(APPEND name .cxx)
    set(language CXX)
    list(APPEND arg_NEEDS c++)
  endif()
  scarp_add_test(${name} package IN nobody ${arg_IN} NEEDS posix sh ${arg_NEEDS}
                 COMMAND sh ${script}.sh ${package_settings} ${language})
  if(TEST ${name})
    set_tests_properties(${name} PROPERTIES
      WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/package
      FIXTURES_SETUP "${arg_SETUP}" FIXTURES_REQUIRED "${arg_AFTER}")
  endif()
endfunction()

scarp_add_package_test(tools IN ${long})
scarp_add_package_test(duration IN without-nm)
scarp_add_package_test(sets IN thorough)
scarp_add_package_test(header IN without-bash without-c++ without-nm without-python3)
scarp_add_package_test(header CXX IN without-c++)
scarp_add_package_test(cpp CXX IN thorough)
scarp_add_package_test(symbols IN without-abidiff without-nm without-objdump without-python3 NEEDS nm objdump)
scarp_add_package_test(audit IN without-objdump NEEDS objdump)
scarp_add_package_test(unfused IN thorough NEEDS objdump)
scarp_add_package_test(direct IN thorough)
scarp_add_package_test(versions)

# The library is compiled once for both.
scarp_add_package_test(add_subdirectory SETUP package_subproject IN thorough)
scarp_add_package_test(add_subdirectory CXX AFTER package_subproject IN thorough)

# install.sh leaves a moved prefix for the others.
scarp_add_package_test(install SETUP package_prefix IN without-bash without-c++ without-pkg-config
                       NEEDS scarp-install)
scarp_add_package_test(find_package AFTER package_prefix IN without-c++ without-pkg-config
                       NEEDS scarp-install)
scarp_add_package_test(find_package CXX AFTER package_prefix IN without-c++ without-pkg-config
                       NEEDS scarp-install)
scarp_add_package_test(pkg_config AFTER package_prefix IN without-c++ without-pkg-config
                       NEEDS scarp-install pkg-config)
scarp_add_package_test(pkg_config CXX AFTER package_prefix IN without-c++ without-pkg-config
                       NEEDS scarp-install pkg-config)
scarp_add_package_test(linking AFTER package_prefix NEEDS scarp-install pkg-config)
scarp_add_package_test(python AFTER package_prefix NEEDS scarp-install python3)

# The other forms in which it is given away
scarp_add_package_test(single IN thorough)
scarp_add_package_test(exact IN thorough)
scarp_add_package_test(archive IN thorough NEEDS scarp-install)
scarp_add_package_test(abi IN without-abidiff NEEDS abidiff)
scarp_add_package_test(ports IN without-git NEEDS python3)

# What a release is made by. Its parts that compile the library are tried at the release: cmake/release.md.
scarp_add_test(package.release package IN nobody thorough NEEDS bash git linux python3
               COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/test_release.py
               ${PROJECT_SOURCE_DIR} ${package_dir}/release ${CMAKE_C_COMPILER})
