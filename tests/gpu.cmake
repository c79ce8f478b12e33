# SPDX-License-Identifier: MIT
# Tests the noise of shaders: what the library gives to them.

scarp_test_program(test_gpu_plan INTERNAL)
scarp_add_test(gpu.plan gpu test_gpu_plan)
scarp_test_program(test_gpu_answers)
scarp_add_isa_tests(gpu.answers gpu test_gpu_answers)

# The source of the shaders as C; whether the files made of it are current, and what it may not have.
scarp_test_program(test_gpu_source)
if(speed STREQUAL "full")
  scarp_add_test(gpu.source gpu test_gpu_source)
else()
  scarp_add_test(gpu.source gpu test_gpu_source few)
endif()
# What shaders have besides noise, and recipes as their text
scarp_test_program(test_gpu_chain INTERNAL)
if(speed STREQUAL "full")
  scarp_add_test(gpu.chain gpu test_gpu_chain)
else()
  scarp_add_test(gpu.chain gpu test_gpu_chain few)
endif()
scarp_test_program(test_gpu_recipe)
scarp_add_test(gpu.recipe gpu test_gpu_recipe ${PROJECT_SOURCE_DIR}/include)
scarp_add_test(gpu.shaders gpu NEEDS python3 COMMAND
               ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/src/gpu/shaders.py --check)
scarp_add_test(gpu.subset gpu NEEDS python3 COMMAND ${Python3_EXECUTABLE}
               ${CMAKE_CURRENT_SOURCE_DIR}/gpu/subset.py ${PROJECT_SOURCE_DIR}/src/gpu
               ${CMAKE_CURRENT_BINARY_DIR}/gpu-subset)

# The samples for Unity and Unreal; gpu_vulkan.cmake has their shaders
set(engines ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/gpu/engines.py)
add_executable(gpu_write_relief gpu/write_relief.c)
scarp_compile_rules(gpu_write_relief)
target_link_libraries(gpu_write_relief PRIVATE scarp ${SCARP_LIBM})
scarp_add_test(gpu.engines.csharp gpu IN thorough NEEDS mono python3
               COMMAND ${engines} csharp ${SCARP_MCS} ${SCARP_MONO} $<TARGET_FILE:scarp>
               $<TARGET_FILE:gpu_write_relief> ${PROJECT_SOURCE_DIR})
scarp_add_test(gpu.engines.cpp gpu IN without-c++ without-glslang without-mono NEEDS c++ posix python3
               COMMAND ${engines} cpp ${SCARP_CXX} ${PROJECT_SOURCE_DIR})
