# SPDX-License-Identifier: MIT
# Copies the library's sources with every mistake of list.cmake in them, each behind a condition of
# its own, so that one compilation serves all of them; and writes mutants.c, which switches on the
# one that SCARP_MUTANT in the environment names. If the text of a mistake is not found exactly
# once, the programs that are asked for that mistake fail.
#
#   cmake -D FROM=src -D TO=folder -D FILES=a.c;kernel/b.h -P mutate.cmake

cmake_minimum_required(VERSION 3.25)

set(number 0)
foreach(file IN LISTS FILES)
  file(READ ${FROM}/${file} "original_${file}")
  set("mutated_${file}" "${original_${file}}")
endforeach()

# How often `text` stands in `content`, at most 2.
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
  string(APPEND table "    {\"${name}\", \"${problem}\"},\n")
  set(table "${table}" PARENT_SCOPE)
  set(number ${number} PARENT_SCOPE)
endfunction()

include(${CMAKE_CURRENT_LIST_DIR}/list.cmake)

foreach(file IN LISTS FILES)
  set(content "${mutated_${file}}")
  if(NOT content STREQUAL "${original_${file}}")
    string(PREPEND content "extern int scarp_mutant[];\n")
  endif()
  file(WRITE ${TO}/${file} "${content}")
endforeach()
file(WRITE ${TO}/mutants.c "/* Written by mutate.cmake. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern int scarp_mutant[];
int scarp_mutant[${number} + 1]; /* from 1 on; 1 for the one that is switched on */

static const struct {
    const char *name, *problem;
} mutants[] = {
${table}};

/* Before main, so that test programs need not know. */
__attribute__((constructor)) static void switch_on(void)
{
    const char *const name = getenv(\"SCARP_MUTANT\");
    const int count = (int)(sizeof mutants / sizeof mutants[0]);
    int i = 0;
    if (name == NULL) {
        return;
    }
    while (i < count && strcmp(mutants[i].name, name) != 0) {
        i++;
    }
    const char *const problem = i < count ? mutants[i].problem : \"it does not exist\";
    if (*problem != '\\0') {
        printf(\"mutant %s: %s\\n\", name, problem);
        exit(EXIT_FAILURE);
    }
    scarp_mutant[i + 1] = 1;
}
")
