# SPDX-License-Identifier: MIT
# Writes MANUAL, the man page, from TEMPLATE and the help of PROGRAM (a list: it may begin with an
# emulator). `cmake --build build --target manual` calls this; a test calls it too, and compares.

cmake_minimum_required(VERSION 3.25)

# The help of a command as roff: its escapes, and no line that begins like a request
function(help_of command result)
  execute_process(COMMAND ${PROGRAM} help ${command} OUTPUT_VARIABLE text
                  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\\" "\\e" text "${text}")
  string(REPLACE "-" "\\-" text "${text}")
  string(REPLACE "\n." "\n\\&." text "${text}")
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

execute_process(COMMAND ${PROGRAM} --version OUTPUT_VARIABLE VERSION
                OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "scarp " "" VERSION "${VERSION}")
help_of(terrain TERRAIN)
help_of(view VIEW)
help_of(sheet SHEET)
help_of(sample SAMPLE)
help_of(recipe RECIPE)
configure_file(${TEMPLATE} ${MANUAL} @ONLY NEWLINE_STYLE UNIX)
