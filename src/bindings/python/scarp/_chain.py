# SPDX-License-Identifier: MIT
"""Functions of scarp.h that are methods of samples. Made by src/bindings/interface.py; do
not change them by hand."""


class Chain:
    """Functions of samples, by the chain rule."""
    __slots__ = ()

    def affine(self, scale, offset=0.0):
        """`scale * self + offset`."""
        return self._chain("scarp_affine", [("scale", scale), ("offset", offset)])

    def mix(self, other, mask):
        """`self` where `mask` is 0, `other` where `mask` is 1, and `self + mask * (other - self)`
        between: slopes of `mask` count, too."""
        return self._chain("scarp_mix", [], other=other, mask=mask)

    def min(self, other):
        """The lesser of `self` and `other`, with a crease where both are equal; NaN before any
        number."""
        return self._chain("scarp_min", [], other=other)

    def max(self, other):
        """The greater of `self` and `other`, with a crease where both are equal; NaN before any
        number."""
        return self._chain("scarp_max", [], other=other)

    def smooth_min(self, other, k):
        """The lesser of `self` and `other`, without a crease: less by `k / 6` at most, where they
        differ by less than `k`."""
        return self._chain("scarp_smooth_min", [("k", k)], other=other)

    def smooth_max(self, other, k):
        """The greater of `self` and `other`, without a crease: more by `k / 6` at most, where they
        differ by less than `k`."""
        return self._chain("scarp_smooth_max", [("k", k)], other=other)

    def clamp(self, lo, hi):
        """`self`, but `lo` where it is less and `hi` where it is more, with creases there."""
        return self._chain("scarp_clamp", [("lo", lo), ("hi", hi)])

    def smooth_abs(self, round):
        """`sqrt(self^2 + round^2)`: the magnitude of `self`, with a round floor."""
        return self._chain("scarp_smooth_abs", [("round", round)])

    def smoothstep(self, lo, hi):
        """From 0 where `self` is `lo` or beyond, to 1 where it is `hi` or beyond: masks for
        mixes."""
        return self._chain("scarp_smoothstep", [("lo", lo), ("hi", hi)])

    def terrace(self, steps, riser=0.5, strength=1.0):
        """Steps in a slope: `steps` per unit of value, of which the part `riser`, in [2^-20, 1],
        rises. `strength`, in [0, 1], says how level treads are."""
        return self._chain("scarp_terrace", [("steps", steps), ("riser", riser), ("strength",
                           strength)])

    def sqrt(self):
        """The square root of `self`, and 0 where `self` is less than 0."""
        return self._chain("scarp_sqrt", [])

    def sine(self):
        """`sin(2 pi self)`: `self` counts turns."""
        return self._chain("scarp_sine", [])

    def pulse(self):
        """`self` folded to and fro between -1 and 1, with the period 2."""
        return self._chain("scarp_pulse", [])
