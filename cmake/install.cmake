# SPDX-License-Identifier: MIT
# Installs the headers and the shaders, the library, and what find_package(scarp) and pkg-config need.
# (The program installs itself: src/cli.) Nothing installed names a directory of the build: the prefix
# may be moved, unless the user chose absolute directories.

include(CMakePackageConfigHelpers)

install(TARGETS scarp EXPORT scarp
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT library
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(FILES include/scarp.h include/scarp.hpp include/scarp.glsl include/scarp.hlsl include/scarp.wgsl
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)

# C#: a file for a program's own sources, and what Unity wants beside it. A project that installs scarp
# as a part of itself has no use for them.
if(PROJECT_IS_TOP_LEVEL)
  set(csharp ${PROJECT_SOURCE_DIR}/src/bindings/csharp)
  install(FILES ${csharp}/Scarp.cs ${csharp}/unity/Scarp.asmdef ${csharp}/unity/TerrainSample.cs
    DESTINATION ${CMAKE_INSTALL_DATADIR}/scarp/csharp COMPONENT development)
endif()

# find_package(scarp). While the major version is 0, every minor version may change the interface.
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(compatibility SameMinorVersion)
else()
  set(compatibility SameMajorVersion)
endif()
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/scarp)
configure_package_config_file(cmake/scarpConfig.cmake.in scarpConfig.cmake
  INSTALL_DESTINATION ${package_dir}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(scarpConfigVersion.cmake COMPATIBILITY ${compatibility})
install(EXPORT scarp NAMESPACE scarp:: FILE scarpTargets.cmake DESTINATION ${package_dir}
  COMPONENT development)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/scarpConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/scarpConfigVersion.cmake
        DESTINATION ${package_dir} COMPONENT development)

# pkg-config. The prefix is found from the place of scarp.pc itself; an absolute library directory
# may lie anywhere, so there the prefix is the configured one. So it is in /usr, which does not move:
# pkg-config leaves out the system's directories if they have no .. in them.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(pc_prefix "${CMAKE_INSTALL_PREFIX}")
  set(pc_libdir "${CMAKE_INSTALL_LIBDIR}")
elseif(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(pc_prefix /usr)
  set(pc_libdir "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
else()
  file(RELATIVE_PATH up "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" /prefix)
  string(REGEX REPLACE "/$" "" up "${up}")
  set(pc_prefix "\${pcfiledir}/${up}")
  set(pc_libdir "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
endif()
if(IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
  set(pc_includedir "${CMAKE_INSTALL_INCLUDEDIR}")
else()
  set(pc_includedir "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()
# A static library needs libm (clang calls floor), and programs that link it ask for no more than
# `pkg-config --libs`. A shared one brings it.
set(pc_libs)
set(pc_libs_private)
get_target_property(type scarp TYPE)
if(SCARP_LIBM AND type STREQUAL "SHARED_LIBRARY")
  set(pc_libs_private -lm)
elseif(SCARP_LIBM)
  set(pc_libs " -lm")
endif()
configure_file(cmake/scarp.pc.in scarp.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/scarp.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
