#!/bin/sh
# SPDX-License-Identifier: MIT
# The installed shared library through Python's ctypes.
. ./common.sh
[ "$library_type" = SHARED_LIBRARY ] || skip "the library is static"
[ "$cross" = 0 ] || skip "Python cannot load a library of another processor"
[ -d "$prefix" ] || skip "nothing is installed"
! sanitized || skip "Python cannot load a sanitized library"
[ "$pointer_size" = "$("$python" -c 'import struct; print(struct.calcsize("P"))')" ] ||
    skip "Python and the library have different pointer sizes"

"$python" -B consumer.py "$prefix/$libdir/$library_name" "$version"
