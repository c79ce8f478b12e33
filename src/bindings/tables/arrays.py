# SPDX-License-Identifier: MIT
"""The structures of scarp.h that are lists of arrays, and what bindings say of each array."""
import re
import sys

# By the names of members, since the header has one comment for several of them. For others it is the
# header's.
SAYS = (("value", "the value"),
        ("d([xyz])", "the gradient along {0}, per unit of input"),
        (r"d([xyz])\1", "the second derivative with respect to {0}, per unit of input squared"),
        ("d([xyz])([xyz])", "the derivative with respect to {0} and {1}, per unit of input squared"),
        ("dphase", "the derivative with respect to the phase, per turn"),
        ("f1", "the distance to the nearest feature, in units of input"),
        ("f2", "the distance to the second nearest feature, in units of input"),
        ("id", "a number drawn for the cell of the nearest feature"),
        ("([xyz])", "where the nearest feature is along {0}"),
        ("d([xyz])([12])", "the gradient of `f{1}` along {0}"),
        ("v([xyz])", "the velocity along {0}"),
        ("v([xyz])([xyz])", "the derivative of `v{0}` with respect to {1}"),
        ("displacement", "the displacement: a map of ridges and gullies"),
        ("displacement_d([xyz])", "the gradient of the displacement along {0}"),
        ("f", "the value"),
        (r"f([ab])", "the derivative with respect to {0}"),
        (r"f([ab])\1", "the second derivative with respect to {0}"),
        ("fab", "the derivative with respect to a and b"))


class Array:
    """A member: its name, and its type in C without the star"""

    def __init__(self, name, kind, comment):
        self.name, self.kind = name, kind
        self.is_of_space = "z" in name  # there is none in the plane
        self.camel = name[0].upper() + re.sub("_(.)", lambda at: at[1].upper(), name[1:])
        found = [say.format(*match.groups()) for pattern, say in SAYS
                 for match in [re.fullmatch(pattern, name)] if match] or [comment]
        if not found[0]:
            sys.exit("tables/arrays.py: neither SAYS nor the header says what %s is" % name)
        about = found[0] + (", in space" if self.is_of_space else "")
        self.about = about[0].upper() + about[1:]


def arrays(header, structure):
    """The arrays of a structure, without reserved ones"""
    return [Array(m["name"], re.sub(r"^const | \*$", "", m["type"]), m["comment"])
            for m in header.structures[structure]["members"] if not m["name"].startswith("spare")]
