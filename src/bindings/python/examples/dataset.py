# SPDX-License-Identifier: MIT
"""A terrain as a dataset of xarray, with coordinates and units.

    python3 dataset.py
"""
import numpy as np
import scarp
import xarray


def dataset(recipe, shape, step, first=(0, 0)):
    """The first output of a recipe with its gradient: dimensions y, x; row 0 is in the south."""
    tile = recipe.grid(shape, step, first=first, derivatives=1)
    x, y = ((first[i] + np.arange(shape[1 - i])) * step for i in range(2))
    return xarray.Dataset(
        {"height": (("y", "x"), tile.value, {"units": "m"}),
         "slope": (("y", "x"), np.hypot(tile.dx, tile.dy), {"units": "m/m"})},
        coords={"x": ("x", x, {"units": "m"}), "y": ("y", y, {"units": "m"})})


if __name__ == "__main__":
    print(dataset(scarp.preset("alps", seed=8), (300, 400), 10.0))
