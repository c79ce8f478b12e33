# SPDX-License-Identifier: MIT
# Compiles and runs the samples of the documents as they are there.

# scarp_add_readme_test(LANGUAGE COMPILER [IN leg...] [NEEDS tool...]): the samples in this language
set(readme_in without-bash without-c++ without-python3)
function(scarp_add_readme_test language compiler)
  cmake_parse_arguments(arg "" "" "IN;NEEDS" ${ARGN})
  scarp_add_test(readme.${language} package IN ${readme_in} ${arg_IN} NEEDS python3 ${arg_NEEDS}
                 COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/test_readme.py
                 ${language} ${PROJECT_SOURCE_DIR} $<TARGET_FILE:scarp>
                 ${PROJECT_SOURCE_DIR}/include ${CMAKE_CURRENT_BINARY_DIR}/readme-${language}
                 "${CMAKE_C_COMPILER_ID}" "flags: ${CMAKE_C_FLAGS}" ${compiler}
                 ${CMAKE_CROSSCOMPILING_EMULATOR})
endfunction()
scarp_add_readme_test(c ${CMAKE_C_COMPILER} IN nobody)
scarp_add_readme_test(cxx ${SCARP_CXX} IN nobody NEEDS c++)
scarp_add_readme_test(python "${SCARP_NUMPY}" IN without-numpy NEEDS numpy)

# The animation in the shell, which needs the program in the place of the library
scarp_add_test(readme.sh package IN ${readme_in} NEEDS python3 scarp sh
               COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/test_readme.py
               sh ${PROJECT_SOURCE_DIR} $<TARGET_FILE:scarp-cli>
               ${PROJECT_SOURCE_DIR}/include ${CMAKE_CURRENT_BINARY_DIR}/readme-sh
               "${CMAKE_C_COMPILER_ID}" "flags: ${CMAKE_C_FLAGS}" sh
               ${CMAKE_CROSSCOMPILING_EMULATOR})

# Links, pictures and anchors of all documents; the table of calls
scarp_add_test(documents package IN nobody without-git NEEDS python3 COMMAND ${Python3_EXECUTABLE}
               ${CMAKE_CURRENT_SOURCE_DIR}/test_links.py ${PROJECT_SOURCE_DIR})

# The table of functions in the page of recipes, which the script writes without --check
scarp_add_test(documents.functions package NEEDS python3 COMMAND ${Python3_EXECUTABLE}
               ${PROJECT_SOURCE_DIR}/src/recipe/table.py --check)
