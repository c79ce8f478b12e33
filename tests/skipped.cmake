# SPDX-License-Identifier: MIT
# The last words of ctest: how many tests were skipped for want of which tools, and the packages of
# Debian that bring them. ctest runs this after its own summary:
#
#     cmake -D LOGS=<build>/Testing/Temporary -P skipped.cmake

set(packages abidiff=abigail-tools bash=bash c++=g++ cargo=cargo chromium=chromium git=git glslang=glslang-tools
    groff=groff-base mono=mono-mcs,mono-runtime nm=binutils numpy=python3-numpy objdump=binutils
    pkg-config=pkg-config python3=python3 spirv-tools=spirv-tools strace=strace valgrind=valgrind
    vulkan=libvulkan-dev,mesa-vulkan-drivers)

# While ctest runs, the log has another name; `ctest -N` begins one that is empty.
set(log ${LOGS}/LastTest.log.tmp)
if(NOT EXISTS ${log})
  set(log ${LOGS}/LastTest.log)
endif()
if(NOT EXISTS ${log})
  return()
endif()
file(STRINGS ${log} lines REGEX "^skipped: .* is missing$")
set(tools)
foreach(line IN LISTS lines)
  string(REGEX REPLACE "^skipped: (.*) is missing$" "\\1" tool "${line}")
  list(APPEND tools ${tool})
  math(EXPR count_${tool} "0${count_${tool}} + 1")
endforeach()
list(REMOVE_DUPLICATES tools)
set(counts)
set(install)
foreach(tool IN LISTS tools)
  list(APPEND counts "${tool} ${count_${tool}}")
  foreach(pair IN LISTS packages)
    string(REGEX MATCH "^(.*)=(.*)$" all ${pair})
    if(CMAKE_MATCH_1 STREQUAL tool)
      string(REPLACE "," ";" names ${CMAKE_MATCH_2})
      list(APPEND install ${names})
    endif()
  endforeach()
endforeach()
if(counts)
  list(SORT counts)
  list(JOIN counts ", " counts)
  message("Skipped for want of tools (how many tests): ${counts}")
endif()
if(install)
  list(REMOVE_DUPLICATES install)
  list(SORT install)
  list(JOIN install " " install)
  message("Most of them run after: apt-get install ${install}")
endif()
