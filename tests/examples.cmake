# SPDX-License-Identifier: MIT
# The programs of src/examples draw the committed pictures, and compile as a reader would do it.

# scarp_add_cloud_test(NAME LABEL CLASS [tool...]): CLASS of test_cloud.py
function(scarp_add_cloud_test name label class)
  scarp_add_test(example.cloud.${name} ${label} NEEDS python3 ${ARGN}
                 COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/test_cloud.py ${class}
                 ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:cloud>)
  if(TEST example.cloud.${name})
    set_tests_properties(example.cloud.${name} PROPERTIES ENVIRONMENT
                         "SCARP_SPEED=${speed};PYTHONDONTWRITEBYTECODE=1")
  endif()
endfunction()
foreach(isa IN LISTS isas)
  scarp_add_cloud_test(${isa} example isa=${isa})
endforeach()
scarp_add_cloud_test(arguments example Arguments)
scarp_add_cloud_test(picture example Picture full-speed)

scarp_add_test(example.compile package NEEDS python3
               COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/test_cloud_compile.py
               ${PROJECT_SOURCE_DIR} $<TARGET_FILE:scarp> ${CMAKE_CURRENT_BINARY_DIR}/examples
               "${CMAKE_C_COMPILER_ID}" "flags: ${CMAKE_C_FLAGS}" ${CMAKE_C_COMPILER}
               ${CMAKE_CROSSCOMPILING_EMULATOR})
