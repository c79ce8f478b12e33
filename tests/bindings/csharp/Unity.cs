// SPDX-License-Identifier: MIT
//
// What src/bindings/csharp/unity/TerrainSample.cs uses of Unity, declared as its manual does, so
// that the sample is compiled and run without Unity. tests/gpu/UnityEngine.cs has MonoBehaviour.
using System;
using System.Threading.Tasks;

namespace UnityEngine
{
    public struct Vector3
    {
        public float x, y, z;

        public Vector3(float x, float y, float z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }
    }

    public struct Color
    {
        public float r, g, b, a;

        public Color(float r, float g, float b)
        {
            this.r = r;
            this.g = g;
            this.b = b;
            a = 1;
        }
    }

    // It is in Unity, too: no name of Scarp.cs may be ambiguous beside it.
    public class Grid
    {
    }

    public class TerrainData
    {
        public int heightmapResolution = 33;
        public Vector3 size = new Vector3(1000, 250, 1000);
        public float[,] heights;

        public void SetHeights(int xBase, int yBase, float[,] heights)
        {
            if (xBase != 0 || yBase != 0 || heights.GetLength(0) != heightmapResolution
                || heights.GetLength(1) != heightmapResolution) {
                throw new ArgumentException("heights");
            }
            foreach (float height in heights) {
                if (!(height >= 0 && height <= 1)) {
                    throw new ArgumentException("a height of " + height);
                }
            }
            this.heights = heights;
        }
    }

    public class Terrain
    {
        public TerrainData terrainData = new TerrainData();
    }

    public class Texture2D
    {
        readonly int pixels;
        public Color[] colors;
        public bool isApplied;

        public Texture2D(int width, int height)
        {
            pixels = width * height;
        }

        public void SetPixels(Color[] colors)
        {
            if (colors.Length != pixels) {
                throw new ArgumentException("colors");
            }
            this.colors = colors;
        }

        public void Apply()
        {
            isApplied = true;
        }
    }
}

namespace Unity.Collections.LowLevel.Unsafe
{
    public class NativeDisableUnsafePtrRestrictionAttribute : Attribute
    {
    }
}

namespace Unity.Jobs
{
    public interface IJobParallelFor
    {
        void Execute(int index);
    }

    public struct JobHandle
    {
        internal Task task;

        public void Complete()
        {
            task.Wait();
        }
    }

    public static class IJobParallelForExtensions
    {
        public static JobHandle Schedule<T>(this T job, int length, int batch)
            where T : struct, IJobParallelFor
        {
            return new JobHandle {
                task = Task.Run(() => Parallel.For(0, length, index => {
                    T copy = job;
                    copy.Execute(index);
                }))
            };
        }
    }
}
