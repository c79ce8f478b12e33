# SPDX-License-Identifier: MIT
"""The chain rule: the functions of samples that scarp.h has, for the parts of all bindings. A
function that takes samples and numbers is written by the tables of each language, with what its
comment in the header says up to the first empty line. Nothing here has to know it."""
import re
import sys

SAMPLES, FIRST = "const struct scarp_samples *", ("count", "size_t")
INPUTS = ("a", "b", "m")

# What takes more than samples and numbers. Each binding writes these by hand.
BY_HAND = ("scarp_curve", "scarp_apply1", "scarp_apply2")
# Its members are not those of its input: some bindings write it by hand.
SLOPE = "scarp_slope"

# What Python has in the place of a number that is not given
DEFAULTS = {"affine": {"offset": "0.0"}, "terrace": {"riser": "0.5", "strength": "1.0"}}

# Numbers for the tests of bindings; other functions get the first ones of ANY.
NUMBERS = {"affine": (1.7, -0.3), "clamp": (-0.2, 0.1), "smooth_abs": (0.15,),
           "smoothstep": (0.25, -0.25), "terrace": (7, 0.4, 0.8)}
ANY = (0.3, 0.6, 0.9, 0.7)


class Function:
    """A function of samples: `inputs` and `numbers` are the names of its arguments."""

    def __init__(self, call, inputs, numbers, title):
        self.call, self.inputs, self.numbers, self.title = call, inputs, numbers, title
        self.name = call[len("scarp_"):]
        self.given = dict(zip(numbers, NUMBERS.get(self.name, ANY)))

    @property
    def camel(self):
        """smoothMin"""
        return re.sub(r"_(.)", lambda letter: letter.group(1).upper(), self.name)

    @property
    def pascal(self):
        """SmoothMin"""
        return self.camel[0].upper() + self.camel[1:]

    def about(self, names=()):
        """The title as a sentence or more. What is in backticks is code, in which arguments get
        the names of a language."""
        def named(code):
            return re.sub(r"[a-z]\w*", lambda word: dict(names).get(word.group(), word.group()),
                          code.group())

        text = re.sub("`[^`]*`", named, self.title)
        return (text[0].upper() + text[1:]).rstrip(".") + "."


def functions(header):
    """The functions that are written for bindings, in the order of the header."""
    found = []
    for call, (_, arguments) in header.functions.items():
        if arguments[:2] != [FIRST, ("a", SAMPLES)] or call in BY_HAND:
            continue
        inputs = [name for name, kind in arguments[1:-1] if kind == SAMPLES]
        numbers = [name for name, kind in arguments if kind == "float"]
        if (arguments != [FIRST] + [(name, SAMPLES) for name in inputs]
                + [(name, "float") for name in numbers] + [("out", SAMPLES)]
                or tuple(inputs) != INPUTS[:len(inputs)] or len(numbers) > len(ANY)):
            sys.exit("tables/chain.py: %s is no function of samples and at most %d numbers; is it "
                     "in BY_HAND?" % (call, len(ANY)))
        if call not in header.titles:
            sys.exit("tables/chain.py: the comment of %s does not begin with its name" % call)
        found.append(Function(call, inputs, numbers, header.titles[call]))
    return found


def described(header):
    """What interface.json says of them, for tests: a call with these numbers."""
    return {f.name: {"inputs": f.inputs, "numbers": f.given} for f in functions(header)}


def calls_in_c(header):
    """tests/bindings/chain.h: the calls that tests of bindings compare with"""
    out = ["/* SPDX-License-Identifier: MIT */",
           "/* Calls of the functions of the chain rule for samples a and b, as the tests of bindings",
           "   make them. Made by src/bindings/interface.py; do not change it by hand. */"]
    for f in functions(header):
        if f.call != SLOPE:
            inputs = ("a", "b", "a")[:len(f.inputs)]
            numbers = ["%sf" % float(number) for number in f.given.values()]
            out.append('CHAIN("%s", "%s", %s(count, %s, out))' % (
                f.name, f.camel, f.call, ", ".join([*inputs, *numbers])))
    return "\n".join(out) + "\n"
