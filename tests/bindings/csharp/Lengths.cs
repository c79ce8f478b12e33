// SPDX-License-Identifier: MIT
//
// Each array of each structure is refused where it is too short by one element, and where it
// overlaps a coordinate: else the library would write to memory of others.
using System;
using System.Runtime.InteropServices;
using Scarp;

static class Lengths
{
    const int Count = 4;

    static readonly float[] x = new float[Count];

    // The one array among others that are long enough
    public static Span<float> If(bool isThis, Span<float> array)
    {
        return isThis ? array : new float[Count];
    }

    // Calls with an array that is long enough, then with one that is too short by one element.
    static void Try(string name, Action<float[]> call)
    {
        call(new float[Count]);
        try {
            call(new float[Count - 1]);
        } catch (ArgumentException error) {
            if (error.ParamName != name) {
                throw new Exception("a short " + name + " gives " + error);
            }
            return;
        }
        throw new Exception("a short " + name + " passes");
    }

    static void Refuse(string name, Action call)
    {
        try {
            call();
        } catch (ArgumentException error) {
            if (error.ParamName != name) {
                throw new Exception(name + " gives " + error);
            }
            return;
        }
        throw new Exception(name + " passes, though it is too short or overlaps");
    }

    static void Members()
    {
        var noise = new Noise();
        for (int i = 0; i < Spans.Samples.Length; i++) {
            Try("to." + Spans.Samples[i], a => noise.Sample3(x, x, x, Spans.SamplesOf(i, a)));
            Try("first." + Spans.Samples[i], a =>
                noise.Vector3(x, x, x, Spans.SamplesOf(i, a), Spans.SamplesOf(0, new float[Count]),
                              Spans.SamplesOf(0, new float[Count])));
        }
        for (int i = 0; i < 12; i++) {
            Try("to." + Spans.Cells[i], a => noise.Cells3(x, x, x, Spans.CellsOf(i, a)));
            Try("to." + Spans.Flow[i], a => noise.Curl3(x, x, x, Spans.FlowOf(i, a)));
        }
    }

    // Outputs that begin in the last of so many doubles
    static void Doubles()
    {
        var noise = new Noise();
        var wide = new double[2 * Count];
        Refuse("to.Value", () => noise.Sample2(
            new Span<double>(wide, 0, Count), new double[Count],
            new Samples {
                Value = MemoryMarshal.Cast<double, float>(wide).Slice(2 * Count - 1, Count)
            }));
        Refuse("to.F1", () => noise.Cells2(
            new double[Count], new Span<double>(wide, 0, Count),
            new Cells {
                F1 = MemoryMarshal.Cast<double, float>(wide).Slice(2 * Count - 1, Count)
            }));
        noise.Sample2(new Span<double>(wide, 0, Count), new double[Count],
                      new Samples {
                          Value = MemoryMarshal.Cast<double, float>(wide).Slice(2 * Count)
                      });
    }

    // Grids with gaps between rows and slices: the length, and where samples are
    static void Gaps()
    {
        var noise = new Noise { Seed = 3 };
        var dense = new Raster(3, 2, 0.3, 2);
        float[] a = new float[12], b = new float[34];
        noise.Grid3(dense, new Samples { Value = a });
        Raster loose = dense;
        loose.RowStride = 5;
        Refuse("to.Value", () => noise.Grid3(loose, new Samples { Value = new float[17] }));
        noise.Grid3(loose, new Samples { Value = new float[18] });
        loose.SliceStride = 20;
        Refuse("to.Value", () => noise.Grid3(loose, new Samples { Value = new float[27] }));
        noise.Grid3(loose, new Samples { Value = b });
        for (int i = 0; i < 12; i++) {
            if (a[i] != b[i / 6 * 20 + i / 3 % 2 * 5 + i % 3]) {
                throw new Exception("strides put samples in other places");
            }
        }
        if (loose.Offset(1) != 5 || dense.Offset(1) != 3) {
            throw new Exception("a row begins elsewhere");
        }
    }

    public static void Run()
    {
        Members();
        Doubles();
        Gaps();
    }
}
