// SPDX-License-Identifier: MIT
//
// Runs src/gpu/samples/Relief.cs in Mono, for engines.py.
//
//     Unity.exe PLAN      where to write what the constant buffer is given
using System.IO;
using System.Reflection;
using UnityEngine;

public static class Unity
{
    public static int Main(string[] arguments)
    {
        var relief = new Relief { shader = new ComputeShader() };
        typeof(Relief).GetMethod("Start", BindingFlags.Instance | BindingFlags.NonPublic)
            .Invoke(relief, null);
        File.WriteAllBytes(arguments[0], relief.shader.constants.contents);
        return 0;
    }
}
