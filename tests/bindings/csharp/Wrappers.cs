// SPDX-License-Identifier: MIT
//
// What Hashes.cs does not call: each wrapper gives what a related one, or arithmetic, gives.
using System;
using System.IO;
using Scarp;

static class Wrappers
{
    const int Count = 50;

    static readonly float[] x = Make(0.37f), y = Make(0.61f), z = Make(0.83f);
    static readonly double[] dx = Widen(x), dy = Widen(y), dz = Widen(z);
    static readonly float[][] f = new float[12][], d = new float[12][];

    static float[] Make(float step)
    {
        var made = new float[Count];
        for (int i = 0; i < Count; i++) {
            made[i] = i * step - 5;
        }
        return made;
    }

    static double[] Widen(float[] of)
    {
        return Array.ConvertAll(of, v => (double)v);
    }

    static void Same(string name, float[] a, float[] b, double tolerance = 0)
    {
        bool isZero = true;
        for (int i = 0; i < Count; i++) {
            if (!(Math.Abs(a[i] - b[i]) <= tolerance)) {
                throw new Exception(name + ": " + a[i] + " and " + b[i] + " at " + i);
            }
            isZero &= a[i] == 0;
        }
        if (isZero) {
            throw new Exception(name + " is 0 everywhere");
        }
    }

    static Samples At(float[][] of, int first)
    {
        return new Samples { Value = of[first], Dx = of[first + 1], Dy = of[first + 2] };
    }

    static void Vectors()
    {
        var warp = new Noise { Seed = 3, Octaves = 2 };
        var bare = new Noise { Seed = 4 };
        var bent = new Noise(bare) { Warp = warp };
        warp.Vector3(x, y, z, At(f, 0), At(f, 3), At(f, 6));
        warp.Vector3(dx, dy, dz, At(d, 0), At(d, 3), At(d, 6));
        for (int i = 0; i < 9; i++) {
            Same("Vector3 of doubles", f[i], d[i], 1e-4);
        }
        float[] px = new float[Count], py = new float[Count], pz = new float[Count];
        for (int i = 0; i < Count; i++) {
            px[i] = x[i] + f[0][i];
            py[i] = y[i] + f[3][i];
            pz[i] = z[i] + f[6][i];
        }
        bare.Sample3(px, py, pz, new Samples { Value = d[0] });
        bent.Sample3(x, y, z, new Samples { Value = d[1] });
        Same("Vector3", d[0], d[1]);
        warp.Vector2(dx, dy, At(d, 0), At(d, 3));
        warp.Vector2(x, y, At(f, 0), At(f, 3));
        for (int i = 0; i < 6; i++) {
            Same("Vector2 of doubles", f[i], d[i], 1e-4);
        }
        new Noise(bent).Sample3(x, y, z, new Samples { Value = f[0] });
        bent.Sample3(x, y, z, new Samples { Value = d[0] });
        Same("a copy with a warp", f[0], d[0]);
        bent.Sample3(dx, dy, dz, new Samples { Value = d[0] });
        for (int i = 0; i < Count; i++) {
            f[0][i] = bent.At(dx[i], dy[i], dz[i]);
        }
        Same("At in space", f[0], d[0]);
        bent.Sample2(dx, dy, At(d, 0));
        for (int i = 0; i < Count; i++) {
            f[0][i] = bent.At(dx[i], dy[i], out f[1][i], out f[2][i]);
        }
        for (int i = 0; i < 3; i++) {
            Same("At in the plane", f[i], d[i]);
        }
    }

    static void Curls()
    {
        var noise = new Noise { Seed = 5, Octaves = 2 };
        noise.Sample2(x, y, new Samples {
            Dx = f[0], Dy = f[1], Dxx = f[2], Dxy = f[3], Dyy = f[4]
        });
        noise.Curl2(x, y, new Flow {
            Vx = d[1], Vy = d[0], Vxx = d[3], Vxy = d[4], Vyx = d[2], Vyy = d[5]
        });
        Negate(d[0], d[2], d[5]);
        Same("Vx", d[1], f[1]);
        Same("Vy", d[0], f[0]);
        Same("Vxx", d[3], f[3]);
        Same("Vxy", d[4], f[4]);
        Same("Vyx", d[2], f[2]);
        Same("Vyy", d[5], f[3]);
        noise.Curl2(dx, dy, new Flow { Vx = d[1] });
        Same("Curl2 of doubles", d[1], f[1], 1e-4);
        noise.Curl3(x, y, z, Swirl(f));
        noise.Curl3(dx, dy, dz, Swirl(d));
        for (int i = 0; i < 12; i++) {
            Same("Curl3 of doubles", f[i], d[i], 1e-3);
        }
        noise.Vector3(x, y, z, new Samples { Dy = d[0], Dz = d[1] }, new Samples { Dx = d[2],
            Dz = d[3] },
                      new Samples { Dx = d[4], Dy = d[5] });
        for (int i = 0; i < Count; i++) {
            d[6][i] = d[5][i] - d[3][i];
            d[7][i] = d[1][i] - d[4][i];
            d[8][i] = d[2][i] - d[0][i];
        }
        for (int i = 0; i < 3; i++) {
            Same("Curl3", f[i], d[6 + i]);
        }
    }

    static void Negate(params float[][] arrays)
    {
        foreach (float[] of in arrays) {
            for (int i = 0; i < Count; i++) {
                of[i] = -of[i];
            }
        }
    }

    static Flow Swirl(float[][] of)
    {
        return new Flow {
            Vx = of[0], Vy = of[1], Vz = of[2], Vxx = of[3], Vxy = of[4], Vxz = of[5], Vyx = of[6],
            Vyy = of[7], Vyz = of[8], Vzx = of[9], Vzy = of[10], Vzz = of[11]
        };
    }

    static void CellsOf()
    {
        var noise = new Noise { Seed = 6 };
        uint[] id = new uint[Count], other = new uint[Count];
        noise.Cells3(x, y, z, new Cells {
            F1 = f[0], F2 = f[1], Id = id, X = f[2], Y = f[3], Z = f[4], Dx1 = f[5], Dy1 = f[6],
            Dz1 = f[7], Dx2 = f[8], Dy2 = f[9], Dz2 = f[10]
        });
        noise.Cells3(dx, dy, dz, new Cells {
            F1 = d[0], F2 = d[1], Id = other, X = d[2], Y = d[3], Z = d[4], Dx1 = d[5], Dy1 = d[6],
            Dz1 = d[7], Dx2 = d[8], Dy2 = d[9], Dz2 = d[10]
        });
        for (int i = 0; i < 11; i++) {
            Same("Cells3 of doubles", f[i], d[i], 1e-4);
        }
        for (int i = 0; i < Count; i++) {
            if (id[i] != other[i]) {
                throw new Exception("Cells3 gives other cells");
            }
            double ax = x[i] - f[2][i], ay = y[i] - f[3][i], az = z[i] - f[4][i];
            d[0][i] = (float)Math.Sqrt(ax * ax + ay * ay + az * az);
            d[1][i] = (float)(ax / d[0][i]);
            d[2][i] = (float)(ay / d[0][i]);
            d[3][i] = (float)(az / d[0][i]);
        }
        Same("F1", f[0], d[0], 1e-4);
        Same("Dx1", f[5], d[1], 1e-3);
        Same("Dy1", f[6], d[2], 1e-3);
        Same("Dz1", f[7], d[3], 1e-3);
        noise.Cells2(x, y, new Cells { F1 = f[0] });
        noise.Cells2(dx, dy, new Cells { F1 = d[0] });
        Same("Cells2", f[0], d[0], 1e-4);
    }

    delegate void Function(in Samples a, in Samples to);

    // A function of the chain rule at values of x, and its slope
    static void One(string name, Function function, Func<double, double> exact)
    {
        for (int i = 0; i < Count; i++) {
            f[0][i] = x[i] / 4;
            f[1][i] = 2;
            f[2][i] = -3;
            double a = f[0][i], h = 1e-5;
            d[0][i] = (float)exact(a);
            d[1][i] = (float)(2 * (exact(a + h) - exact(a - h)) / (2 * h));
        }
        function(At(f, 0), At(f, 3));
        Same(name, f[3], d[0], 1e-4);
        if (name != "slope") {
            Same(name + "'s slope", f[4], d[1], 2e-3);
        }
    }

    static void Chain()
    {
        One("curve", (in Samples a, in Samples to) => Samples.Curve(
            Count, a, new float[] {-2, 4}, new float[] {1, 2}, to), a => {
            double t = Math.Min(Math.Max((a + 2) / 6, 0), 1);
            return 1 + t * t * (3 - 2 * t);
        });
        One("slope", (in Samples a, in Samples to) => Samples.Slope(
            Count, a, new Samples { Value = to.Value }), a => Math.Sqrt(13));
    }

    // Tile and scale are those of texts.
    static void Scaled()
    {
        var recipe = new Recipe("recipe 1\nout a = noise(size=3, octaves=2)", 5);
        var text = new Recipe("recipe 1\ntile 12, 18\nout a = 4 * scale(noise(size=3, octaves=2), 2)",
                              5);
        recipe.Scale(2, 4);
        recipe.Tile(12, 18);
        recipe.Sample2(x, y, new Samples { Value = f[0] });
        text.Sample2(x, y, new Samples { Value = d[0] });
        Same("a recipe that calls scale", f[0], d[0]);
        OutputInfo info = recipe.Info();
        if (info.LargestCell != 6 || info.SmallestCell != 3 || info.Jumps || info.Order != 2
            || !new Recipe("recipe 1\nout b = cell(noise())").Info("b").Jumps || recipe.Seed != 5) {
            throw new Exception("a recipe says something else of itself");
        }
    }

    static void Recipes(string hlsl)
    {
        var recipe = new Recipe("recipe 1\nspace 3\nout a = 2 * noise(size=1, seed=3)\n", 9);
        var raster = new Raster(5, 5, 0.5, 2);
        recipe.Grid(raster, new Samples { Value = f[0], Dz = f[1] });
        for (int i = 0; i < Count; i++) {
            x[i] = i % 5 * 0.5f;
            y[i] = i / 5 % 5 * 0.5f;
            z[i] = i / 25 * 0.5f;
        }
        recipe.Sample3(x, y, z, new Samples { Value = d[0], Dz = d[1] });
        recipe.Sample3(Widen(x), Widen(y), Widen(z), new Samples { Value = d[2], Dz = d[3] });
        Same("a recipe at floats", f[0], d[0], 1e-6); // floats round positions
        Same("its slope", f[1], d[1], 1e-6);
        Same("a recipe at doubles", f[0], d[2]);
        var plane = new Recipe("recipe 1\nout a = noise(size=3)");
        plane.Sample2(x, y, new Samples { Value = f[0] });
        plane.Sample2(Widen(x), Widen(y), new Samples { Value = d[0] });
        Same("a recipe of the plane", f[0], d[0], 1e-6);
        Interval within = new Recipe("recipe 1\nspace 3\nout a = x + 10 * y + 100 * z").Range(
            "a", new Box { LowestX = 1, HighestX = 2, LowestY = 3, HighestY = 4, LowestZ = 5,
                           HighestZ = 6 });
        if (Math.Abs(within.Lowest - 531) > 0.01 || Math.Abs(within.Highest - 642) > 0.01) {
            throw new Exception("values in a box are in " + within);
        }
        Scaled();
        plane.Seed = 4;
        plane.Sample2(x, y, new Samples { Value = d[0] });
        if (f[0][7] == d[0][7] || plane.Seed != 4) {
            throw new Exception("the seed changes nothing");
        }
        plane.Finest = 1;
        if (plane.Finest != 1 || plane.Seed != 4) {
            throw new Exception("finest is not kept");
        }

        string file = File.ReadAllText(hlsl), shader = recipe.Shader(Language.Hlsl, file);
        if (!shader.Contains("ScarpRecipe scarp_recipe(") || shader.EndsWith("\0")
            || recipe.ShaderUniforms().Length % 16 != 0 || recipe.ShaderUniforms().Length < 160
            || recipe.ShaderAnswers(1).Length != 4096) {
            throw new Exception("the shader of a recipe is none");
        }
        try {
            recipe.Shader(Language.Wgsl, file);
            throw new Exception("WGSL is made of HLSL");
        } catch (ScarpException error) {
            if (error.Member != "file") {
                throw;
            }
        }
        uint[] plan = new Noise().ShaderPlan(3), vector = new Noise().VectorShaderPlan(3);
        if (plan.Length != 1344 || plan[1] != 3 || vector.Length != 1344
            || string.Join(" ", plan) == string.Join(" ", vector)
            || new Noise().ShaderAnswers(2, 2).Length != 4096) {
            throw new Exception("the plan for a shader is none");
        }
    }

    // A field that holds more of others at a time than the output does: it needs more memory for
    // each point.
    static void ManyParts()
    {
        const int parts = 54;
        string names = "", sum = "", product = "";
        for (int i = 0; i < parts; i++) {
            names += "n" + i + " = x * " + (i + 2) + "\n";
            sum += (i % 9 == 0 ? i > 0 ? ") + (" : "(" : " + ") + "n" + i;
            product += (i % 9 == 0 ? i > 0 ? ") + (" : "(" : " + ") + "n" + i + " * s";
        }
        var recipe = new Recipe("recipe 1\nspace 3\n" + names + "s = " + sum + ")\nmany = "
                                + product + ")\nout a = x");
        recipe.Sample3(x, y, z, new Samples {
            Value = f[0], Dx = f[1], Dy = f[2], Dz = f[3], Dxx = f[4], Dxy = f[5], Dxz = f[6],
            Dyy = f[7], Dyz = f[8], Dzz = f[9]
        }, "many");
        for (int i = 0; i < Count; i++) {
            double s = 0;
            for (int n = 0; n < parts; n++) {
                s += x[i] * (n + 2);
            }
            d[0][i] = (float)(s * s);
            f[0][i] /= Math.Max(1, Math.Abs(d[0][i]));
            d[0][i] /= Math.Max(1, Math.Abs(d[0][i]));
        }
        Same("a field of many parts", f[0], d[0], 1e-4);
    }

    static void Libraries()
    {
        Isa best = Library.Isa;
        Library.Select(Isa.Scalar);
        if (Library.Isa != Isa.Scalar || !Library.IsSupported(best)
            || Library.IsSupported(Isa.None)) {
            throw new Exception("kernel sets are not chosen");
        }
        Library.Select(Isa.None);
        if (Library.Isa != best) {
            throw new Exception("the best kernel set does not return");
        }
    }

    public static void Run(string hlsl)
    {
        for (int i = 0; i < 12; i++) {
            f[i] = new float[Count];
            d[i] = new float[Count];
        }
        Vectors();
        Curls();
        CellsOf();
        Chain();
        Recipes(hlsl);
        ManyParts();
        Libraries();
        Console.WriteLine("wrappers do what they wrap");
    }
}
