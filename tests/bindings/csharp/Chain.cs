// SPDX-License-Identifier: MIT
//
// The calls of tests/bindings/chain.h. Made by src/bindings/interface.py; do not change it by hand.
using Scarp;

static class Chain
{
    public delegate void Call(int count, in Samples a, in Samples b, in Samples to);

    public static readonly string[] Names = {
        "affine", "add", "multiply", "mix", "min", "max", "smooth_min", "smooth_max", "clamp",
        "abs", "smooth_abs", "smoothstep", "terrace", "divide", "sqrt", "sine", "pulse"
    };
    public static readonly Call[] Calls = {
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Affine(n, a, 1.7f, -0.3f, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Add(n, a, b, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Multiply(n, a, b, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Mix(n, a, b, a, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Min(n, a, b, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Max(n, a, b, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.SmoothMin(n, a, b, 0.3f, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.SmoothMax(n, a, b, 0.3f, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Clamp(n, a, -0.2f, 0.1f, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Abs(n, a, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.SmoothAbs(n, a, 0.15f, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Smoothstep(n, a, 0.25f, -0.25f, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Terrace(n, a, 7.0f, 0.4f, 0.8f, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Divide(n, a, b, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Sqrt(n, a, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Sine(n, a, to),
        (int n, in Samples a, in Samples b, in Samples to) =>
            Samples.Pulse(n, a, to),
    };
}
