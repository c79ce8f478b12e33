# SPDX-License-Identifier: MIT
"""scarp: noise for terrain, with exact derivatives, as arrays of NumPy.

    import scarp
    noise = scarp.Noise(fractal="ridged", seed=42, frequency=0.01, octaves=6)
    tile = noise.grid((512, 512), derivatives=1)    # tile.value, tile.dx, tile.dy

Shapes are NumPy's, rows first: value[j, i] lies at x = i, y = j. Everything that is a coordinate
(step, origin, first) is in the order x, y, z. Lengths are in the units of the coordinates, angles
in turns. Results are float32, and have the same bits on every machine.

What the library does not take raises ScarpError, a ValueError that names the member at fault;
recipes raise RecipeError, with line and column. Wrong types are TypeErrors.

The shared library is found beside this module, or in the system, or where SCARP_LIBRARY in the
environment says. It must be of the same version, or a later one with the same interface.
"""
from ._gullies import Gullies
from ._interface import VERSION as __version__
from ._library import (BASES, FADES, FRACTALS, LibraryError, ScarpError, VERSION_OF_LIBRARY, isa,
                       isas, select_isa)
from ._noise import Cells, Flow, Noise
from ._recipe import Info, Param, Place, Recipe, RecipeError, preset, presets
from ._samples import Samples

__all__ = ["BASES", "Cells", "FADES", "FRACTALS", "Flow", "Gullies", "LibraryError", "Noise",
           "Info", "Param", "Place", "Recipe", "RecipeError", "Samples", "ScarpError",
           "VERSION_OF_LIBRARY", "__version__", "isa", "isas", "preset", "presets", "select_isa"]
