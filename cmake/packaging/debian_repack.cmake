# SPDX-License-Identifier: MIT
# Run by cpack after it made the packages: dpkg-deb makes them again, so that the same files give the
# same bytes. cpack counts the sizes of folders, too, which differ between file systems, and gives folders
# the permissions that the umask leaves.
cmake_minimum_required(VERSION 3.25)

set(ENV{DPKG_DEB_THREADS_MAX} 1) # how many there are would show in the compressed bytes
list(FILTER CPACK_PACKAGE_FILES INCLUDE REGEX "[.]deb$") # `cpack -G TGZ` makes others
foreach(package IN LISTS CPACK_PACKAGE_FILES)
  set(root ${package}.root)
  file(REMOVE_RECURSE ${root})
  execute_process(COMMAND dpkg-deb --raw-extract ${package} ${root} COMMAND_ERROR_IS_FATAL ANY)

  # Debian's Installed-Size: KiB of each file, rounded up, and 1 for everything else.
  file(GLOB_RECURSE names LIST_DIRECTORIES ON RELATIVE ${root} ${root}/*)
  set(folders ${root})
  set(installed 0)
  foreach(name IN LISTS names)
    set(kib 1)
    if(IS_DIRECTORY ${root}/${name} AND NOT IS_SYMLINK ${root}/${name})
      list(APPEND folders ${root}/${name})
    elseif(NOT IS_SYMLINK ${root}/${name})
      file(SIZE ${root}/${name} bytes)
      math(EXPR kib "(${bytes} + 1023) / 1024")
    endif()
    if(NOT name MATCHES "^DEBIAN(/|$)")
      math(EXPR installed "${installed} + ${kib}")
    endif()
  endforeach()
  file(CHMOD ${folders} DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
       GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  file(READ ${root}/DEBIAN/control control)
  string(REGEX REPLACE "(^|\n)Installed-Size: [0-9]+\n" "\\1Installed-Size: ${installed}\n" control "${control}")
  file(WRITE ${root}/DEBIAN/control "${control}")

  execute_process(COMMAND dpkg-deb --root-owner-group -Zxz --build ${root} ${package}
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE_RECURSE ${root})
endforeach()
