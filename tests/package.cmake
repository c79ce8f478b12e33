# SPDX-License-Identifier: MIT
# The ways to get at the library (installed, as a subdirectory, without a build system), and what is
# in its binary: symbols and instructions. Shell scripts in package/, which read their settings from
# a file written here.

if(NOT UNIX)
  message(STATUS "The package tests need a Unix shell: left out")
  return()
endif()

find_program(SCARP_PKG_CONFIG NAMES pkg-config pkgconf)
find_program(SCARP_PYTHON NAMES python3)
mark_as_advanced(SCARP_PKG_CONFIG SCARP_PYTHON)

set(package_dir ${CMAKE_CURRENT_BINARY_DIR}/package)
set(package_settings ${package_dir}/settings-$<CONFIG>.sh)
list(JOIN CMAKE_CROSSCOMPILING_EMULATOR " " emulator)
file(GENERATE OUTPUT ${package_settings} CONTENT "# Written by package.cmake
cmake='${CMAKE_COMMAND}'
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
c_flags='${CMAKE_C_FLAGS}'
link_flags='${CMAKE_EXE_LINKER_FLAGS}'
nm='${CMAKE_NM}'
objdump='${CMAKE_OBJDUMP}'
pkg_config='${SCARP_PKG_CONFIG}'
python='${SCARP_PYTHON}'
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
")
file(GENERATE OUTPUT ${package_dir}/objects-$<CONFIG>.txt
     CONTENT "$<JOIN:$<TARGET_OBJECTS:scarp>,\n>\n")

function(scarp_add_package_test name)
  scarp_add_test(package.${name} package
    sh ${CMAKE_CURRENT_SOURCE_DIR}/package/${name}.sh ${package_settings})
  set_tests_properties(package.${name} PROPERTIES
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/package)
endfunction()

foreach(name header symbols audit direct add_subdirectory)
  scarp_add_package_test(${name})
endforeach()

# install.sh leaves a moved prefix for the others.
if(SCARP_INSTALL)
  scarp_add_package_test(install)
  set_tests_properties(package.install PROPERTIES FIXTURES_SETUP package_prefix)
  foreach(name find_package pkg_config python)
    scarp_add_package_test(${name})
    set_tests_properties(package.${name} PROPERTIES FIXTURES_REQUIRED package_prefix)
  endforeach()
endif()
