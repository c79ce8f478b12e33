# SPDX-License-Identifier: MIT
# Fuzz targets run the inputs that are kept; fuzz/CMakeLists.txt has both ways to build them.

add_subdirectory(fuzz)
