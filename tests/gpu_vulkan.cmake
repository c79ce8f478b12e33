# SPDX-License-Identifier: MIT
# The shaders give the bits of the library on a Vulkan device. GLSL and HLSL are compiled to SPIR-V
# with the project, since the installed files must compile.

set(gpu_points 4099)
set(gpu_dir ${CMAKE_CURRENT_SOURCE_DIR}/gpu)
set(gpu_shaders ${CMAKE_CURRENT_BINARY_DIR}/gpu)
file(MAKE_DIRECTORY ${gpu_shaders})

# scarp_gpu_shader(NAME SOURCE LANGUAGE options...): gpu/NAME-2d.spv and gpu/NAME-3d.spv, or
# gpu/NAME-2d-rounded.spv and so on if the options have -DSCARP_ROUND
function(scarp_gpu_shader name source language)
  set(ending .spv)
  if("-DSCARP_ROUND" IN_LIST ARGN)
    set(ending -rounded.spv)
  endif()
  foreach(d 2 3)
    set(output ${gpu_shaders}/${name}-${d}d${ending})
    add_custom_command(OUTPUT ${output}
      COMMAND ${SCARP_GLSLANG} --quiet -V -S comp ${ARGN} -DDIMENSIONS=${d}
              -I${PROJECT_SOURCE_DIR}/include -o ${output} ${gpu_dir}/${source}
      DEPENDS ${gpu_dir}/${source} ${PROJECT_SOURCE_DIR}/include/scarp.${language}
      COMMENT "Compiling gpu/${name}-${d}d${ending}"
      VERBATIM)
    set_property(GLOBAL APPEND PROPERTY gpu_files ${output})
  endforeach()
endfunction()

# scarp_gpu_whole_shader(NAME SOURCE options...): gpu/NAME.spv of a shader in GLSL for one purpose
function(scarp_gpu_whole_shader name source)
  set(output ${gpu_shaders}/${name}.spv)
  add_custom_command(OUTPUT ${output}
    COMMAND ${SCARP_GLSLANG} --quiet -V ${ARGN} -I${PROJECT_SOURCE_DIR}/include -o ${output} ${source}
    DEPENDS ${source} ${PROJECT_SOURCE_DIR}/include/scarp.glsl
    COMMENT "Compiling gpu/${name}.spv"
    VERBATIM)
  set_property(GLOBAL APPEND PROPERTY gpu_files ${output})
endfunction()

if(SCARP_GLSLANG)
  scarp_gpu_shader(glsl main.comp glsl)
  scarp_gpu_shader(glsl main.comp glsl -DSCARP_ROUND)
  scarp_gpu_shader(hlsl main.hlsl hlsl -D -e main)
  if(SCARP_TEST_THOROUGH) # for the controls
    scarp_gpu_shader(glsl-fused main.comp glsl -DSCARP_FUSE)
    scarp_gpu_shader(hlsl-fused main.hlsl hlsl -D -e main -DSCARP_FUSE)
    scarp_gpu_whole_shader(relief-fused ${PROJECT_SOURCE_DIR}/src/gpu/samples/relief.comp -DSCARP_FUSE)
  endif()
  scarp_gpu_whole_shader(picture ${gpu_dir}/picture.comp)
  get_property(gpu_files GLOBAL PROPERTY gpu_files)
  add_custom_target(gpu_shaders ALL DEPENDS ${gpu_files})
endif()

# Of every shader the driver gets to see: nothing may be fused, but for the control.
foreach(language glsl hlsl)
  set(contraction ${Python3_EXECUTABLE} ${gpu_dir}/contraction.py)
  set(name ${gpu_shaders}/${language})
  scarp_add_test(gpu.contraction.${language} shader IN without-glslang without-spirv-tools NEEDS glslang python3 spirv-tools
                 COMMAND ${contraction} ${SCARP_SPIRV_DIS} ${name}-2d.spv ${name}-3d.spv)
  scarp_add_test(gpu.contraction.${language}.control shader IN thorough NEEDS glslang python3 spirv-tools
                 COMMAND ${contraction} --must-find ${SCARP_SPIRV_DIS} ${name}-fused-2d.spv
                 ${name}-fused-3d.spv)
endforeach()

if("vulkan" IN_LIST scarp_found)
  foreach(program vulkan picture recipes)
    add_executable(gpu_${program} gpu/${program}.c)
    scarp_compile_rules(gpu_${program})
    target_link_libraries(gpu_${program} PRIVATE scarp Vulkan::Vulkan ${SCARP_LIBM})
  endforeach()
endif()

# scarp_add_gpu_test(NAME [IN leg] [NEEDS tool...] COMMAND argument...): what the driver keeps of compiled
# shaders stays here.
function(scarp_add_gpu_test name)
  cmake_parse_arguments(arg "" "" "IN;NEEDS;COMMAND" ${ARGN})
  scarp_add_test(${name} shader IN ${arg_IN} NEEDS glslang vulkan ${arg_NEEDS} COMMAND ${arg_COMMAND})
  if(TEST ${name})
    set_tests_properties(${name} PROPERTIES
                         ENVIRONMENT MESA_SHADER_CACHE_DIR=${gpu_shaders}/cache)
  endif()
endfunction()

scarp_add_gpu_test(gpu.glsl COMMAND gpu_vulkan ${gpu_shaders}/glsl ${gpu_points} hessian)
scarp_add_gpu_test(gpu.glsl.full IN thorough COMMAND gpu_vulkan ${gpu_shaders}/glsl 40003 hessian)
scarp_add_gpu_test(gpu.hlsl.full IN thorough COMMAND gpu_vulkan ${gpu_shaders}/hlsl 40003 hessian)
scarp_add_gpu_test(gpu.glsl.value IN thorough COMMAND gpu_vulkan ${gpu_shaders}/glsl ${gpu_points} value)
scarp_add_gpu_test(gpu.hlsl COMMAND gpu_vulkan ${gpu_shaders}/hlsl ${gpu_points} hessian)
scarp_add_gpu_test(gpu.glsl.answers IN thorough COMMAND gpu_vulkan ${gpu_shaders}/glsl ${gpu_points} answers)
scarp_add_gpu_test(gpu.control IN thorough COMMAND gpu_vulkan --must-differ ${gpu_shaders}/glsl-fused ${gpu_points} hessian)
scarp_add_gpu_test(gpu.picture IN thorough COMMAND gpu_picture ${gpu_shaders}/picture.spv --small)
scarp_add_gpu_test(gpu.relief IN thorough NEEDS python3
                   COMMAND ${Python3_EXECUTABLE} ${gpu_dir}/relief.py $<TARGET_FILE:relief>
                   ${PROJECT_BINARY_DIR}/bin/relief.spv ${gpu_shaders}/relief-fused.spv
                   ${PROJECT_SOURCE_DIR}/src/gpu/samples/relief.png $<$<BOOL:${SCARP_SPIRV_OPT}>:${SCARP_SPIRV_OPT}>)
scarp_add_gpu_test(gpu.engines.hlsl IN thorough NEEDS python3
                   COMMAND ${Python3_EXECUTABLE} ${gpu_dir}/engines.py hlsl
                   ${SCARP_GLSLANG} $<TARGET_FILE:relief> ${PROJECT_SOURCE_DIR})

# Recipes, which are compiled when a test runs
if("vulkan" IN_LIST scarp_found)
  set(gpu_recipes $<TARGET_FILE:gpu_recipes>)
else()
  set(gpu_recipes none)
endif()
function(scarp_add_recipe_test name in language) # COUNT EVERY RECIPE..., before them --must-differ
  set(control)
  if(ARGV3 STREQUAL "--must-differ")
    list(POP_FRONT ARGN control)
  endif()
  list(POP_FRONT ARGN count every)
  scarp_add_gpu_test(${name} IN ${in} NEEDS python3 COMMAND ${Python3_EXECUTABLE} ${gpu_dir}/recipes.py ${control}
                     $<TARGET_FILE:gpu_recipe_cases> ${gpu_recipes} ${SCARP_GLSLANG} ${count} ${every}
                     ${PROJECT_SOURCE_DIR}/include/scarp.${language} ${ARGN})
endfunction()
scarp_add_recipe_test(gpu.recipes.glsl "${long}" glsl 0 20)
scarp_add_recipe_test(gpu.recipes.control thorough glsl --must-differ 0 100)
set(gpu_some_recipes ${gpu_presets}/alps.recipe ${gpu_examples}/marble.recipe)
scarp_add_recipe_test(gpu.recipes.glsl.full thorough glsl 6 4 ${gpu_some_recipes})
scarp_add_recipe_test(gpu.recipes.hlsl.full thorough hlsl 4 4 ${gpu_some_recipes})

# What src/gpu/README.md shows
scarp_add_test(gpu.readme shader IN without-glslang without-spirv-tools NEEDS glslang python3
               COMMAND ${Python3_EXECUTABLE} ${gpu_dir}/readme.py blocks ${PROJECT_SOURCE_DIR} ${SCARP_GLSLANG})
scarp_add_gpu_test(gpu.readme.commands IN thorough NEEDS pkg-config posix python3 sh
                   COMMAND ${Python3_EXECUTABLE} ${gpu_dir}/readme.py commands
                   ${PROJECT_SOURCE_DIR} $<TARGET_FILE:scarp>)
