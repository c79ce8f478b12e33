#!/bin/sh
# SPDX-License-Identifier: MIT
# The recipes for vcpkg and conan, run with stand-ins for what these provide.
. ./common.sh
fresh recipes
"$python" -B recipes.py "$source_dir" "$cmake" "$dir" "$version"
