# SPDX-License-Identifier: MIT
# The programs of src/examples draw the committed pictures, and compile as a reader would do it.

# scarp_add_picture_test(EXAMPLE NAME CLASS [IN leg] [NEEDS tool]): CLASS of test_picture.py; PROGRAM, if it
# is set, has the name of the program
function(scarp_add_picture_test example name class)
  cmake_parse_arguments(arg "" "" "IN;NEEDS" ${ARGN})
  set(program ${example})
  if(PROGRAM)
    set(program ${PROGRAM})
  endif()
  set(test example.${example}.${name})
  scarp_add_test(${test} example IN ${arg_IN} NOT sanitized NEEDS python3 ${arg_NEEDS}
                 COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/test_picture.py ${example} ${class}
                 ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:${program}>)
  if(TEST ${test})
    set_tests_properties(${test} PROPERTIES ENVIRONMENT
                         "SCARP_SPEED=${speed};PYTHONDONTWRITEBYTECODE=1")
  endif()
endfunction()
foreach(example cloud mountains)
  foreach(isa IN LISTS isas)
    scarp_add_picture_test(${example} ${isa} isa=${isa})
  endforeach()
  scarp_add_picture_test(${example} arguments Arguments)
  scarp_add_picture_test(${example} picture Picture IN thorough NEEDS full-speed)
endforeach()

# The recipes; on all sets, tests/recipe.cmake compares their like
block()
  set(PROGRAM paint)
  foreach(recipe alps clouds marble overworld range)
    scarp_add_picture_test(${recipe} small Small)
    scarp_add_picture_test(${recipe} picture Picture IN thorough NEEDS full-speed)
  endforeach()
  scarp_add_picture_test(range arguments Arguments)
endblock()

scarp_add_test(example.compile package NOT sanitized NEEDS python3
               COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/test_picture_compile.py
               ${PROJECT_SOURCE_DIR} $<TARGET_FILE:scarp> ${CMAKE_CURRENT_BINARY_DIR}/examples
               "${CMAKE_C_COMPILER_ID}" "flags: ${CMAKE_C_FLAGS}" ${CMAKE_C_COMPILER}
               ${CMAKE_CROSSCOMPILING_EMULATOR})
