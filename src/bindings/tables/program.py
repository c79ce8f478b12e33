# SPDX-License-Identifier: MIT
"""The defaults and intervals of a noise for the options of the program."""

PATH = "src/cli/shared/members.h"
HEAD = """\
/* SPDX-License-Identifier: MIT
 *
 * Defaults and intervals of struct scarp_noise. Of intervals that depend on the fractal, this has
 * the narrowest. Made by src/bindings/interface.py of include/scarp.h; do not change it by hand.
 */
#ifndef SCARP_CLI_MEMBERS_H
#define SCARP_CLI_MEMBERS_H

"""


def literal(number):
    """A number of C: as a power of two where it is one that has many digits."""
    text = "%.9g" % number
    mantissa, _, exponent = number.hex().partition("p")
    return text if float(text) == number and len(text) < 8 else (
        mantissa.replace(".0000000000000", "") + "p" + exponent.lstrip("+"))


def table(header):
    """The content of members.h."""
    out = []
    for m in header.structures["scarp_noise"]["members"]:
        name = "NOISE_" + m["name"].upper()
        if m["default"] is not None:
            out.append("#define %s_DEFAULT %s" % (name, literal(m["default"])))
        if m["intervals"]:
            lowest, highest = min(m["intervals"], key=lambda pair: pair[1] - pair[0])
            out.append("#define %s_BOUNDS %s, %s" % (name, literal(lowest), literal(highest)))
    return HEAD + "\n".join(out) + "\n\n#endif\n"


def made(header, _):
    """The file, by its path."""
    yield PATH, table(header)
