# SPDX-License-Identifier: MIT
"""Checks of numbers, before C would wrap, round or misread them."""
import numbers
import operator

import numpy as np

from ._library import ScarpError

LIMIT = 2 ** 53


def is_number(value):
    """Whether a value is a real number; truth is none."""
    return isinstance(value, numbers.Real) and not isinstance(value, (bool, np.bool_))


def number(name, value):
    """A real number as a float. Raises TypeError for what is none."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if not is_number(value):
        raise TypeError("%s must be a number, not %s" % (name, type(value).__name__))
    try:
        return float(value)
    except OverflowError:
        raise ScarpError("out of range: %r" % (value,), name) from None


def single(name, value):
    """A number that C holds as a float, as it is there. Raises ScarpError for what is not finite
    there, or would become 0."""
    value = number(name, value)
    with np.errstate(all="ignore"):
        rounded = float(np.float32(value))
    if not np.isfinite(rounded):
        raise ScarpError("not a finite float: %r" % value, name)
    if rounded == 0 and value != 0:
        raise ScarpError("too small for a float: %r" % value, name)
    return rounded


def member(name, value, kind):
    """A member of a description, which must not be 0: C takes that for the default."""
    value = single(name, value) if kind == "f4" else number(name, value)
    if value == 0:
        raise ScarpError("must not be 0. Leave it out, or give None, for the default", name)
    return value


def integer(name, value, least, most):
    """An integer in [least, most]. Raises ScarpError for fractions and outside, TypeError for what
    is no number."""
    if isinstance(value, (bool, np.bool_)):
        raise TypeError("%s must be an integer, not bool" % name)
    if isinstance(value, numbers.Real) and not isinstance(value, numbers.Integral):
        if not float(value).is_integer() or abs(value) > LIMIT:
            raise ScarpError("an integer is needed, not %r" % (value,), name)
        value = int(value)
    try:
        value = operator.index(value)
    except TypeError:
        raise TypeError("%s must be an integer, not %s" % (name, type(value).__name__)) from None
    if not least <= value <= most:
        raise ScarpError("%d is not in [%d, %d]" % (value, least, most), name)
    return value


def seed_of(value):
    """A seed: all 64 bits count, so a negative one is 2^64 more."""
    return integer("seed", value, -2 ** 63, 2 ** 64 - 1) % 2 ** 64


def several(name, values, count):
    """A sequence of so many values. Raises TypeError for anything else."""
    if isinstance(values, (str, bytes)) or not hasattr(values, "__len__"):
        raise TypeError("%s must be a sequence of %d numbers" % (name, count))
    if len(values) != count:
        raise ScarpError("%d numbers are needed, not %d" % (count, len(values)), name)
    return list(values)


def order(derivatives, most=2):
    """How many derivatives: 0, 1 or 2."""
    if type(derivatives) is int and 0 <= derivatives <= most:
        return derivatives
    if derivatives is True or derivatives is False:
        raise TypeError("derivatives must be 0, 1 or 2: the order, not True or False")
    return integer("derivatives", derivatives, 0, most)
