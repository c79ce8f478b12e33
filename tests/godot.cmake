# SPDX-License-Identifier: MIT
# The extension for Godot, which a program that plays the part of Godot loads. Godot's header is not
# here: SCARP_GODOT_HEADERS is its folder.

if("godot" IN_LIST scarp_found)
  set(GODOT_HEADERS ${SCARP_GODOT_HEADERS})
  add_subdirectory(${PROJECT_SOURCE_DIR}/src/bindings/godot ${PROJECT_BINARY_DIR}/godot)
  scarp_compile_rules(scarp_godot)
  add_executable(godot_host bindings/godot_host.c)
  scarp_compile_rules(godot_host)
  target_include_directories(godot_host PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_include_directories(godot_host SYSTEM PRIVATE ${SCARP_GODOT_HEADERS})
  target_link_libraries(godot_host PRIVATE scarp ${CMAKE_DL_LIBS} ${SCARP_LIBM})
  add_dependencies(godot_host scarp_godot)
  scarp_add_test(godot bindings IN without-glslang COMMAND godot_host $<TARGET_FILE:scarp_godot>
                 ${PROJECT_SOURCE_DIR}/include/scarp.glsl)
else()
  scarp_add_test(godot bindings IN without-glslang NEEDS godot)
endif()

# The shader of its page
scarp_add_test(godot.shader shader IN without-glslang NEEDS glslang python3 scarp
               COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/bindings/test_godot_shader.py
               ${PROJECT_SOURCE_DIR} "${SCARP_GLSLANG}" ${CMAKE_CURRENT_BINARY_DIR}/godot
               ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:scarp-cli>)
