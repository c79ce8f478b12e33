// SPDX-License-Identifier: MIT
//
// What src/gpu/samples/Relief.cs uses of Unity, declared as its manual does, so that the sample is
// compiled and run without Unity. The shader does nothing here but say what it was given.
using System;

namespace UnityEngine
{
    public class MonoBehaviour
    {
    }

    public enum ComputeBufferType { Default = 0, Constant = 8 }

    public class ComputeBuffer
    {
        readonly int bytes;
        public byte[] contents;

        public ComputeBuffer(int count, int stride, ComputeBufferType type = ComputeBufferType.Default)
        {
            if (stride <= 0 || stride > 2048 || stride % 4 != 0) {
                throw new ArgumentException("stride");
            }
            bytes = count * stride;
            contents = new byte[bytes];
        }

        public void SetData(Array data)
        {
            if (Buffer.ByteLength(data) > bytes) {
                throw new ArgumentException("more data than the buffer has room for");
            }
            Buffer.BlockCopy(data, 0, contents, 0, Buffer.ByteLength(data));
        }

        public void GetData(Array data)
        {
            if (Buffer.ByteLength(data) > bytes) {
                throw new ArgumentException("more data than the buffer has");
            }
            Buffer.BlockCopy(contents, 0, data, 0, Buffer.ByteLength(data));
        }

        public void Release()
        {
        }
    }

    public class ComputeShader
    {
        public ComputeBuffer constants;

        public int FindKernel(string name)
        {
            return Array.IndexOf(new[] {"Relief", "Answers"}, name);
        }

        public void SetConstantBuffer(string name, ComputeBuffer buffer, int offset, int size)
        {
            if (name != "ScarpPlans" || offset != 0 || size != buffer.contents.Length) {
                throw new ArgumentException(name);
            }
            constants = buffer;
        }

        public void SetBuffer(int kernel, string name, ComputeBuffer buffer)
        {
            if (kernel < 0 || name != "result") {
                throw new ArgumentException(name);
            }
        }

        public void Dispatch(int kernel, int x, int y, int z)
        {
        }
    }

    public static class Debug
    {
        public static void Log(object message)
        {
            Console.WriteLine(message);
        }
    }
}
