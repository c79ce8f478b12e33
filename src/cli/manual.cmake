# SPDX-License-Identifier: MIT
# Writes MANUAL, the man page, from TEMPLATE, VERSION and the help of PROGRAM (a list: it may begin with
# an emulator; empty: a program that cannot run here).

cmake_minimum_required(VERSION 3.25)

foreach(command terrain view sheet sample recipe)
  set(text "The options are in the help: scarp help ${command}")
  if(PROGRAM)
    execute_process(COMMAND ${PROGRAM} help ${command} OUTPUT_VARIABLE text
                    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  endif()
  # As roff: its escapes, and no line that begins like a request
  string(REPLACE "\\" "\\e" text "${text}")
  string(REPLACE "-" "\\-" text "${text}")
  string(REPLACE "\n." "\n\\&." text "${text}")
  string(TOUPPER ${command} name)
  set(${name} "${text}")
endforeach()
configure_file(${TEMPLATE} ${MANUAL} @ONLY NEWLINE_STYLE UNIX)
