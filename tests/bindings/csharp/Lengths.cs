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

    static readonly string[] samples = {
        "Value", "Dx", "Dy", "Dz", "Dxx", "Dxy", "Dxz", "Dyy", "Dyz", "Dzz", "Dphase"
    };
    static readonly string[] cells = {
        "F1", "F2", "X", "Y", "Z", "Dx1", "Dy1", "Dz1", "Dx2", "Dy2", "Dz2", "Id"
    };
    static readonly string[] flow = {
        "Vx", "Vy", "Vz", "Vxx", "Vxy", "Vxz", "Vyx", "Vyy", "Vyz", "Vzx", "Vzy", "Vzz"
    };
    static readonly float[] x = new float[Count];

    // The one array among others that are long enough
    static Span<float> If(bool isThis, Span<float> array)
    {
        return isThis ? array : new float[Count];
    }

    static Samples SamplesOf(int i, Span<float> a)
    {
        return new Samples {
            Value = If(i == 0, a), Dx = If(i == 1, a), Dy = If(i == 2, a), Dz = If(i == 3, a),
            Dxx = If(i == 4, a), Dxy = If(i == 5, a), Dxz = If(i == 6, a), Dyy = If(i == 7, a),
            Dyz = If(i == 8, a), Dzz = If(i == 9, a), Dphase = If(i == 10, a)
        };
    }

    static Cells CellsOf(int i, Span<float> a)
    {
        return new Cells {
            F1 = If(i == 0, a), F2 = If(i == 1, a), X = If(i == 2, a), Y = If(i == 3, a),
            Z = If(i == 4, a), Dx1 = If(i == 5, a), Dy1 = If(i == 6, a), Dz1 = If(i == 7, a),
            Dx2 = If(i == 8, a), Dy2 = If(i == 9, a), Dz2 = If(i == 10, a),
            Id = MemoryMarshal.Cast<float, uint>(If(i == 11, a))
        };
    }

    static Flow FlowOf(int i, Span<float> a)
    {
        return new Flow {
            Vx = If(i == 0, a), Vy = If(i == 1, a), Vz = If(i == 2, a), Vxx = If(i == 3, a),
            Vxy = If(i == 4, a), Vxz = If(i == 5, a), Vyx = If(i == 6, a), Vyy = If(i == 7, a),
            Vyz = If(i == 8, a), Vzx = If(i == 9, a), Vzy = If(i == 10, a), Vzz = If(i == 11, a)
        };
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
        for (int i = 0; i < samples.Length; i++) {
            Try("to." + samples[i], a => noise.Sample3(x, x, x, SamplesOf(i, a)));
            Try("first." + samples[i], a =>
                noise.Vector3(x, x, x, SamplesOf(i, a), SamplesOf(0, new float[Count]),
                              SamplesOf(0, new float[Count])));
        }
        for (int i = 0; i < 12; i++) {
            Try("to." + cells[i], a => noise.Cells3(x, x, x, CellsOf(i, a)));
            Try("to." + flow[i], a => noise.Curl3(x, x, x, FlowOf(i, a)));
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
