# SPDX-License-Identifier: MIT
# Tests scarp.wgsl (WebGPU) and scarp.glsl (WebGL 2) in headless Chromium: every bit against the
# library. It has a GPU in software, so this runs on any machine.

add_executable(gpu_write_cases gpu/write_cases.c)
scarp_compile_rules(gpu_write_cases)
target_link_libraries(gpu_write_cases PRIVATE scarp ${SCARP_LIBM})

foreach(test wgsl:wgsl webgl:webgl browser_control:control)
  string(REPLACE ":" ";" test ${test})
  list(GET test 0 name)
  list(GET test 1 what)
  scarp_add_test(gpu.${name} shader IN thorough NEEDS chromium posix python3
                 COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/gpu/browser.py ${what}
                 ${SCARP_CHROMIUM} $<TARGET_FILE:gpu_write_cases> ${PROJECT_SOURCE_DIR})
endforeach()

# Recipes as shaders: what is to be compared, and in the browser
add_executable(gpu_recipe_cases gpu/recipe_cases.c)
scarp_compile_rules(gpu_recipe_cases)
target_link_libraries(gpu_recipe_cases PRIVATE scarp ${SCARP_LIBM})

set(gpu_presets ${PROJECT_SOURCE_DIR}/src/cli/presets)
set(gpu_examples ${PROJECT_SOURCE_DIR}/src/examples/recipes)
set(gpu_recipes_wgsl 3 7 ${gpu_presets}/alps.recipe ${gpu_examples}/marble.recipe)
set(gpu_recipes_webgl 0 15 ${gpu_examples}/marble.recipe)
foreach(language wgsl webgl)
  scarp_add_test(gpu.recipes.${language} shader IN thorough NEEDS chromium posix python3
                 COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/gpu/browser.py
                 recipes.${language} ${SCARP_CHROMIUM} $<TARGET_FILE:gpu_recipe_cases>
                 ${PROJECT_SOURCE_DIR} ${gpu_recipes_${language}})
endforeach()

# The pages of src/gpu/samples
foreach(name webgpu webgl)
  scarp_add_test(gpu.page.${name} shader IN thorough NEEDS chromium posix python3
                 COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/gpu/pages.py ${name}
                 ${SCARP_CHROMIUM} $<TARGET_FILE:gpu_write_relief> ${PROJECT_SOURCE_DIR})
endforeach()
