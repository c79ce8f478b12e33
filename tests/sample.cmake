# SPDX-License-Identifier: MIT
# Tests `scarp sample` from outside. One test per class of sample/test_*.py. Results are compared
# with those of the shared library, called by Python itself where that is possible.

block()
  get_target_property(type scarp TYPE)
  set(library -)
  if(type STREQUAL "SHARED_LIBRARY" AND NOT CMAKE_CROSSCOMPILING
     AND NOT CMAKE_C_FLAGS MATCHES "-fsanitize")
    set(library $<TARGET_FILE:scarp>)
  endif()
  set(program ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:scarp-cli>)

  # scarp_add_sample_test(FILE CLASS... [IN leg...] [NOT leg...]): classes of sample/test_FILE.py
  function(scarp_add_sample_test file)
    cmake_parse_arguments(arg "" "" "IN;NOT" ${ARGN})
    foreach(class IN LISTS arg_UNPARSED_ARGUMENTS)
      string(TOLOWER ${class} name)
      scarp_add_test(cli.sample.${name} cli IN ${arg_IN} NOT ${arg_NOT} NEEDS scarp python3
                     COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/sample/test_${file}.py
                     ${class} ${library} ${program})
      set_tests_properties(cli.sample.${name} PROPERTIES ENVIRONMENT
                           "SCARP_SPEED=${speed};PYTHONDONTWRITEBYTECODE=1")
    endforeach()
  endfunction()
  scarp_add_sample_test(values Help Formats Values Recipes Numbers Options)
  scarp_add_sample_test(lines Lines Delimiters Malformed Columns)
  scarp_add_sample_test(columns Header Chosen Readme)
  scarp_add_sample_test(npy Npy IN without-numpy)
  scarp_add_sample_test(npy Description NOT s390x sanitized)
  scarp_add_sample_test(npy NotFinite)
  scarp_add_sample_test(streams Streams Files)
endblock()
