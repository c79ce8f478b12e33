// SPDX-License-Identifier: MIT
//
// Runs Unity's sample: two neighbours share their border, heights are those of the noise, and
// normals are those of heights.
using System;
using System.Reflection;
using UnityEngine;

static class TerrainTest
{
    static TerrainSample Tile(int column)
    {
        var sample = new TerrainSample { terrain = new Terrain(), column = column, row = -2 };
        typeof(TerrainSample).GetMethod("Start", BindingFlags.Instance | BindingFlags.NonPublic)
            .Invoke(sample, null);
        return sample;
    }

    static void Need(bool condition, string text)
    {
        if (!condition) {
            throw new Exception(text);
        }
    }

    public static void Run()
    {
        TerrainSample left = Tile(3), right = Tile(4);
        float[,] h = left.terrain.terrainData.heights, next = right.terrain.terrainData.heights;
        int n = h.GetLength(0);
        float lowest = 1, highest = 0;
        for (int j = 0; j < n; j++) {
            Need(h[j, n - 1] == next[j, 0], "neighbours have a seam");
            for (int i = 0; i < n; i++) {
                lowest = Math.Min(lowest, h[j, i]);
                highest = Math.Max(highest, h[j, i]);
            }
        }
        Need(highest - lowest > 0.2, "the terrain is flat");
        var ground = new Scarp.Noise {
            Fractal = Scarp.Fractal.Swiss, Rotate = true, Seed = 14, Frequency = 1 / 300.0,
            Octaves = 7,
            Warp = new Scarp.Noise { Seed = 9, Frequency = 1 / 190.0, Octaves = 3, Amplitude = 44 }
        };
        float step = left.terrain.terrainData.size.x / (n - 1), dx, dy;
        foreach (int j in new[] {0, 15, 16, n - 1}) {
            foreach (int i in new[] {0, 7, n - 1}) {
                double x = (3 * (n - 1) + i) * (double)step, y = (-2 * (n - 1) + j) * (double)step;
                float value = ground.At(x, y, out dx, out dy);
                Need(Math.Abs(value - h[j, i]) < 1e-6, "a height is not that of the noise");
                Color normal = left.normals.colors[j * n + i];
                double length = Math.Sqrt(1 + 250.0 * 250 * (dx * dx + dy * dy));
                Need(Math.Abs(normal.r - (0.5 - 0.5 * 250 * dx / length)) < 1e-5
                     && Math.Abs(normal.g - (0.5 - 0.5 * 250 * dy / length)) < 1e-5
                     && Math.Abs(normal.b - (0.5 + 0.5 / length)) < 1e-5, "a normal is wrong");
            }
        }
        Need(left.normals.isApplied, "the normal map is not applied");
        Console.WriteLine("heights from " + lowest + " to " + highest);
    }
}
