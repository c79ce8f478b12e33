// SPDX-License-Identifier: MIT
//
// Runs Relief.compute in Unity. src/bindings/csharp/Scarp.cs has the calls of the library.
using System;
using Scarp;
using UnityEngine;

public class Relief : MonoBehaviour
{
    public ComputeShader shader; // Relief.compute

    const int Pixels = 800 * 450;

    void Start()
    {
        var bend = new Noise { Seed = 9, Frequency = 1 / 190.0, Octaves = 3, Amplitude = 44 };
        var ground = new Noise {
            Fractal = Fractal.Swiss, Rotate = true, Seed = 14, Frequency = 1 / 300.0, Octaves = 7,
            Amplitude = 160, Sharpness = 0.12f, Warp = bend
        };

        uint[] plan = ground.ShaderPlan(2);
        var plans = new ComputeBuffer(plan.Length / 4, 16, ComputeBufferType.Constant);
        plans.SetData(plan);
        shader.SetConstantBuffer("ScarpPlans", plans, 0, 4 * plan.Length);

        var results = new ComputeBuffer(3 * Pixels, 4);
        uint[] expected = ground.ShaderAnswers(2, 1);
        uint[] answers = Run("Answers", expected.Length, results, new uint[expected.Length]);
        int equal = 0;
        for (int i = 0; i < expected.Length; i++) {
            equal += answers[i] == expected[i] ? 1 : 0;
        }
        Debug.Log(equal + " of " + expected.Length + " answers are equal");

        var terrain = new float[3 * Pixels]; // all heights, all slopes along x, all along y
        Buffer.BlockCopy(Run("Relief", Pixels, results, new uint[3 * Pixels]), 0, terrain, 0,
                         4 * terrain.Length);
        Debug.Log("The height of the first pixel is " + terrain[0]);
        plans.Release();
        results.Release();
    }

    uint[] Run(string name, int threads, ComputeBuffer results, uint[] words)
    {
        int kernel = shader.FindKernel(name);
        shader.SetBuffer(kernel, "result", results);
        shader.Dispatch(kernel, (threads + 63) / 64, 1, 1);
        results.GetData(words);
        return words;
    }
}
