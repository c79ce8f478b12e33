# SPDX-License-Identifier: MIT
"""The structures of spans in scarp.hpp, and those of C that are made of them. The list of their
members for the tests of C++."""
from tables.arrays import arrays
from tables.text import replaced

PATH, TESTED = "include/scarp.hpp", "tests/cpp/members.hpp"
SPANS = (("samples", "scarp_samples", "outputs, and inputs of the chain rule and of gullies"),
         ("features", "scarp_cells", "the features near each point"),
         ("flow", "scarp_flow", "velocities and their Jacobians"),
         ("eroded", "scarp_eroded", "the base with gullies, and the displacement"))
TYPES = {"float": "float", "uint32_t": "std::uint32_t"}


def spans(header):
    out = []
    for name, structure, about in SPANS:
        out += ["", "/* struct %s with spans: %s */" % (structure, about), "struct %s {" % name]
        out += ["    std::span<%s> %s{};" % (TYPES[array.kind], array.name)
                for array in arrays(header, structure)] + ["};"]
    return out[1:]


def structures_of_c(header):
    for name, structure, _ in SPANS:
        yield "inline %s c_of(const %s &s, sizes &of) noexcept" % (structure, name)
        yield "{\n    %s c;" % structure
        for array in arrays(header, structure):
            yield '    c.%s = of(s.%s, "%s");' % (array.name, array.name, array.name)
        yield "    return c;\n}"


def tested(header):
    """The content of tests/cpp/members.hpp."""
    out = ["/* SPDX-License-Identifier: MIT",
           " *",
           " * The spans of floats of each structure, as X(name, is of the plane). Made by",
           " * src/bindings/interface.py; do not change them by hand. */"]
    for name, structure, _ in SPANS:
        members = [array for array in arrays(header, structure) if array.kind == "float"]
        lines = ["#define %s_MEMBERS(X)" % name.upper()]
        lines += ["    X(%s, %s)" % (array.name, str(not array.is_of_space).lower())
                  for array in members]
        out += [""] + ["%-99s\\" % line for line in lines[:-1]] + lines[-1:]
    return "\n".join(out) + "\n"


def made(header, read):
    """Files with what is made of the header: pairs of a path and a text"""
    text = replaced(PATH, read(PATH), "spans", spans(header))
    yield PATH, replaced(PATH, text, "of", structures_of_c(header))
    yield TESTED, tested(header)
