// SPDX-License-Identifier: MIT
//
// Fills a Terrain of Unity: heights by a job over rows, and a normal map from the exact gradient.
// Tiles of a world differ in `column` and `row` alone, and fit to the bit.
using System;
using Scarp;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using UnityEngine;

public class TerrainSample : MonoBehaviour
{
    public Terrain terrain;
    public int column, row; // of this tile
    public Texture2D normals; // made here: red is x, green z, blue up

    // Rows of a grid. Put [BurstCompile] on it if you like: all it hands to the library is
    // blittable.
    unsafe struct Rows : IJobParallelFor
    {
        public const int Each = 16; // rows of a job: less is not worth one

        public Raster grid;
        [NativeDisableUnsafePtrRestriction] public Native.scarp_noise* noise;
        [NativeDisableUnsafePtrRestriction] public float* value;
        [NativeDisableUnsafePtrRestriction] public float* dx;
        [NativeDisableUnsafePtrRestriction] public float* dy;
        [NativeDisableUnsafePtrRestriction] public Status* status; // of each job

        public void Execute(int job)
        {
            int first = job * Each;
            Native.scarp_grid part = grid.Band(first, Math.Min(Each, grid.Rows - first)).ToNative();
            long at = grid.Offset(first);
            var to = new Native.scarp_samples { value = value + at, dx = dx + at, dy = dy + at };
            status[job] = Native.scarp_grid2(noise, &part, &to);
        }
    }

    void Start()
    {
        TerrainData data = terrain.terrainData;
        int n = data.heightmapResolution; // 2^k + 1: neighbours share their border
        var bend = new Noise { Seed = 9, Frequency = 1 / 190.0, Octaves = 3, Amplitude = 44 };
        var ground = new Noise {
            Fractal = Fractal.Swiss, Rotate = true, Seed = 14, Frequency = 1 / 300.0, Octaves = 7,
            Amplitude = 160, Warp = bend
        };
        var grid = new Raster(n, n, data.size.x / (n - 1)) {
            FirstX = (long)column * (n - 1), FirstY = (long)row * (n - 1)
        };
        float[,] heights = new float[n, n];
        float[] dx = new float[n * n], dy = new float[n * n];
        Fill(ground, grid, heights, dx, dy);

        // SetHeights takes [z, x] from 0 to 1, of data.size.y.
        Interval range = ground.Range(2);
        float scale = 1 / (range.Highest - range.Lowest);
        Span<float> flat = Samples.Flat(heights);
        var level = new Samples { Value = flat };
        Samples.Affine(flat.Length, level, scale, -range.Lowest * scale, level);
        data.SetHeights(0, 0, heights);
        normals = NormalMap(n, dx, dy, scale * data.size.y);
    }

    unsafe void Fill(Noise noise, Raster grid, float[,] heights, float[] dx, float[] dy)
    {
        int jobs = (grid.Rows + Rows.Each - 1) / Rows.Each;
        var status = new Status[jobs];
        using (PinnedNoise pinned = noise.Pin(2))
        fixed (float* value = heights, alongX = dx, alongY = dy)
        fixed (Status* told = status) {
            new Rows {
                grid = grid, noise = pinned.Pointer, value = value, dx = alongX, dy = alongY,
                status = told
            }.Schedule(jobs, 1).Complete(); // before anything is let go of
        }
        foreach (Status of in status) {
            if (of != Status.Ok) {
                throw new ScarpException(of, null, "a job failed");
            }
        }
    }

    // The surface is heightScale times the noise. Unity's y is up, the noise's y is Unity's z.
    static Texture2D NormalMap(int n, float[] dx, float[] dy, float heightScale)
    {
        float[] x = dx, z = dy, up = new float[n * n]; // in the place of the gradient
        Samples.Normals(dx, dy, heightScale, x, z, up);
        var colors = new Color[n * n];
        for (int i = 0; i < colors.Length; i++) {
            colors[i] = new Color(0.5f + 0.5f * x[i], 0.5f + 0.5f * z[i], 0.5f + 0.5f * up[i]);
        }
        var map = new Texture2D(n, n);
        map.SetPixels(colors);
        map.Apply();
        return map;
    }
}
