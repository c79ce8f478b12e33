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

static class Spans
{
    public static readonly string[] Samples = {
        "Value", "Dx", "Dy", "Dz", "Dxx", "Dxy", "Dxz", "Dyy", "Dyz", "Dzz", "Dphase"
    };

    public static Samples SamplesOf(int i, System.Span<float> a)
    {
        return new Samples {
            Value = Lengths.If(i == 0, a),
            Dx = Lengths.If(i == 1, a),
            Dy = Lengths.If(i == 2, a),
            Dz = Lengths.If(i == 3, a),
            Dxx = Lengths.If(i == 4, a),
            Dxy = Lengths.If(i == 5, a),
            Dxz = Lengths.If(i == 6, a),
            Dyy = Lengths.If(i == 7, a),
            Dyz = Lengths.If(i == 8, a),
            Dzz = Lengths.If(i == 9, a),
            Dphase = Lengths.If(i == 10, a),
        };
    }

    public static readonly string[] Cells = {
        "F1", "F2", "Id", "X", "Y", "Z", "Dx1", "Dy1", "Dz1", "Dx2", "Dy2", "Dz2"
    };

    public static Cells CellsOf(int i, System.Span<float> a)
    {
        return new Cells {
            F1 = Lengths.If(i == 0, a),
            F2 = Lengths.If(i == 1, a),
            Id = System.Runtime.InteropServices.MemoryMarshal.Cast<float, uint>(Lengths.If(i == 2, a)),
            X = Lengths.If(i == 3, a),
            Y = Lengths.If(i == 4, a),
            Z = Lengths.If(i == 5, a),
            Dx1 = Lengths.If(i == 6, a),
            Dy1 = Lengths.If(i == 7, a),
            Dz1 = Lengths.If(i == 8, a),
            Dx2 = Lengths.If(i == 9, a),
            Dy2 = Lengths.If(i == 10, a),
            Dz2 = Lengths.If(i == 11, a),
        };
    }

    public static readonly string[] Flow = {
        "Vx", "Vy", "Vz", "Vxx", "Vxy", "Vxz", "Vyx", "Vyy", "Vyz", "Vzx", "Vzy", "Vzz"
    };

    public static Flow FlowOf(int i, System.Span<float> a)
    {
        return new Flow {
            Vx = Lengths.If(i == 0, a),
            Vy = Lengths.If(i == 1, a),
            Vz = Lengths.If(i == 2, a),
            Vxx = Lengths.If(i == 3, a),
            Vxy = Lengths.If(i == 4, a),
            Vxz = Lengths.If(i == 5, a),
            Vyx = Lengths.If(i == 6, a),
            Vyy = Lengths.If(i == 7, a),
            Vyz = Lengths.If(i == 8, a),
            Vzx = Lengths.If(i == 9, a),
            Vzy = Lengths.If(i == 10, a),
            Vzz = Lengths.If(i == 11, a),
        };
    }
}
