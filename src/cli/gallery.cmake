# SPDX-License-Identifier: MIT
# Makes the pictures of the gallery again: runs the commands that the documents tell, and copies
# what they show of them. `cmake --build build --target gallery` calls this with PROGRAM (scarp),
# DOCUMENTS (the list of them), SCRATCH (a directory to work in) and GALLERY (where the pictures go).
#
# A test compares the committed pictures with what the commands make, sample by sample.

cmake_minimum_required(VERSION 3.25)
set(text "")
foreach(document IN LISTS DOCUMENTS)
  file(READ ${document} part)
  string(APPEND text "${part}")
endforeach()
string(REPLACE "\\\n" "" text "${text}")
file(MAKE_DIRECTORY ${SCRATCH})

set(count 0)
string(REGEX MATCHALL "scarp terrain [^\n`;]*--output [a-z-]+" commands "${text}")
foreach(command IN LISTS commands)
  string(REGEX REPLACE ".* " "" stem "${command}")
  if(text MATCHES "gallery/(${stem}-(hillshade|compare)\\.png)")
    set(picture ${CMAKE_MATCH_1})
    separate_arguments(words UNIX_COMMAND "${command}")
    list(POP_FRONT words)
    file(REMOVE ${SCRATCH}/${picture})
    execute_process(COMMAND ${PROGRAM} ${words} WORKING_DIRECTORY ${SCRATCH}
                    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    if(NOT EXISTS ${SCRATCH}/${picture})
      message(FATAL_ERROR "There is no ${picture}: the program was built without zlib")
    endif()
    file(COPY ${SCRATCH}/${picture} DESTINATION ${GALLERY})
    math(EXPR count "${count} + 1")
  endif()
endforeach()
message("${count} pictures are in ${GALLERY}")
