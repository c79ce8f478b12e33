# SPDX-License-Identifier: MIT
# The recipes of the program, in the order of its help
set(scarp_presets alps range hills badlands canyon mesas dunes volcanic islands)
