# SPDX-License-Identifier: MIT
# The recipes of the program, in the order of its help
set(scarp_presets alps overworld range)
