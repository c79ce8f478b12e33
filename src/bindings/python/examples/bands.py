# SPDX-License-Identifier: MIT
"""A map that need not fit into memory: threads sample bands of rows into a file.

    python3 bands.py OUTPUT.npy [SIDE [THREADS]]

Each band is a tile of one world, so the seams fit to the bit. ctypes releases the lock of Python
while C runs: threads share the cores.
"""
import os
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import scarp

ROWS = 256


def main(path, side=4096, threads=0):
    side, threads = int(side), int(threads) or os.cpu_count() or 1
    alps = scarp.preset("alps", seed=8)
    height = np.lib.format.open_memmap(path, "w+", np.float32, (side, side))

    def band(row):
        rows = min(ROWS, side - row)
        alps.grid((rows, side), step=10, first=(0, row), out=height[row:row + rows])

    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(band, range(0, side, ROWS)))  # list: an exception in a band is raised here
    height.flush()
    print("%d x %d heights by %d threads in %s" % (side, side, threads, path))


if __name__ == "__main__":
    main(*sys.argv[1:])
