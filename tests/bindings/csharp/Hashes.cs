// SPDX-License-Identifier: MIT
//
// Prints names and hashes of outputs as tests/bindings/hashes.c does: each call is made here, too,
// by Scarp.cs.
using System;
using System.IO;
using System.Threading.Tasks;
using Scarp;

static class Hashes
{
    const int Count = 1031, Rows = 37, Columns = 53, Most = Rows * Columns;

    static readonly float[][] array = Rows2(35, Most), x = Rows2(3, Count);
    static readonly double[][] d = new double[3][];
    static readonly uint[] id = new uint[Count];

    static readonly Noise warp = new Noise {
        Basis = Basis.Simplex, Seed = 7, Frequency = 0.02, Octaves = 2, Amplitude = 15
    };
    static readonly Noise warped = new Noise {
        Fractal = Fractal.Ridged, Rotate = true, Seed = 0xfedcba9876543210, Frequency = 0.01,
        Octaves = 6, Warp = warp
    };
    static readonly Noise tile = new Noise {
        Basis = Basis.Value, Fade = Fade.Cubic, Fractal = Fractal.Pingpong, Seed = 3,
        Frequency = 0.25, Octaves = 2.5f, Gain = 0.4f, Sharpness = 1.5f, PeriodX = 8, PeriodY = 16,
        PeriodZ = 4,
        OfOctaves = 4
    };
    static readonly Noise flowing = new Noise {
        Seed = 5, Octaves = 3, Phase = 0.3f, OffsetFirst = true
    };
    static readonly Noise worley = new Noise { Basis = Basis.CellF1, Seed = 9, Jitter = 0.75f };

    static readonly Raster grid = new Raster(Columns, Rows) {
        OriginX = -3, OriginY = 5, StepX = 0.5, StepY = -0.25, FirstX = -20, FirstY = 7
    };

    static float[][] Rows2(int rows, int columns)
    {
        var made = new float[rows][];
        for (int i = 0; i < rows; i++) {
            made[i] = new float[columns];
        }
        return made;
    }

    // FNV-1a of the first arrays, so many elements of each
    static void Tell(string name, int arrays, int elements)
    {
        ulong hash = 0xcbf29ce484222325;
        var bytes = new byte[4 * elements];
        for (int a = 0; a < arrays; a++) {
            Buffer.BlockCopy(array[a], 0, bytes, 0, bytes.Length);
            foreach (byte b in bytes) {
                hash = (hash ^ b) * 0x100000001b3;
            }
        }
        Console.WriteLine(name + " " + hash.ToString("x16"));
        foreach (float[] of in array) {
            Array.Clear(of, 0, of.Length);
        }
    }

    static Samples Plane(int first)
    {
        return new Samples {
            Value = array[first], Dx = array[first + 1], Dy = array[first + 2],
            Dxx = array[first + 3], Dxy = array[first + 4], Dyy = array[first + 5]
        };
    }

    static Samples Space()
    {
        return new Samples {
            Value = array[0], Dx = array[1], Dy = array[2], Dz = array[3], Dxx = array[4],
            Dxy = array[5], Dxz = array[6], Dyy = array[7], Dyz = array[8], Dzz = array[9],
            Dphase = array[10]
        };
    }

    static void Points()
    {
        warped.Sample2(x[0], x[1], Plane(0));
        Tell("sample2", 6, Count);
        warped.Sample2(d[0], d[1], Plane(0));
        Tell("sample2_f64", 6, Count);
        flowing.Sample3(x[0], x[1], x[2], Space());
        Tell("sample3", 11, Count);
        flowing.MakePlan(3); // which changes no bit
        flowing.Sample3(d[0], d[1], d[2], Space());
        Tell("sample3_f64", 11, Count);
        warp.Vector2(x[0], x[1], Plane(0), Plane(6));
        Tell("vector2", 12, Count);
        worley.Cells2(d[0], d[1], new Cells {
            F1 = array[0], F2 = array[1], Id = id, X = array[3], Y = array[4], Dx1 = array[5],
            Dy1 = array[6], Dx2 = array[7], Dy2 = array[8]
        });
        Buffer.BlockCopy(id, 0, array[2], 0, 4 * Count);
        Tell("cells2_f64", 9, Count);
        flowing.Curl3(x[0], x[1], x[2], new Flow { Vx = array[0], Vy = array[1], Vz = array[2] });
        Tell("curl3", 3, Count);
    }

    // Rows in threads, as jobs take them, by a pinned noise
    static unsafe void Bands()
    {
        using (PinnedNoise pinned = warped.Pin(2)) {
            Parallel.For(0, (Rows + 7) / 8, band => {
                int row = 8 * band, rows = Math.Min(8, Rows - row);
                Native.scarp_grid part = grid.Band(row, rows).ToNative();
                long at = grid.Offset(row);
                fixed (float* value = array[0], dx = array[1], dy = array[2], dxx = array[3],
                       dxy = array[4], dyy = array[5]) {
                    var to = new Native.scarp_samples {
                        value = value + at, dx = dx + at, dy = dy + at, dxx = dxx + at,
                        dxy = dxy + at, dyy = dyy + at
                    };
                    if (Native.scarp_grid2(pinned.Pointer, &part, &to) != Status.Ok) {
                        throw new Exception("a band failed");
                    }
                }
            });
        }
    }

    static unsafe void Gullies()
    {
        var gullies = new Native.scarp_gullies {
            seed = 4, frequency = 0.02, depth = 0.3f, offset_first = 1
        };
        Native.scarp_grid native = grid.ToNative();
        fixed (float* b0 = array[6], b1 = array[7], b2 = array[8], b3 = array[9], b4 = array[10],
               b5 = array[11], o0 = array[0], o1 = array[1], o2 = array[2], o3 = array[3],
               o4 = array[4], o5 = array[5]) {
            var of = new Native.scarp_samples {
                value = b0, dx = b1, dy = b2, dxx = b3, dxy = b4, dyy = b5
            };
            var to = new Native.scarp_eroded {
                value = o0, dx = o1, dy = o2, displacement = o3, displacement_dx = o4,
                displacement_dy = o5
            };
            if (Native.scarp_gullies_grid2(&gullies, &native, &of, &to) != Status.Ok) {
                throw new Exception("gullies failed");
            }
        }
    }

    static void Grids(string recipeText)
    {
        Bands();
        Tell("grid2", 6, Most);
        tile.Grid3(new Raster(11, 13, slices: 7) {
            OriginX = 1, OriginY = 2, OriginZ = 3, StepX = 0.125, StepY = 0.25, StepZ = 0.5,
            FirstX = 1, FirstY = -2, FirstZ = 3
        }, new Samples { Value = array[0], Dx = array[1], Dy = array[2], Dz = array[3] });
        Tell("grid3", 4, 11 * 13 * 7);

        var below = new Noise { Seed = 4, Frequency = 0.02, Octaves = 2 };
        below.Grid2(grid, Plane(6));
        Gullies();
        Tell("gullies_grid2", 6, Most);

        below.Grid2(grid, Plane(6));
        warped.Grid2(grid, Plane(12));
        Samples.SmoothMax(Most, Plane(6), Plane(12), 0.25f, Plane(0));
        Samples.Multiply(Most, Plane(0), Plane(12), Plane(0));
        Samples.Affine(Most, Plane(0), 3, -1, Plane(0));
        Tell("chain", 6, Most);
        warped.Grid2(grid, Plane(12));
        Samples.Normals(array[13], array[14], 20, array[0], array[1], array[2]);
        Tell("normals", 3, Most);

        var recipe = new Recipe(recipeText, 8);
        recipe["height"] = 900;
        recipe.Grid(grid, new Samples { Value = array[0], Dx = array[1], Dy = array[2] },
                    recipe.Outputs[0],
                    new Samples { Value = array[3], Dx = array[4], Dy = array[5] },
                    recipe.Outputs[1]);
        Tell("recipe_grid", 6, Most);
        recipe.Sample2(x[0], x[1], new Samples { Value = array[0], Dx = array[1], Dy = array[2] });
        recipe.Sample2(x[0], x[1], new Samples { Value = array[3], Dx = array[4], Dy = array[5] },
                       recipe.Outputs[1]);
        Tell("recipe_sample", 6, Count);
    }

    static void Functions()
    {
        for (int i = 0; i < Chain.Names.Length; i++) {
            warp.Sample2(x[0], x[1], Plane(6));
            warped.Sample2(x[0], x[1], Plane(12));
            Chain.Calls[i](Count, Plane(6), Plane(12), Plane(0));
            Tell(Chain.Names[i], 6, Count);
        }
    }

    public static void Run(string recipe)
    {
        for (int axis = 0; axis < 3; axis++) {
            d[axis] = new double[Count];
            for (int i = 0; i < Count; i++) { // exact in floats
                d[axis][i] = i * (7 + 4 * axis) % 1024 * 0.375 - 100.0 * axis;
                x[axis][i] = (float)d[axis][i];
            }
        }
        Points();
        Grids(File.ReadAllText(recipe));
        Functions();
    }
}
