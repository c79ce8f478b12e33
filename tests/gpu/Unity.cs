// SPDX-License-Identifier: MIT
//
// Runs src/gpu/samples/Relief.cs and Scarp.cs in Mono, for unity.py.
//
//     Unity.exe PLAN      where to write what the constant buffer is given
//
// Prints the offsets of the members of ScarpNoise, too.
using System;
using System.IO;
using System.Reflection;
using System.Runtime.InteropServices;
using UnityEngine;

public static class Unity
{
    public static int Main(string[] arguments)
    {
        foreach (FieldInfo member in typeof(ScarpNoise).GetFields()) {
            Console.WriteLine(member.Name + " " + Marshal.OffsetOf(typeof(ScarpNoise), member.Name));
        }
        Console.WriteLine("size " + Marshal.SizeOf(typeof(ScarpNoise)));
        var relief = new Relief { shader = new ComputeShader() };
        typeof(Relief).GetMethod("Start", BindingFlags.Instance | BindingFlags.NonPublic)
            .Invoke(relief, null);
        File.WriteAllBytes(arguments[0], relief.shader.constants.contents);
        try {
            Scarp.Plan(new ScarpNoise { octaves = 40 }, 2);
        } catch (ArgumentException error) {
            Console.WriteLine(error.Message);
        }
        return 0;
    }
}
