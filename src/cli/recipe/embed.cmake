# SPDX-License-Identifier: MIT
# Writes shader_files.c, which has scarp.glsl, scarp.hlsl and scarp.wgsl, to the directory TO. FROM is
# where they are.
#
#   cmake -D FROM=include -D TO=folder -P embed.cmake

cmake_minimum_required(VERSION 3.25)

foreach(language glsl hlsl wgsl)
  file(READ ${FROM}/scarp.${language} text HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${text}")
  string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" bytes "${bytes}")
  string(APPEND arrays "static const char ${language}[] = {\n${bytes}\n};\n")
  string(APPEND list "    {${language}, sizeof ${language}},\n")
endforeach()
file(WRITE ${TO}/shader_files.c "/* Written by embed.cmake. */
#include \"recipe/shader.h\"

${arrays}
const struct shader_file shader_files[] = {
${list}};
")
