// SPDX-License-Identifier: MIT
//
// What test_csharp.py runs in Mono, with Scarp.cs:
//
//     Tests.exe hashes RECIPE    outputs as tests/bindings/hashes.c prints them
//     Tests.exe layout           structures, sizes, members and offsets, as this runtime has them
//     Tests.exe wrappers HLSL    the calls that hashes do not make; HLSL is the file scarp.hlsl
//     Tests.exe defaults         the numbers that a noise starts with
//     Tests.exe mistakes         every mistake is the exception that it should be
//     Tests.exe readme           the snippets of the README
//     Tests.exe terrain          Unity's sample
//     Tests.exe overhead         nanoseconds of some calls
using System;
using System.Reflection;
using System.Runtime.InteropServices;
using Scarp;

static class Tests
{
    static void Layout()
    {
        foreach (Type type in typeof(Native).GetNestedTypes()) {
            Console.WriteLine(type.Name + " = " + Marshal.SizeOf(type));
            foreach (FieldInfo member in type.GetFields()) {
                Console.WriteLine(type.Name + " " + member.Name + " "
                                  + Marshal.OffsetOf(type, member.Name));
            }
        }
        foreach (Type type in typeof(Native).Assembly.GetTypes()) {
            if (type.IsEnum && type.IsPublic && type.Namespace == "Scarp") {
                foreach (string name in Enum.GetNames(type)) {
                    Console.WriteLine(type.Name + " " + name + " "
                                      + Convert.ToInt32(Enum.Parse(type, name)));
                }
            }
        }
    }

    static void Defaults()
    {
        foreach (PropertyInfo member in typeof(Noise).GetProperties()) {
            if (member.PropertyType == typeof(float) || member.PropertyType == typeof(double)) {
                Console.WriteLine(member.Name + " " + member.GetValue(new Noise(), null));
            }
        }
    }

    public static int Main(string[] arguments)
    {
        switch (arguments[0]) {
        case "hashes": Hashes.Run(arguments[1]); break;
        case "layout": Layout(); break;
        case "defaults": Defaults(); break;
        case "wrappers": Wrappers.Run(arguments[1]); break;
        case "mistakes": Mistakes.Run(); break;
        case "readme": Readme.Run(); break;
        case "terrain": TerrainTest.Run(); break;
        case "overhead": Overhead.Run(); break;
        default: return 2;
        }
        return 0;
    }
}
