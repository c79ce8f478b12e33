# SPDX-License-Identifier: MIT
"""A shaded map with a scale in metres, by matplotlib.

    python3 hillshade.py OUTPUT.png
"""
import sys

import matplotlib
import numpy as np
import scarp

matplotlib.use("Agg")
from matplotlib import colormaps, colors, pyplot  # noqa: E402


def main(path):
    alps = scarp.preset("alps", seed=8).grid((600, 800), step=10, derivatives=1)
    normal = alps.normals()
    light = np.array([-1, 1, 1.2]) / np.sqrt(3.44)  # from the north-west
    shade = (normal @ light).clip(0)
    land = colors.ListedColormap(colormaps["terrain"](np.linspace(0.25, 1, 256)))  # without sea
    figure, axes = pyplot.subplots(figsize=(9, 6), constrained_layout=True)
    heights = axes.imshow(alps.value, cmap=land, origin="lower", extent=alps.extent)
    axes.imshow(shade, cmap="gray", alpha=0.5, origin="lower", extent=alps.extent)
    axes.set(xlabel="east, m", ylabel="north, m")
    figure.colorbar(heights, label="height, m")
    figure.savefig(path, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
