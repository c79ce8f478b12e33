// SPDX-License-Identifier: MIT
//
// Mistakes in calls of Scarp.cs, and the exceptions that tell of them.
using System;
using System.Collections.Generic;
using System.Reflection;
using System.Threading;
using System.Threading.Tasks;
using Scarp;

static class Mistakes
{
    static readonly float[] four = new float[4], other = new float[4], third = new float[4],
        three = new float[3], missing = null;
    static readonly double[] wide = new double[4];
    static int count;

    // Runs a mistake, and sees that the exception is of this type and names what it should.
    static void Expect<T>(string member, Action mistake, Status status = Status.Ok,
                          string text = "") where T : Exception
    {
        count++;
        try {
            mistake();
        } catch (T error) {
            var ours = error as ScarpException;
            var argument = error as ArgumentException;
            string told = ours != null ? ours.Member : argument != null ? argument.ParamName
                : member;
            if (told != member || ours != null && ours.Status != status
                || error.Message.IndexOf(text, StringComparison.Ordinal) < 0) {
                throw new Exception("mistake " + count + ", of " + member + ", gives " + error);
            }
            return;
        }
        throw new Exception("mistake " + count + ", of " + member + ", passes");
    }

    static void Arrays()
    {
        var noise = new Noise();
        Expect<ArgumentException>("to.Value", () =>
            noise.Sample2(four, other, new Samples { Value = three }), text: "3 elements, and 4");
        Expect<ArgumentException>("to.Dy", () =>
            noise.Sample2(wide, wide, new Samples { Value = four, Dy = three }));
        Expect<ArgumentException>("to.Dz", () =>
            noise.Sample2(four, other, new Samples { Dz = third }));
        Expect<ArgumentException>("to", () => noise.Sample2(four, other, new Samples()));
        Expect<ArgumentException>("y", () => noise.Sample2(four, three,
                                                           new Samples { Value = third }));
        Expect<ArgumentException>("y", () => noise.Sample2(missing, four,
                                                           new Samples { Value = third }));
        Expect<ArgumentException>("y", () => noise.Sample2(four, missing,
                                                           new Samples { Value = third }));
        Expect<ArgumentException>("z", () =>
            noise.Sample3(four, four, missing, new Samples { Value = third }));
        Expect<ArgumentException>("to.Dx", () =>
            noise.Sample2(four, other, new Samples { Value = third, Dx = third }),
            text: "overlaps");
        Expect<ArgumentException>("to.Value", () =>
            noise.Sample2(new Span<float>(new float[8], 0, 4), four, default(Samples),
                          new float[8]));
        Expect<ArgumentException>("second.Value", () =>
            noise.Vector2(four, other, new Samples { Value = third },
                          new Samples { Value = three }));
        Expect<ArgumentException>("to.Value", () =>
            noise.Vector2(four, other, new Samples { Value = third },
                          new Samples { Value = third }));
        Expect<ArgumentException>("to.Id", () => noise.Cells2(four, other,
                                                              new Cells { Id = new uint[1] }));
        Expect<ArgumentException>("to.Z", () => noise.Cells2(four, other, new Cells { Z = third }));
        Expect<ArgumentException>("to", () => noise.Cells3(four, four, four, new Cells()));
        Expect<ArgumentException>("to.Vzz", () => noise.Curl2(four, other,
                                                              new Flow { Vzz = third }));
        Expect<ArgumentException>("to.Vx", () => noise.Curl2(four, other, new Flow { Vx = three }));
        Expect<ArgumentException>("to.Vy", () =>
            noise.Curl2(wide, wide, new Flow { Vx = third, Vy = third }));
        Expect<ArgumentException>("to.Value", () =>
            noise.Grid2(new Raster(2, 3), new Samples { Value = new float[5] }),
            text: "6 are needed");
        Expect<ArgumentException>("to.Value", () =>
            noise.Grid2(new Raster(2, 3) { RowStride = 10 },
                        new Samples { Value = new float[21] }));
        Expect<ArgumentException>("to.Value", () =>
            noise.Grid3(new Raster(2, 3, slices: 2), new Samples { Value = new float[11] }));
        Expect<ArgumentException>("grid.Rows", () => noise.Grid2(new Raster(1, -1), new Samples()));
        Expect<ArgumentOutOfRangeException>("row", () => new Raster(4, 4).Band(3, 2));
        Expect<ArgumentException>("a.Value", () => Samples.Abs(4, new Samples { Value = three },
                                                               new Samples { Value = four }));
        Expect<ArgumentException>("a", () => Samples.Abs(4, new Samples { Dx = third },
                                                         new Samples { Value = four }));
        Expect<ScarpException>("lo, hi", () => Samples.Clamp(4, new Samples { Value = third }, 1, 0,
                                                             new Samples { Value = four }),
                               Status.Parameter);
        Expect<ArgumentException>("dy", () => Samples.Normals(four, three, 1, third, third, third));
        Expect<ArgumentException>("nz", () => Samples.Normals(four, other, 1, null, null, three));
        Expect<ScarpException>("heightScale", () =>
            Samples.Normals(four, other, float.NaN, third, null, null), Status.Parameter);
        Expect<ArgumentException>("ny", () => Samples.Normals(four, other, 1, third, third, null),
                                  text: "overlaps with nx");
        Expect<ArgumentException>("nx", () => Normals(new float[8]), text: "an input");
        Expect<ArgumentException>("to.Value", () => Curve(new float[9], 3), text: "overlaps");
        Expect<ArgumentException>("to.Dx", () =>
            noise.Grid2(new Raster(2, 2) { RowStride = 3 },
                        new Samples { Value = new float[5], Dx = third }));
        Expect<ArgumentException>("to.Dx", () => InGaps(noise, 1), text: "overlaps");
        Expect<ArgumentException>("to.Dx", () =>
            noise.Grid2(new Raster(2, 2) { SliceStride = 9 },
                        new Samples { Value = third, Dx = third }), text: "overlaps");
        // none of these: outputs in the place of an input and beside it, gaps between rows, nothing
        InGaps(noise, 2);
        Curve(new float[9], 5);
        Samples.Normals(four, other, 1, four, other, third);
        var whole = new float[12];
        new Recipe("recipe 1\nout a = x").Sample2(
            new Span<float>(whole, 0, 4), new Span<float>(whole, 4, 4),
            new Samples { Value = new Span<float>(whole, 8, 4) });
        noise.Cells2(new Span<float>(whole, 0, 4), new Span<float>(whole, 4, 4),
                     new Cells { F1 = new Span<float>(whole, 8, 4) });
        noise.Sample2(four, other, new Samples { Value = four });
        noise.Grid2(new Raster(2, 2) { RowStride = 3 }, new Samples { Value = new float[5] });
        noise.Sample2(missing, missing, new Samples());
        noise.Grid2(new Raster(0, 5), new Samples());
    }

    // An output that begins in the middle of a coordinate
    static void Sample2(this Noise noise, Span<float> x, float[] y, Samples unused, float[] whole)
    {
        noise.Sample2(new Span<float>(whole, 0, 4), y,
                      new Samples { Value = new Span<float>(whole, 2, 4) });
    }

    // Rows of two outputs in one array, of which the second one begins so many elements behind
    static void InGaps(Noise noise, int behind)
    {
        var whole = new float[8];
        noise.Grid2(new Raster(2, 2) { RowStride = 4 }, new Samples {
            Value = new Span<float>(whole, 0, 6), Dx = new Span<float>(whole, behind, 6)
        });
    }

    // Knots, and an output that begins behind so many elements
    static void Curve(float[] whole, int behind)
    {
        for (int i = 0; i < whole.Length; i++) {
            whole[i] = i;
        }
        Samples.Curve(4, new Samples { Value = four }, new Span<float>(whole, 1, 4), new float[4],
                      new Samples { Value = new Span<float>(whole, behind, 4) });
    }

    // A normal that begins in the middle of a gradient
    static void Normals(float[] whole)
    {
        Samples.Normals(new Span<float>(whole, 0, 4), other, 1, new Span<float>(whole, 2, 4), null,
                        null);
    }

    static void Members()
    {
        Expect<ScarpException>("Octaves", () => new Noise { Octaves = 0 }, Status.Parameter);
        Expect<ScarpException>("Frequency", () => new Noise { Frequency = 0 }, Status.Parameter);
        Expect<ScarpException>("Octaves", () => new Noise { Octaves = 40 }.Check(2),
                               Status.Parameter);
        Expect<ScarpException>("Gain", () =>
            new Noise { Gain = float.NaN }.At(1, 2), Status.Parameter);
        Expect<ScarpException>("Basis", () => new Noise { Basis = (Basis)99 }.At(1, 2),
                               Status.Enum);
        Expect<ScarpException>("Fractal", () =>
            new Noise { Fractal = (Fractal)(-1) }.Grid2(new Raster(1, 1),
            new Samples { Value = four }), Status.Enum);
        Expect<ScarpException>("OfOctaves", () =>
            new Noise { Octaves = 3, OfOctaves = 2 }.Range(2), Status.Parameter);
        Expect<ScarpException>("PeriodY", () =>
            new Noise { Basis = Basis.Simplex, PeriodY = 4 }.Pin(2), Status.Unsupported);
        Expect<ScarpException>("Phase", () =>
            new Noise { Basis = Basis.Value, Phase = 0.5f }.MakePlan(2), Status.Unsupported);
        Expect<ArgumentOutOfRangeException>("dimensions", () => new Noise().Range(4));

        var bend = new Noise { Amplitude = 1e9f };
        Expect<ScarpException>("Warp.Amplitude", () => new Noise { Warp = bend }.At(0, 0),
                               Status.Parameter);
        Expect<ScarpException>("Warp.Warp.Amplitude", () =>
            new Noise { Warp = new Noise { Warp = bend } }.Check(3), Status.Parameter);
        var loop = new Noise();
        loop.Warp = loop;
        Expect<ScarpException>("Warp.Warp.Warp.Warp.Warp", () => loop.At(0, 0),
                               Status.Unsupported, "there are more than four warps");

        var swiss = new Noise { Fractal = Fractal.Swiss };
        Expect<ScarpException>("Dxx", () =>
            swiss.Sample2(wide, wide, new Samples { Value = four, Dyy = third }),
            Status.Unsupported);
        Expect<ScarpException>("Dxx", () => new Noise { Warp = swiss }.Sample2(
            wide, wide, new Samples { Value = four, Dyy = third }), Status.Unsupported);
        Expect<ScarpException>("Dphase", () => new Noise { Basis = Basis.Value }.Sample2(
            wide, wide, new Samples { Dphase = four }), Status.Unsupported);
        Expect<ScarpException>("Dxx", () => swiss.Sample2(
            wide, wide, new Samples { Dphase = four, Dxy = third }), Status.Unsupported);
        Expect<ScarpException>("Dphase", () => new Noise { Basis = Basis.Value }.Sample2(
            wide, wide, new Samples { Dphase = four, Dxy = third }), Status.Unsupported);
        Expect<ScarpException>("Vxx", () => swiss.Curl2(wide, wide, new Flow { Vxy = four }),
                               Status.Unsupported);
        Expect<ScarpException>("order", () => swiss.ShaderAnswers(2, 2), Status.Unsupported);
        Expect<ScarpException>("order", () => new Noise().ShaderAnswers(2, 3), Status.Parameter);
        Expect<ScarpException>("Warp", () => new Noise {
            Octaves = 20, Warp = new Noise { Octaves = 20 }
        }.ShaderAnswers(2, 0), Status.Unsupported);
        Expect<ScarpException>("isa", () => Library.Select((Isa)77), Status.Enum);
    }

    static void Pinned()
    {
        PinnedNoise pinned = new Noise { Warp = new Noise() }.Pin(2);
        if (pinned.Address == IntPtr.Zero) {
            throw new Exception("a pinned noise is nowhere");
        }
        pinned.Dispose();
        pinned.Dispose();
        Expect<ObjectDisposedException>(null, () => { IntPtr gone = pinned.Address; });
        PinnedRecipe recipe = new Recipe("recipe 1\nout a = x").Pin();
        recipe.Dispose();
        Expect<ObjectDisposedException>(null, () => { IntPtr gone = recipe.Address; });
    }

    static void Recipes()
    {
        Expect<ArgumentNullException>("text", () => new Recipe(null));
        Expect<ScarpException>("text", () => new Recipe(new string(' ', 20000)), Status.Size);
        try {
            new Recipe("recipe 1\nout a = noise(size=100, octaves=99)\nout b = nothing");
            throw new Exception("a recipe with errors passes");
        } catch (RecipeException error) {
            count++;
            if (error.Errors.Count != 2 || error.Line != 2 || error.Column != 33
                || error.Errors[0].Member != "octaves" || error.Errors[1].Line != 3
                || !error.Message.StartsWith("line 2, column 33: octaves: ")) {
                throw new Exception("the recipe's error is " + error);
            }
        }
        var recipe = new Recipe("recipe 1\nparam h = 2 [1, 3]\nparam k = 1\n"
                                + "low = noise(swiss, size=9)\n"
                                + "out a = h * noise(size=10, octaves=k)\nout b = x + low\n");
        Expect<ScarpException>("h", () => recipe["h"] = 4, Status.Parameter, "[1, 3]");
        Expect<KeyNotFoundException>(null, () => recipe["a"] = 1, text: "h, k");
        Expect<RecipeException>(null, () => recipe["k"] = 99, Status.Parameter, "line 5");
        Expect<RecipeException>(null, () => recipe.Tile(5, 5), Status.Parameter, "line 6");
        Expect<ScarpException>("Tile", () => recipe.Tile(5, -5), Status.Parameter);
        Expect<ScarpException>("Scale", () => recipe.Scale(0), Status.Parameter);
        Expect<ArgumentException>("output", () => recipe.Info("h"), text: "a, b");
        Expect<ArgumentException>("output", () =>
            recipe.Grid(new Raster(2, 2), new Samples { Value = four }, "h"), text: "a, b");
        Expect<ScarpException>("to", () =>
            recipe.Grid(new Raster(2, 2), new Samples { Dxx = four }, "low"), Status.Unsupported);
        Expect<ArgumentException>("to.Value", () =>
            recipe.Sample2(four, four, new Samples { Value = four }), text: "overlaps");
        Expect<ArgumentException>("to.Value", () =>
            recipe.Grid(new Raster(2, 2), new Samples { Value = three }));
        Expect<ArgumentException>("z", () =>
            recipe.Sample3(four, four, four, new Samples { Value = third }));
        Expect<ScarpException>("box", () => recipe.Range("b", new Box { LowestX = 1 }),
                               Status.Parameter);
        Expect<ScarpException>("grid", () =>
            recipe.Grid(new Raster(2, 2, double.NaN), new Samples { Value = four }),
            Status.Parameter);
        if (recipe["h"] != 2 || recipe["k"] != 1 || recipe.Parameters.Count != 2
            || recipe.Parameters["h"].Highest != 3 || recipe.Dimensions != 2
            || string.Join(" ", recipe.Outputs) != "a b"
            || new Recipe("recipe 1\nspace 3\nout a = z").Dimensions != 3) {
            throw new Exception("the recipe tells something else than its text");
        }
        recipe["h"] = 3;
        recipe.Finest = 0.25;
        recipe.Seed = 5;
        recipe["k"] = 2;
        if (recipe.Range().Highest != 3 || recipe["h"] != 3 || recipe.Finest != 0.25
            || recipe.Seed != 5) {
            throw new Exception("a parameter is not set");
        }
        recipe.Sample2(four, four, new Samples { Value = third }, "low");
        recipe.SignedSeed = -1;
        var noise = new Noise { SignedSeed = -7 };
        if (recipe.Seed != ulong.MaxValue || recipe.SignedSeed != -1
            || noise.Seed != ulong.MaxValue - 6
            || new Recipe(recipe.Text, -1).Seed != ulong.MaxValue
            || new Recipe(recipe.Text, 3).Seed != 3
            || new Recipe(recipe.Text, ulong.MaxValue).SignedSeed != -1) {
            throw new Exception("a negative seed is not 2^64 more");
        }
    }

    // Threads sample a recipe while this one changes it, and a noise whose plan they share.
    static void Threads()
    {
        var recipe = new Recipe("recipe 1\nparam h = 1 [1, 2]\nout a = 0 * noise() + h");
        var noise = new Noise { Octaves = 5 };
        noise.MakePlan(2);
        float expected = noise.At(0.25, 0.75);
        bool isDone = false;
        Task[] tasks = new Task[3];
        for (int i = 0; i < tasks.Length; i++) {
            tasks[i] = Task.Run(() => {
                var value = new float[300];
                while (!Volatile.Read(ref isDone)) {
                    recipe.Grid(new Raster(30, 10), new Samples { Value = value });
                    foreach (float v in value) {
                        if (v != value[0] || v < 1 || v > 2) {
                            throw new Exception("a call saw two recipes: " + v);
                        }
                    }
                    if (noise.At(0.25, 0.75) != expected) {
                        throw new Exception("a plan of two threads gives another value");
                    }
                }
            });
        }
        for (int i = 0; i < 200; i++) {
            recipe["h"] = 1 + i % 5 * 0.25;
            if (i % 50 == 0) {
                GC.Collect();
            }
        }
        Volatile.Write(ref isDone, true);
        Task.WaitAll(tasks);
    }

    // Threads share a recipe, for large calls and for single points. A field that is no output has
    // memory for these, too: all its noises are held until their sum is there.
    static void Shared()
    {
        const int Many = 5000;
        string text = "recipe 1\n", sum = "0", all = "0";
        for (int i = 1; i < 24; i++) {
            text += "n" + i + " = noise(size=30, seed=" + i + ")\n";
            sum += " + n" + i;
            all += " + n" + i + " * sum";
        }
        var recipe = new Recipe(text + "sum = " + sum + "\nall = " + all + "\nout a = 2 * n1");
        var x = new double[Many];
        for (int i = 0; i < Many; i++) {
            x[i] = 7 * i;
        }
        Task[] tasks = new Task[4];
        float[] a = new float[Many], many = new float[Many], slope = new float[Many];
        recipe.Sample2(x, x, new Samples { Value = a, Dx = slope });
        recipe.Sample2(x, x, new Samples { Value = many }, "all");
        for (int t = 0; t < tasks.Length; t++) {
            int first = t;
            tasks[t] = Task.Run(() => {
                var value = new float[Many];
                float[] one = new float[1], dx = new float[1], dyy = new float[1];
                for (int i = first; i < Many; i += 100) {
                    recipe.Sample2(x, x, new Samples { Value = value });
                    if (!new Span<float>(value).SequenceEqual(a)) {
                        throw new Exception("a call of one of many threads has other values");
                    }
                    ReadOnlySpan<double> at = new ReadOnlySpan<double>(x, i, 1);
                    recipe.Sample2(at, at, new Samples { Value = one, Dx = dx });
                    if (one[0] != a[i] || dx[0] != slope[i]) {
                        throw new Exception("a point has another value than among others");
                    }
                    recipe.Sample2(at, at, new Samples { Value = one, Dyy = dyy }, "all");
                    if (one[0] != many[i]) {
                        throw new Exception("a point of a field has another value");
                    }
                }
            });
        }
        Task.WaitAll(tasks);
    }

    // Recipes have the plan that C makes of them as they are, and so have pinned ones.
    static unsafe void Plans()
    {
        var recipe = new Recipe("recipe 1\nparam h = 2 [1, 3]\nout a = h * noise(size=9, octaves=4)");
        Action[] changes = {
            () => {}, () => recipe.Seed = 5, () => recipe.Finest = 2, () => recipe.Scale(2, 3),
            () => recipe.Finest = 0, () => recipe.Tile(90, 18)
        };
        foreach (Action change in changes) {
            change();
            const BindingFlags Any = BindingFlags.Instance | BindingFlags.NonPublic
                | BindingFlags.Public;
            object state = typeof(Recipe).GetField("state", Any).GetValue(recipe);
            var own = (Scarp.Internal.Block)state.GetType().GetField("plan", Any).GetValue(state);
            PinnedRecipe pinned = recipe.Pin();
            int size = (int)Native.scarp_recipe_plan_size(pinned.Pointer);
            var words = new ulong[size / 8 + 1];
            fixed (ulong* p = words) {
                Status status = Native.scarp_recipe_plan_make(pinned.Pointer, p, (UIntPtr)(uint)size);
                var expected = new Span<byte>(p, size);
                if (status != Status.Ok || size == 0
                    || !expected.SequenceEqual(new Span<byte>(own.Pointer, size))
                    || !expected.SequenceEqual(new Span<byte>(pinned.Plan, size))) {
                    throw new Exception("a recipe has another plan than C makes of it");
                }
            }
            pinned.Dispose();
            Expect<ObjectDisposedException>(null, () => { void* gone = pinned.Plan; });
        }
    }

    static void Versions()
    {
        foreach (string version in new[] {
            "", "1", "0.2", "a.b.c", "0.1.9", "0.3.0", "1.0.0", "-1.2.0"
        }) {
            if (Library.Serves(version)) {
                throw new Exception("a library of version " + version + " would do");
            }
        }
        string own = Native.VersionMajor + "." + Native.VersionMinor + ".";
        if (!Library.Serves(own + Native.VersionPatch) || !Library.Serves(own + "99")) {
            throw new Exception("a library of this version would not do");
        }
    }

    public static void Run()
    {
        Lengths.Run();
        Arrays();
        Members();
        Pinned();
        Recipes();
        Threads();
        Shared();
        Plans();
        Versions();
        Console.WriteLine(count + " mistakes are told");
    }
}
