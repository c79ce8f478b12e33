// SPDX-License-Identifier: MIT
//
// What C# calls of the library for shaders. Needs nothing but scarp.dll, libscarp.so or
// libscarp.dylib of the same version as scarp.hlsl, for 64 bits.
using System;
using System.Runtime.InteropServices;

// struct scarp_noise; scarp.h tells what its members mean. Zeros are defaults.
[StructLayout(LayoutKind.Sequential, Size = 192)]
public struct ScarpNoise
{
    public int basis, fade, fractal; // the enumerators
    public uint rotate;
    public ulong seed;
    public double frequency;
    public float octaves, lacunarity, gain, amplitude, erosion, phase, jitter, sharpness;
    public uint periodX, periodY, periodZ;
    public float ofOctaves;
    public IntPtr warp; // to another noise, as Scarp.Keep gives it
    public IntPtr plan;
}

public static class Scarp
{
    public const int PlanBytes = 5376;
    public const int AnswerCount = 4096;

    [DllImport("scarp")]
    static extern int scarp_gpu_plan_make(ref ScarpNoise noise, int dimensions, [Out] uint[] plan,
                                          out IntPtr member);

    [DllImport("scarp")]
    static extern int scarp_gpu_answers(ref ScarpNoise noise, int dimensions, int order,
                                        [Out] uint[] answer);

    // A copy of a noise that stays where it is, for `warp`. Marshal.FreeHGlobal frees it.
    public static IntPtr Keep(ScarpNoise noise)
    {
        IntPtr kept = Marshal.AllocHGlobal(Marshal.SizeOf(noise));
        Marshal.StructureToPtr(noise, kept, false);
        return kept;
    }

    // The contents of the constant buffer for one noise, in words.
    public static uint[] Plan(ScarpNoise noise, int dimensions)
    {
        uint[] plan = new uint[PlanBytes / 4];
        IntPtr member;
        if (scarp_gpu_plan_make(ref noise, dimensions, plan, out member) != 0) {
            throw new ArgumentException("the noise has a wrong " + Marshal.PtrToStringAnsi(member));
        }
        return plan;
    }

    // What scarp_answer2, or 3, must give in a shader.
    public static uint[] Answers(ScarpNoise noise, int dimensions, int order)
    {
        uint[] answers = new uint[AnswerCount];
        if (scarp_gpu_answers(ref noise, dimensions, order, answers) != 0) {
            throw new ArgumentException("there are no such answers");
        }
        return answers;
    }
}
