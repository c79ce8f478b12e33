// SPDX-License-Identifier: MIT
//
// Runs Relief.compute in Unity. Scarp.cs has the calls of the library.
using System;
using UnityEngine;

public class Relief : MonoBehaviour
{
    public ComputeShader shader; // Relief.compute

    const int Pixels = 800 * 450;

    void Start()
    {
        var bend = new ScarpNoise { seed = 9, frequency = 1 / 190.0, octaves = 3, amplitude = 44 };
        var ground = new ScarpNoise {
            fractal = 6, // SCARP_SWISS
            rotate = 1, seed = 14, frequency = 1 / 300.0, octaves = 7, amplitude = 160,
            sharpness = 0.12f, warp = Scarp.Keep(bend)
        };

        uint[] plan = Scarp.Plan(ground, 2);
        var plans = new ComputeBuffer(Scarp.PlanBytes / 16, 16, ComputeBufferType.Constant);
        plans.SetData(plan);
        shader.SetConstantBuffer("ScarpPlans", plans, 0, Scarp.PlanBytes);

        var results = new ComputeBuffer(3 * Pixels, 4);
        uint[] answers = Run("Answers", Scarp.AnswerCount, results, new uint[Scarp.AnswerCount]);
        uint[] expected = Scarp.Answers(ground, 2, 1);
        int equal = 0;
        for (int i = 0; i < Scarp.AnswerCount; i++) {
            equal += answers[i] == expected[i] ? 1 : 0;
        }
        Debug.Log(equal + " of " + Scarp.AnswerCount + " answers are equal");

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
