// SPDX-License-Identifier: MIT
//
// Times calls as tests/bindings/overhead.c does. The fastest of 21 rounds counts.
using System;
using System.Diagnostics;
using Scarp;

static class Overhead
{
    static readonly Noise noise = new Noise { Octaves = 4 }, planned = new Noise { Octaves = 4 };
    static readonly float[] x = new float[4096], y = new float[4096], value = new float[1 << 20],
        one = new float[1];

    static void Time(string name, int calls, Action round)
    {
        double best = double.MaxValue;
        for (int i = 0; i < 21; i++) {
            var watch = Stopwatch.StartNew();
            round();
            best = Math.Min(best, watch.Elapsed.TotalMilliseconds * 1e6 / calls);
        }
        Console.WriteLine(name + " " + best.ToString("F0"));
    }

    public static void Run()
    {
        planned.MakePlan(2);
        for (int i = 0; i < 4096; i++) {
            x[i] = i * 0.37f;
            y[i] = i * 0.73f;
        }
        Time("1 point, no plan", 20000, () => {
            for (int i = 0; i < 20000; i++) {
                noise.Sample2(new ReadOnlySpan<float>(x, i & 4095, 1),
                              new ReadOnlySpan<float>(y, i & 4095, 1),
                              new Samples { Value = one });
            }
        });
        Time("1 point, plan", 20000, () => {
            for (int i = 0; i < 20000; i++) {
                planned.Sample2(new ReadOnlySpan<float>(x, i & 4095, 1),
                                new ReadOnlySpan<float>(y, i & 4095, 1),
                                new Samples { Value = one });
            }
        });
        Time("1 point, plan, At", 20000, () => {
            for (int i = 0; i < 20000; i++) {
                planned.At(x[i & 4095], y[i & 4095]);
            }
        });
        Time("1 point, plan, Native", 20000, Direct);
        Time("4096 points", 50, () => {
            for (int i = 0; i < 50; i++) {
                planned.Sample2(x, y, new Samples { Value = value });
            }
        });
        Time("grid of 1024 x 1024", 1, () =>
            planned.Grid2(new Raster(1024, 1024, 0.01), new Samples { Value = value }));
    }

    static unsafe void Direct()
    {
        using (PinnedNoise pinned = planned.Pin(2))
        fixed (float* px = x, py = y, pv = value) {
            var to = new Native.scarp_samples { value = pv };
            for (int i = 0; i < 20000; i++) {
                Native.scarp_sample2(pinned.Pointer, (UIntPtr)1u, px + (i & 4095), py + (i & 4095),
                                     &to);
            }
        }
    }
}
