# SPDX-License-Identifier: MIT
# Copies the library's sources with every mistake of list.cmake in them, each behind a switch of its
# own, so that one compilation serves all of them; and writes mutants.c, the table of these switches.
# If the text of a mistake is not found exactly once, the programs that have to see it fail. Without TO
# it writes nothing, and fails itself.
#
#   cmake -D FROM=src [-D TO=folder] -P mutate.cmake

cmake_minimum_required(VERSION 3.25)

set(number 0)
set(problems)
file(GLOB_RECURSE FILES RELATIVE ${FROM} ${FROM}/*.c ${FROM}/*.h ${FROM}/*.def)
list(FILTER FILES EXCLUDE REGEX "^cli/")
foreach(file IN LISTS FILES)
  file(READ ${FROM}/${file} "original_${file}")
  set("mutated_${file}" "${original_${file}}")
endforeach()

# How often `text` is in `content`, at most 2.
function(count_text content text result)
  string(FIND "${content}" "${text}" first)
  string(FIND "${content}" "${text}" last REVERSE)
  set(count 2)
  if(first EQUAL -1)
    set(count 0)
  elseif(first EQUAL last)
    set(count 1)
  endif()
  set(${result} ${count} PARENT_SCOPE)
endfunction()

function(mutant name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TEXT;BECOMES;SEEN_BY" "IN;SETS")
  math(EXPR number "${number} + 1")
  set(found 0)
  set(where)
  foreach(file IN LISTS FILES)
    foreach(part IN LISTS arg_IN)
      string(FIND "${file}/" "${part}/" at)
      if(at EQUAL 0)
        count_text("${original_${file}}" "${arg_TEXT}" here)
        math(EXPR found "${found} + ${here}")
        if(here EQUAL 1)
          set(where ${file})
        endif()
      endif()
    endforeach()
  endforeach()
  set(problem)
  if(found EQUAL 1)
    string(REPLACE "MUTANT" "scarp_mutant[${number}]" text "${arg_BECOMES}")
    string(REPLACE "${arg_TEXT}" "${text}" content "${mutated_${where}}")
    if(content STREQUAL "${mutated_${where}}")
      set(problem "another mutant has taken its text away")
    endif()
    set("mutated_${where}" "${content}" PARENT_SCOPE)
  elseif(found EQUAL 0)
    set(problem "its text is not found")
  else()
    set(problem "its text is found more than once")
  endif()
  if(problem)
    set(problems "${problems}${name}: ${problem}\n" PARENT_SCOPE)
  endif()
  if(NOT arg_SETS)
    set(arg_SETS sse4.1 avx2 avx512 neon wasm128 generic)
  endif()
  string(REPLACE ";" "," sets "${arg_SETS}")
  string(APPEND table "    {\"${name}\", \"${problem}\", \"${arg_SEEN_BY}\", \"${sets}\"},\n")
  set(table "${table}" PARENT_SCOPE)
  set(number ${number} PARENT_SCOPE)
endfunction()

include(${CMAKE_CURRENT_LIST_DIR}/list.cmake)
if(NOT TO)
  if(problems)
    message(FATAL_ERROR "${CMAKE_CURRENT_LIST_DIR}/list.cmake does not fit the sources:\n${problems}")
  endif()
  message("${number} mistakes, each with its text")
  return()
endif()

foreach(file IN LISTS FILES)
  set(content "${mutated_${file}}")
  if(NOT content STREQUAL "${original_${file}}")
    string(PREPEND content "extern int scarp_mutant[];\n")
  endif()
  file(WRITE ${TO}/${file} "${content}")
endforeach()
file(WRITE ${TO}/mutants.c "/* Written by mutate.cmake. */
#include \"mutants.h\"

int scarp_mutant[${number} + 1];
const int scarp_mutant_count = ${number};
const struct mutant scarp_mutants[] = {
${table}};
")
