# SPDX-License-Identifier: MIT
# The library as one file (`cmake --build build --target single`), and packages (`--target package`, or
# cpack in the build directory).
#
# An archive, .tar.gz, has everything, and may be unpacked anywhere. Where the prefix is /usr, packages
# for Debian are made instead, which need dpkg-dev and `file`:
#
#   libscarp0.2    the shared library; the number is that of the SONAME
#   libscarp-dev   headers (C, C++20), shaders, Scarp.cs, and what find_package and pkg-config read
#   scarp          the program, its man page and its completion
#   python3-scarp  the module for Python (python.cmake), where the library is shared

set(single ${PROJECT_BINARY_DIR}/single)
file(GLOB_RECURSE single_sources CONFIGURE_DEPENDS
     ${PROJECT_SOURCE_DIR}/src/*.h ${PROJECT_SOURCE_DIR}/src/*.c ${PROJECT_SOURCE_DIR}/src/*.def)
list(FILTER single_sources EXCLUDE REGEX "/src/(cli|gpu|web)/")
add_custom_command(OUTPUT ${single}/scarp_single.c ${single}/scarp.h
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D OUTPUT=${single}
          -D VERSION=${PROJECT_VERSION} -P ${PROJECT_SOURCE_DIR}/cmake/single.cmake
  DEPENDS ${single_sources} ${PROJECT_SOURCE_DIR}/include/scarp.h ${PROJECT_SOURCE_DIR}/LICENSE
          ${PROJECT_SOURCE_DIR}/cmake/single.cmake ${PROJECT_SOURCE_DIR}/cmake/single.c.in
  COMMENT "Writing the library as one file"
  VERBATIM)
add_custom_target(single DEPENDS ${single}/scarp_single.c ${single}/scarp.h)

# In the archive alone: the single file, which is made when cpack installs it, and texts.
install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" -D \"SOURCE=${PROJECT_SOURCE_DIR}\"
  -D \"OUTPUT=${single}\" -D VERSION=${PROJECT_VERSION} -P \"${PROJECT_SOURCE_DIR}/cmake/single.cmake\"
  COMMAND_ERROR_IS_FATAL ANY)" COMPONENT archive EXCLUDE_FROM_ALL)
install(FILES ${single}/scarp_single.c ${single}/scarp.h
  DESTINATION ${CMAKE_INSTALL_DATADIR}/scarp COMPONENT archive EXCLUDE_FROM_ALL)
install(FILES LICENSE README.md CHANGELOG.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT archive EXCLUDE_FROM_ALL)

get_target_property(type scarp TYPE)
set(CPACK_COMPONENTS_ALL development)
if(type STREQUAL "SHARED_LIBRARY")
  list(PREPEND CPACK_COMPONENTS_ALL library)
endif()
if(TARGET scarp-cli)
  list(APPEND CPACK_COMPONENTS_ALL program)
endif()
set(CPACK_PACKAGE_VENDOR "the scarp authors")
set(CPACK_PACKAGE_CONTACT "the scarp authors <scarp@example.org>" CACHE STRING
    "Whom the packages name as their maintainer")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_IGNORE_FILES "/build[^/]*/" "/[.]git/" "/rust/target/")
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)

if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  list(APPEND CPACK_COMPONENTS_ALL archive)
  set(CPACK_GENERATOR TGZ)
  set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
  string(TOLOWER "${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}" system)
  set(CPACK_SYSTEM_NAME ${system})
  set(CPACK_PACKAGE_FILE_NAME scarp-${PROJECT_VERSION}-${system})
else()
  if(type STREQUAL "SHARED_LIBRARY")
    list(APPEND CPACK_COMPONENTS_ALL python)
  endif()
  include(cmake/packaging/debian.cmake)
endif()
include(CPack)
