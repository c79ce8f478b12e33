# SPDX-License-Identifier: MIT
# Makes the pictures of the gallery again: runs the commands that the documents show, and copies
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

# A command makes a picture that it names, or STEM-....png after --output STEM.
string(REGEX MATCHALL "gallery/[a-z-]+\\.png" pictures "${text}")
list(TRANSFORM pictures REPLACE "gallery/" "")
list(REMOVE_DUPLICATES pictures)
string(REGEX MATCHALL "\nscarp [^\n`;]*" commands "${text}")

set(count 0)
foreach(picture IN LISTS pictures)
  string(REGEX REPLACE "-[a-z]+\\.png$" "" stem ${picture})
  set(found ${commands})
  list(FILTER found INCLUDE REGEX " (--output ${stem}|${picture})( |$)")
  if(found)
    list(GET found -1 command)
    string(STRIP "${command}" command)
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
  else()
    message("No command makes ${picture}")
  endif()
endforeach()
message("${count} pictures are in ${GALLERY}")
