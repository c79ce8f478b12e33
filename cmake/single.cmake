# SPDX-License-Identifier: MIT
# Writes the library as one file, scarp_single.c, and copies scarp.h beside it:
#
#   cmake -D SOURCE=<source tree> -D OUTPUT=<directory> -D VERSION=<version> -P single.cmake
#
# Headers that files share come first, as they are. Every other file is a section of its own: names
# that it declares get a suffix, by macros which are taken back at its end, like the macros that it
# defines. The kernels stand there once; the file includes itself for each set, in its target region.
# SCARP_PART is the part that such an inclusion asks for.
#
# The script finds the names that a file declares by its format: outside of functions, names start at
# the margin. It finds headers and simd/kernels_*.c by itself. If it misses a name, the file does not
# compile, and package.single says so.
cmake_minimum_required(VERSION 3.25)

get_filename_component(SOURCE ${SOURCE} ABSOLUTE)
set(src ${SOURCE}/src)

# Headers and tables that stand at several places, and the parts that they are
set(part_vec_types 1)
set(part_vec 2)
set(part_table 3)
set(part_names 4) # gives the names of the kernels their suffixes
set(part_end 5)   # takes that, and the macros of the kernels, back
set(part_functions 6)

# Appends the text of an inclusion of a part to `variable`.
function(include_part variable part)
  string(APPEND ${variable}
         "\n#undef SCARP_PART\n#define SCARP_PART ${part}\n#include SCARP_SINGLE\n")
  set(${variable} "${${variable}}" PARENT_SCOPE)
endfunction()

# Reads a file, without the licence, which stands at the top of the whole.
function(read_source path variable)
  file(READ ${path} text)
  string(REGEX REPLACE "^/\\* SPDX-License-Identifier: MIT\n \\*\n" "/*\n" text "${text}")
  set(${variable} "\n${text}" PARENT_SCOPE)
endfunction()

# expand(FILE VARIABLE SHARED): the text of FILE, with the headers that it includes in their places if
# they come for the first time. If SHARED, headers that files share are among them; else they, and
# scarp.h, are left out, since they stand in front.
function(expand path variable shared)
  read_source(${path} text)
  get_filename_component(folder ${path} DIRECTORY)
  set(result "")
  while(text MATCHES "\n#include \"[^\n]*\"\n")
    set(line "${CMAKE_MATCH_0}")
    string(FIND "${text}" "${line}" at)
    string(SUBSTRING "${text}" 0 ${at} before)
    string(LENGTH "${line}" length)
    math(EXPR after "${at} + ${length} - 1")
    string(SUBSTRING "${text}" ${after} -1 text)
    string(APPEND result "${before}")
    string(REGEX REPLACE ".*\"(.*)\".*" "\\1" name "${line}")
    get_filename_component(header ${folder}/${name} ABSOLUTE)
    get_filename_component(stem ${header} NAME_WE)
    get_filename_component(home ${header} DIRECTORY)
    if(DEFINED part_${stem} AND (home STREQUAL "${src}/simd" OR name MATCHES "[.]def$"))
      include_part(result ${part_${stem}})
      continue()
    endif()
    is_shared(${header} here)
    get_property(seen GLOBAL PROPERTY seen)
    if(name STREQUAL "scarp.h" OR name STREQUAL "body.h" OR header IN_LIST seen
       OR (here AND NOT shared))
      continue()
    endif()
    set_property(GLOBAL APPEND PROPERTY seen ${header})
    expand(${header} inner ${shared})
    string(APPEND result "\n/* --- ${name} --- */\n${inner}")
  endwhile()
  set(${variable} "${result}${text}" PARENT_SCOPE)
endfunction()

# Whether files of several sections include a header, so that its names must stay.
function(is_shared header variable)
  get_filename_component(folder ${header} DIRECTORY)
  set(shared OFF)
  if(folder MATCHES "^${src}/(calls|plan|dispatch|recipe)$" OR header STREQUAL "${src}/simd/lookup.h")
    set(shared ON)
  endif()
  set(${variable} ${shared} PARENT_SCOPE)
endfunction()

# names_of(TEXT VARIABLE MACROS): what a text declares outside of functions, and the macros that it
# defines. The sources are formatted: what is outside of functions starts at the margin.
function(names_of text variable macros)
  string(REPLACE "\\\n" " " text "${text}")
  string(REGEX MATCHALL "\n *# *define +[A-Za-z_0-9]+" found "${text}")
  string(REGEX REPLACE "\n *# *define +" "" found "${found}")
  list(REMOVE_DUPLICATES found)
  set(${macros} "${found}" PARENT_SCOPE)

  string(REGEX REPLACE " *__attribute__\\(\\(([a-z_, ]|\\([^()]*\\))*\\)\\)" "" plain "${text}")
  string(REGEX REPLACE "/\\*[^*]*\\*/" "" plain "${plain}") # those of enumerators
  string(REGEX REPLACE "[][]" "?" plain "${plain}")         # brackets and semicolons mean something
  string(REPLACE ";" "@" plain "${plain}")                  # in lists
  set(names "")
  # Functions, arrays and constants: the name before the first of ( = [
  set(types "static|const|enum|struct|void|float|double|int|size_t|[A-Z]+_INLINE")
  string(REGEX MATCHALL "\n(${types})[^\n(=?@{]*[ *][A-Za-z_0-9]+ *[(=?]" found "${plain}")
  list(APPEND names ${found})
  string(REGEX MATCHALL "\n[a-z_0-9]+\\(" found "${plain}") # behind a line with its type
  list(APPEND names ${found})
  list(TRANSFORM names REPLACE " *[(=?]$" "")
  list(TRANSFORM names REPLACE "^.*[ *\n]" "")
  # Pointers to functions
  string(REGEX MATCHALL "\n(static|const)[^\n(=@{]*\\(\\*(const )?[a-z_0-9]+" found "${plain}")
  list(TRANSFORM found REPLACE "^.*[ *]" "")
  list(APPEND names ${found})
  # Types
  string(REGEX MATCHALL "\n(struct|union|enum) [a-z_0-9]+ {" found "${plain}")
  list(TRANSFORM found REPLACE "^\n[a-z]+ (.*) {$" "\\1")
  list(APPEND names ${found})
  string(REGEX MATCHALL "\n(typedef [^\n@({]*[ *]|} )[a-z_0-9]+[@(]" found "${plain}")
  list(TRANSFORM found REPLACE "^.*[ *](.*)[@(]$" "\\1")
  list(APPEND names ${found})
  # Enumerators
  string(REGEX MATCHALL "\nenum [a-z_0-9 ]*{[^}]*}" enums "${plain}")
  foreach(body IN LISTS enums)
    string(REGEX REPLACE "=[^,}]*" "" body "${body}") # values, which may use other names
    string(REGEX MATCHALL "[A-Z][A-Z_0-9]+" found "${body}")
    list(APPEND names ${found})
  endforeach()
  # Functions that macros declare: by an argument that is a name, or by names made of arguments
  string(REGEX MATCHALL "\n[A-Z_0-9]+\\([a-z][a-z_0-9]*," found "${plain}")
  list(TRANSFORM found REPLACE "^.*\\((.*),$" "\\1")
  list(APPEND names ${found})
  pasted_names("${plain}" found)
  list(APPEND names ${found})
  list(REMOVE_DUPLICATES names)
  set(${variable} "${names}" PARENT_SCOPE)
endfunction()

# The names that invocations of macros at the margin make with ##.
function(pasted_names text variable)
  set(names "")
  string(REGEX MATCHALL "\n#define [A-Z_0-9]+\\([^()]*\\)[^\n]*##[^\n]*" macros "${text}")
  foreach(macro IN LISTS macros)
    string(REGEX MATCH "^\n#define ([A-Z_0-9]+)\\(([^()]*)\\)(.*)$" all "${macro}")
    set(name "${CMAKE_MATCH_1}")
    set(parameters "${CMAKE_MATCH_2}")
    set(body "${CMAKE_MATCH_3}")
    string(REGEX REPLACE ", *" ";" parameters "${parameters}")
    string(REGEX MATCHALL "[A-Za-z_0-9]+(##[A-Za-z_0-9]+)+" pastes "${body}")
    string(REGEX MATCHALL "\n${name}\\([^()\n]*\\)" calls "${text}")
    foreach(call IN LISTS calls)
      string(REGEX REPLACE "^.*\\((.*)\\)$" "\\1" arguments "${call}")
      string(REGEX REPLACE ", *" ";" arguments "${arguments}")
      foreach(paste IN LISTS pastes)
        string(REPLACE "##" ";" pieces "${paste}")
        set(whole "")
        foreach(piece IN LISTS pieces)
          list(FIND parameters ${piece} at)
          if(at GREATER_EQUAL 0)
            list(GET arguments ${at} piece)
          endif()
          string(APPEND whole ${piece})
        endforeach()
        list(APPEND names ${whole})
      endforeach()
    endforeach()
  endforeach()
  set(${variable} "${names}" PARENT_SCOPE)
endfunction()

# renamed(NAMES TEXTS text... WITHOUT macro...): keeps of the names of a section those that get a suffix.
# Where a structure that files share has a member of that name, a macro would rename the member, too:
# there the name as a type, a function and an initialiser gets a _ in the texts.
function(renamed variable)
  cmake_parse_arguments(arg "" "" "TEXTS;WITHOUT" ${ARGN})
  set(names ${${variable}})
  list(FILTER names EXCLUDE REGEX "^(scarpi?_|SCARP_|_Static_assert$|void$)")
  list(REMOVE_ITEM names ${shared_names} ${shared_macros} ${arg_WITHOUT})
  list(SORT names)
  set(result "")
  foreach(name IN LISTS names)
    if(name IN_LIST shared_words)
      foreach(where IN LISTS arg_TEXTS)
        string(REGEX REPLACE "(struct|enum) ${name}([^A-Za-z_0-9])" "\\1 ${name}_\\2"
               ${where} "${${where}}")
        string(REGEX REPLACE "([^A-Za-z_0-9.>])${name}\\(" "\\1${name}_(" ${where} "${${where}}")
        string(REGEX REPLACE "([.]${name} = |= )${name}," "\\1${name}_," ${where} "${${where}}")
      endforeach()
      string(APPEND name _)
    endif()
    list(APPEND result ${name})
  endforeach()
  set(${variable} "${result}" PARENT_SCOPE)
  foreach(where IN LISTS arg_TEXTS)
    set(${where} "${${where}}" PARENT_SCOPE)
  endforeach()
endfunction()

set_property(GLOBAL PROPERTY seen "")
file(GLOB shared_headers ${src}/plan/*.h ${src}/dispatch/*.h ${src}/calls/*.h ${src}/recipe/*.h)
file(GLOB sources ${src}/calls/*.c ${src}/plan/*.c ${src}/dispatch/*.c ${src}/recipe/*.c
     ${src}/scalar/*.c)

# What files share
set(shared "")
foreach(header IN LISTS shared_headers ITEMS ${src}/simd/lookup.h)
  get_property(seen GLOBAL PROPERTY seen)
  if(NOT header IN_LIST seen)
    set_property(GLOBAL APPEND PROPERTY seen ${header})
    expand(${header} text ON)
    string(REPLACE "${src}/" "" name ${header})
    string(APPEND shared "\n/* --- ${name} --- */\n${text}")
  endif()
endforeach()
names_of("${shared}" shared_names shared_macros)
get_property(shared_seen GLOBAL PROPERTY seen)
file(READ ${SOURCE}/include/scarp.h public)
string(REGEX REPLACE "/\\*([^*]|\\*[^/])*\\*/" "" code "${public}${shared}")
string(REGEX REPLACE "\"[^\"\n]*\"" "" code "${code}") # texts
string(REGEX MATCHALL "[A-Za-z_][A-Za-z_0-9]*" shared_words "${code}")
list(REMOVE_DUPLICATES shared_words)

# The files that are compiled once. Whoever compiles all of them into one directory has an object of each.
set(once "")
set(objects "")
foreach(source IN LISTS sources)
  get_filename_component(object ${source} NAME)
  if(object IN_LIST objects)
    message(FATAL_ERROR "${source}: another file has the name ${object}, too")
  endif()
  list(APPEND objects ${object})
  set_property(GLOBAL PROPERTY seen ${shared_seen})
  expand(${source} text OFF)
  names_of("${text}" names macros)
  set(taken ${names})
  list(FILTER taken EXCLUDE REGEX "^(scarpi?_|SCARP_)")
  foreach(name IN LISTS taken)
    if(name IN_LIST shared_names)
      message(FATAL_ERROR "${source}: a header that files share has the name ${name}, too")
    endif()
  endforeach()
  renamed(names TEXTS text WITHOUT ${macros})
  string(REPLACE "${src}/" "" name ${source})
  string(REGEX REPLACE "[/.]" "_" suffix ${name})
  set(begin "")
  set(end "")
  foreach(renamed IN LISTS names)
    string(APPEND begin "#define ${renamed} ${renamed}_${suffix}\n")
    string(APPEND end "#undef ${renamed}\n")
  endforeach()
  foreach(macro IN LISTS macros)
    string(APPEND end "#undef ${macro}\n")
  endforeach()
  string(APPEND once "\n/* --- ${name} --- */\n${begin}${text}${end}")
endforeach()

# The sets: what stands before the operations of a set is not renamed.
set_property(GLOBAL PROPERTY seen ${shared_seen})
set(each "")
file(GLOB kernels ${src}/simd/kernels_*.c)
foreach(source IN LISTS kernels)
  read_source(${source} text)
  string(REGEX REPLACE ".*_(.*)\\.c" "\\1" set ${source})
  string(REGEX MATCH "\n#include \"(vec_[a-z0-9]+)\\.h\"\n" include "${text}")
  if(NOT include)
    message(FATAL_ERROR "${source} includes no vec_<set>.h: teach it to cmake/single.cmake")
  endif()
  set(header simd/${CMAKE_MATCH_1}.h)
  expand(${src}/${header} operations OFF)
  string(REGEX MATCHALL "\n#include <[^\n]*" system "${operations}")
  list(JOIN system "" system)
  set(begin "${system}\n#define SCARP_SET ${set}")
  include_part(begin ${part_names})
  set(operations "${begin}\n/* --- ${header} --- */\n${operations}")
  set(end "")
  include_part(end ${part_table})
  include_part(end ${part_end})
  string(REPLACE "${include}" "${operations}" text "${text}")
  string(REPLACE "\n#include KERNELS_BODY\n" "${end}" text "${text}")
  string(REGEX REPLACE "\n#include \"(../dispatch/kernels|body).h\"" "" text "${text}")
  string(APPEND each "\n/* --- simd/kernels_${set}.c --- */\n${text}")
endforeach()

# The parts
expand(${src}/simd/vec_types.h types OFF)
expand(${src}/simd/vec.h vec OFF)
expand(${src}/kernel/table.h table OFF)
names_of("${each}${types}${vec}${table}" names macros)
renamed(names TEXTS each types vec table WITHOUT ${macros})
set(begin "\n#define SCARP_SUFFIX_(name, set) name##_##set
#define SCARP_SUFFIX(name, set) SCARP_SUFFIX_(name, set)\n")
set(end "#undef SCARP_SET\n#undef SCARP_SUFFIX\n#undef SCARP_SUFFIX_\n")
foreach(renamed IN LISTS names)
  string(APPEND begin "#define ${renamed} SCARP_SUFFIX(${renamed}, SCARP_SET)\n")
  string(APPEND end "#undef ${renamed}\n")
endforeach()
foreach(macro IN LISTS macros)
  string(APPEND end "#undef ${macro}\n")
endforeach()

file(READ ${SOURCE}/cmake/single.c.in head)
file(READ ${SOURCE}/LICENSE license)
string(STRIP "${license}" license)
string(REPLACE "\n" "\n * " license "${license}")
string(REPLACE "\n * \n" "\n *\n" license "${license}")
string(REPLACE "@LICENSE@" "${license}" head "${head}")
string(REPLACE "@VERSION@" "${VERSION}" head "${head}")

file(MAKE_DIRECTORY ${OUTPUT})
set(file ${OUTPUT}/scarp_single.c)
file(WRITE ${file} "${head}${shared}${once}${each}
#ifdef __ELF__
#pragma GCC visibility pop
#endif
")
read_source(${src}/plan/functions.def functions)
set(number 0)
foreach(part "types|the types of vectors" "vec|the operations of vectors" "table|the kernels"
        "begin|names with the suffix of a set" "end|names as they were"
        "functions|the table of functions")
  math(EXPR number "${number} + 1")
  string(REGEX MATCH "(.*)[|](.*)" all "${part}")
  file(APPEND ${file}
       "\n#elif SCARP_PART == ${number} /* ${CMAKE_MATCH_2} */\n${${CMAKE_MATCH_1}}")
endforeach()
file(APPEND ${file} "\n#endif\n")
# Sources may be such as nobody may write; the copy is written again when the header changes.
file(COPY ${SOURCE}/include/scarp.h DESTINATION ${OUTPUT} NO_SOURCE_PERMISSIONS)
