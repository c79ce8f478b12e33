# SPDX-License-Identifier: MIT
"""Each sample of a level of detail is, to the bit, a sample of the world: by the document's recipe,
and by its formula for the origin."""
from farm import check, envi_rows, main, rows_of, tell

STEPS = (2, 4, 8, 16)


def up(a, b):
    return -(-a // b)


def check_level(rows, level, step, unit, what):
    """`level` has every step-th of `rows`, whose samples are `unit` long."""
    expected = [b"".join(row[c:c + unit] for c in range(0, len(row), unit * step))
                for row in rows[::step]]
    check(level == expected, what, "step", step, "differs from every %d-th sample" % step)


def recipe(new_farm):
    farm = new_farm("levels", slow=False, layers=())
    farm.run("The simplest farm")
    farm.run("Levels")
    farm.make_whole()
    _, _, rows = envi_rows(farm.path(farm.whole("--heights")))
    for step in STEPS:
        width, height = up(farm.width, step), up(farm.height, step)
        level = []
        for y in range(up(height, farm.tile)):
            tiles = [rows_of(farm.path("level%d" % step, str(y), "%d.img" % x))[2]
                     for x in range(up(width, farm.tile))]
            level += [b"".join(parts) for parts in zip(*tiles)]
        check((len(level[0]) // 4, len(level)) == (width, height), "size of level", step)
        check_level(rows, level, step, 4, "the recipe")
    tell("the recipe: levels of steps %s have the samples of %d x %d" % (
        ", ".join(map(str, STEPS)), farm.width, farm.height))


def formula(new_farm):
    """Other sizes, origins and steps, and what comes from the gradient"""
    farm = new_farm("formula", slow=False, layers=())
    layers = (("--heights", "img", 4), ("--normals", "img", 12), ("--gradient", "img", 8),
              ("--hillshade", "img", 1))
    for width, height, x, y, unit in ((64, 64, 0, 0, 1), (33, 47, -70, 1000, 0.25),
                                      (50, 1, 3.5, -8, 0.5), (1, 50, -2 ** 40, 2 ** 40, 1),
                                      (17, 31, 5, 7, 3)):
        whole = None
        for step in (1, 2, 4, 8, 16, 64):
            w, h = up(width, step), up(height, step)
            origin = "%r,%r" % (x, y + ((height - 1) - (h - 1) * step) * unit)
            files = ["%s-%d.img" % (option[2:], step) for option, _, _ in layers]
            outputs = [word for layer, name in zip(layers, files) for word in (layer[0], name)]
            farm.output("scarp", "terrain", "--size", "%dx%d" % (w, h), "--origin", origin,
                        "--step", repr(unit * step), "--frequency", "0.03", "--rotate", "--quiet",
                        *outputs)
            rows = [envi_rows(farm.path(name))[2] for name in files]
            whole = whole or rows
            for (option, _, size), level, full in zip(layers, rows, whole):
                check_level(full, level, step, size, "%s of %d x %d" % (option, width, height))
    tell("the formula: heights, normals, gradient, hillshade of five worlds, six steps each")


def test(new_farm):
    recipe(new_farm)
    formula(new_farm)


main(test)
