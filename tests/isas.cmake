# SPDX-License-Identifier: MIT
# The kernel sets that this build contains, as src/dispatch/isas.h decides for its compiler and flags
function(scarp_find_isas)
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/isas.c "#include \"isas.h\"
#define SCARP_NAMED(ISA, table, name, here) SCARP_WHERE(here, isa: name;)
SCARP_ISA_LIST(SCARP_NAMED)\n")
  set(target)
  if(CMAKE_C_COMPILER_TARGET)
    set(target --target=${CMAKE_C_COMPILER_TARGET})
  endif()
  separate_arguments(flags NATIVE_COMMAND "${CMAKE_C_FLAGS}")
  list(TRANSFORM SCARP_SET_DEFINITIONS PREPEND -D OUTPUT_VARIABLE definitions)
  execute_process(COMMAND ${CMAKE_C_COMPILER} ${target} ${flags} ${definitions} -I ${PROJECT_SOURCE_DIR}/src/dispatch -E isas.c
                  WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} OUTPUT_VARIABLE text
                  COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "isa: *\"[a-z0-9.]+\"" isas "${text}")
  list(TRANSFORM isas REPLACE "isa: *\"(.*)\"" "\\1")
  if(NOT isas)
    message(FATAL_ERROR "${CMAKE_C_COMPILER} does not tell which kernel sets it compiles: ${text}")
  endif()
  set(isas ${isas} PARENT_SCOPE)
endfunction()
