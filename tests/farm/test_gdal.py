# SPDX-License-Identifier: MIT
"""GDAL reads the tiles as one raster, and the levels as its overviews."""
import json

from farm import check, main, need, tell
from rasters import read_bytes


def test(new_farm):
    need("gdalbuildvrt", "gdalinfo", "gdal_translate")
    farm = new_farm("gdal", slow=False, layers=())
    for name in ("Levels", "GDAL"):
        farm.run(name)
    farm.make_whole()
    band, = json.loads(farm.output("gdalinfo", "-json", "level0.vrt"))["bands"]
    expected = [[-(-farm.width // step), -(-farm.height // step)] for step in (2, 4, 8, 16)]
    check([overview["size"] for overview in band["overviews"]] == expected, "overviews:", band)
    farm.output("gdal_translate", "-q", "-of", "ENVI", "level0.vrt", "all.img")
    check(read_bytes(farm.path("all.img")) == read_bytes(farm.path(farm.whole("--heights"))),
          "GDAL reads other samples than those of one file")
    tell("level0.vrt has the samples of one file without tiles, and overviews of %s" % expected)
    for number, (width, height) in enumerate(expected):
        farm.output("gdal_translate", "-q", "-of", "ENVI", "-oo", "OVERVIEW_LEVEL=%d" % number,
                    "level0.vrt", "overview.img")
        farm.output("gdal_translate", "-q", "-of", "ENVI", "level%d.vrt" % (number + 1),
                    "level.img")
        data = read_bytes(farm.path("overview.img"))
        check(len(data) == width * height * 4 and data == read_bytes(farm.path("level.img")),
              "overview", number, "differs from its level")
    tell("each overview has the samples of its level")


main(test)
