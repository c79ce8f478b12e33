# SPDX-License-Identifier: MIT
# Writes presets.c and presets_words.h, the recipes of the program and what help says of them, to the
# directory TO. FROM is that of the recipes, PRESETS the list of their names.
#
#   cmake -D FROM=src/cli/presets -D TO=folder "-DPRESETS=alps;dunes" -P embed.cmake

cmake_minimum_required(VERSION 3.25)

set(help "presets    are recipes; scarp recipe NAME prints one and shows its parameters")
foreach(name IN LISTS PRESETS)
  file(READ ${FROM}/${name}.recipe text HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${text}")
  string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" bytes "${bytes}")
  string(APPEND arrays "static const char ${name}[] = {\n${bytes}\n};\n")
  string(APPEND list "    {${name}, sizeof ${name}},\n")
  string(APPEND words "\"${name}\", ")
  # The first comment says what it is.
  file(STRINGS ${FROM}/${name}.recipe about LIMIT_COUNT 1)
  string(REGEX REPLACE "^# *" "" about "${about}")
  string(SUBSTRING "${name}         " 0 9 padded)
  string(APPEND help "\n  ${padded} ${about}")
endforeach()

string(REPLACE "\n" "\\n" help "${help}")
file(WRITE ${TO}/presets_words.h "/* Written by embed.cmake. */
#define PRESET_HELP \"${help}\"
")
file(WRITE ${TO}/presets.c "/* Written by embed.cmake. */
#include \"presets/presets.h\"

${arrays}
static const char *const names[] = {\"none\", ${words}NULL};

const char *preset_name(int number)
{
    return names[number];
}

const struct preset preset_list[] = {
    {NULL, 0},
${list}};
")
