# SPDX-License-Identifier: MIT
# Lets programs by Microsoft's compiler link the DLL: writes scarp.def, which lists what it exports,
# and scarp.lib, the import library made of that, and installs both. (gcc and clang for mingw link
# libscarp.dll.a.) A consumer defines SCARP_SHARED. Linked by lld-link here, never by Microsoft's own
# linker.

find_program(SCARP_DLLTOOL NAMES llvm-dlltool-19 llvm-dlltool ${CMAKE_DLLTOOL}
             x86_64-w64-mingw32-dlltool)
mark_as_advanced(SCARP_DLLTOOL)
set(exports ${PROJECT_BINARY_DIR}/lib/scarp.def)
set(import_library ${PROJECT_BINARY_DIR}/lib/scarp.lib)
target_link_options(scarp PRIVATE -Wl,--output-def,${exports})
if(SCARP_DLLTOOL AND CMAKE_SIZEOF_VOID_P EQUAL 8)
  add_custom_command(TARGET scarp POST_BUILD
    COMMAND ${SCARP_DLLTOOL} -m i386:x86-64 -d ${exports} -D $<TARGET_FILE_NAME:scarp>
            -l ${import_library}
    BYPRODUCTS ${exports} ${import_library}
    VERBATIM)
  if(SCARP_INSTALL)
    install(FILES ${exports} ${import_library} DESTINATION ${CMAKE_INSTALL_LIBDIR}
            COMPONENT development)
  endif()
else()
  message(STATUS "No scarp.lib for Microsoft's linker: no dlltool found")
endif()
