#!/bin/sh
# SPDX-License-Identifier: MIT
# The ports for vcpkg and conan, run with stand-ins for what these provide.
. ./common.sh
fresh ports
"$python" -B ports.py "$source_dir" "$cmake" "$dir" "$version"
