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
  foreach(test values:Help values:Formats values:Values values:Recipes values:Numbers values:Options lines:Lines
               lines:Delimiters lines:Malformed lines:Columns columns:Header columns:Chosen columns:Readme npy:Npy
               npy:Description npy:NotFinite streams:Streams streams:Files)
    string(REPLACE ":" ";" test ${test})
    list(GET test 0 file)
    list(GET test 1 class)
    string(TOLOWER ${class} name)
    scarp_add_test(cli.sample.${name} cli NEEDS scarp python3 COMMAND ${Python3_EXECUTABLE}
                   ${CMAKE_CURRENT_LIST_DIR}/sample/test_${file}.py ${class} ${library} ${program})
    set_tests_properties(cli.sample.${name} PROPERTIES ENVIRONMENT
                         "SCARP_SPEED=${speed};PYTHONDONTWRITEBYTECODE=1")
  endforeach()
endblock()
