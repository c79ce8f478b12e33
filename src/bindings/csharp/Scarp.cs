// SPDX-License-Identifier: MIT
//
// scarp for C#: noise with exact derivatives, over the shared library of the same version. This is
// the whole binding. It compiles with C# 7.3 and later where there are spans (Unity 2021.2, .NET
// Core 2.1, Mono 6 and later), in a project that allows unsafe code; programs that use it need none
// themselves.
//
// Any number of threads may call at a time, also with the same noise or recipe, as long as none
// changes a noise meanwhile. Results have the bits of C, on every machine. Arguments are checked
// before anything is written: ArgumentException, with the name of the argument, where an array is
// missing, too short or overlaps another one; ScarpException for what the library refuses, with the
// member at fault.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;
using Scarp.Internal;

namespace Scarp
{
    /// <summary>What the library refuses.</summary>
    public class ScarpException : Exception
    {
        public Status Status { get; }

        /// <summary>The member at fault, as this file spells it: "Octaves", "PeriodY", "Warp.Gain";
        /// or null.</summary>
        public string Member { get; }

        public ScarpException(Status status, string member, string text)
            : base(member == null ? text : member + ": " + text)
        {
            Status = status;
            Member = member;
        }

        internal unsafe ScarpException(Status status, string member)
            : this(status, member, Text.Of(Native.scarp_status_text(status)))
        {
        }
    }

    /// <summary>The library itself.</summary>
    public static unsafe class Library
    {
        static volatile bool isChecked;

        /// <summary>"major.minor.patch" of the library that runs.</summary>
        public static string Version { get { return Text.Of(Native.scarp_version()); } }

        /// <summary>The kernel set in use. Results do not depend on it.</summary>
        public static Isa Isa { get { return Native.scarp_isa_active(); } }

        public static bool IsSupported(Isa isa)
        {
            return Native.scarp_isa_supported(isa) != 0;
        }

        /// <summary>Uses a kernel set from now on, in all threads; Isa.None is the best
        /// one.</summary>
        public static void Select(Isa isa)
        {
            Status status = Native.scarp_isa_select(isa);
            if (status != Status.Ok) {
                throw new ScarpException(status, "isa");
            }
        }

        /// <summary>Throws unless a library of this version serves this file. Noises and recipes
        /// call it when they are made.</summary>
        public static void Check()
        {
            if (!isChecked) {
                string version;
                try {
                    version = Version;
                } catch (DllNotFoundException error) {
                    throw new DllNotFoundException("the shared library of scarp is not found: "
                        + "libscarp.so, libscarp.dylib or scarp.dll", error);
                }
                if (!Serves(version)) {
                    throw new ScarpException(Status.Unsupported, null, "the library is version "
                        + version + " of scarp, but Scarp.cs is of " + Native.VersionMajor + "."
                        + Native.VersionMinor + "." + Native.VersionPatch);
                }
                isChecked = true;
            }
        }

        // While the major version is 0, a minor version counts as a major one.
        internal static bool Serves(string version)
        {
            var told = new int[3];
            string[] parts = version.Split('.');
            for (int i = 0; i < 3; i++) {
                if (parts.Length != 3 || !int.TryParse(parts[i], out told[i])) {
                    return false;
                }
            }
            if (told[0] != Native.VersionMajor) {
                return false;
            }
            return told[0] == 0
                ? told[1] == Native.VersionMinor && told[2] >= Native.VersionPatch
                : told[1] > Native.VersionMinor
                    || told[1] == Native.VersionMinor && told[2] >= Native.VersionPatch;
        }
    }

    /// <summary>Values never leave it, rounding included.</summary>
    public struct Interval
    {
        public float Lowest, Highest;

        public override string ToString()
        {
            return "[" + Lowest + ", " + Highest + "]";
        }
    }

    /// <summary>A uniform grid. Sample (i, j, k) lies at Origin + (First + index) * Step along each
    /// axis. In arrays it is element k * SliceStride + j * RowStride + i, so x is along rows. Tiles
    /// of a world have the same origin and step and each its First: then they fit to the
    /// bit.</summary>
    public struct Raster
    {
        public double OriginX, OriginY, OriginZ;
        public double StepX, StepY, StepZ; // of any sign, also 0
        public long FirstX, FirstY, FirstZ; // index of the first sample, up to 2^53 in magnitude
        public int Columns, Rows, Slices; // samples along x, y, z; the plane ignores Slices
        public long RowStride, SliceStride; // elements from a row, or slice, to the next; 0: no gap

        public Raster(int columns, int rows, double step = 1, int slices = 1)
        {
            this = default(Raster);
            Columns = columns;
            Rows = rows;
            Slices = slices;
            StepX = StepY = StepZ = step;
        }

        /// <summary>Some rows of this grid, for a job of its own. Its arrays begin at Offset(row).
        /// </summary>
        public Raster Band(int row, int rows)
        {
            if (row < 0 || rows < 0 || row > Rows - rows) {
                throw new ArgumentOutOfRangeException("row");
            }
            Raster band = this;
            band.FirstY += row;
            band.Rows = rows;
            return band;
        }

        /// <summary>The element at which a row begins.</summary>
        public long Offset(int row)
        {
            return row * (RowStride == 0 ? Columns : RowStride);
        }

        // Elements up to the last one
        internal long Length(int dimensions)
        {
            if (Columns < 0 || Rows < 0 || dimensions == 3 && Slices < 0) {
                throw new ArgumentException("a count is negative", Columns < 0 ? "grid.Columns"
                                            : Rows < 0 ? "grid.Rows" : "grid.Slices");
            }
            if (RowStride < 0 || dimensions == 3 && SliceStride < 0) {
                throw new ArgumentException("is negative", RowStride < 0 ? "grid.RowStride"
                                            : "grid.SliceStride");
            }
            if (Columns == 0 || Rows == 0 || dimensions == 3 && Slices == 0) {
                return 0;
            }
            long row = RowStride == 0 ? Columns : RowStride;
            long slice = SliceStride == 0 ? Rows * row : SliceStride;
            return (dimensions == 3 ? (Slices - 1) * slice : 0) + (Rows - 1) * row + Columns;
        }

        // The length of a row if there are gaps, in which rows of other arrays may lie; else 0
        internal int Gapped(int dimensions)
        {
            return RowStride > Columns || dimensions == 3 && SliceStride != 0 ? Columns : 0;
        }

        /// <summary>The grid as C has it, for Native.</summary>
        public unsafe Native.scarp_grid ToNative()
        {
            var grid = new Native.scarp_grid();
            grid.origin[0] = OriginX;
            grid.origin[1] = OriginY;
            grid.origin[2] = OriginZ;
            grid.step[0] = StepX;
            grid.step[1] = StepY;
            grid.step[2] = StepZ;
            grid.first[0] = FirstX;
            grid.first[1] = FirstY;
            grid.first[2] = FirstZ;
            grid.count0 = (UIntPtr)(uint)Columns;
            grid.count1 = (UIntPtr)(uint)Rows;
            grid.count2 = (UIntPtr)(uint)Slices;
            grid.row_stride = (UIntPtr)(ulong)RowStride;
            grid.slice_stride = (UIntPtr)(ulong)SliceStride;
            return grid;
        }
    }

    /// <summary>Arrays of values and derivatives; float[], Span, or Samples.Flat of a float[,].
    /// What is not given is not computed, and not paid for. Dx ... is the gradient, per unit of
    /// input, Dxx ... the Hessian, Dphase the derivative with respect to the phase, per turn.</summary>
    public ref partial struct Samples
    {
        /// <summary>All elements of an array with rows, as TerrainData.SetHeights takes it: element
        /// [j, i] is column i of row j.</summary>
        public static Span<float> Flat(float[,] array)
        {
            return array == null || array.Length == 0 ? default(Span<float>)
                : MemoryMarshal.CreateSpan(ref array[0, 0], array.Length);
        }

        // The order of the derivatives that are asked for
        internal static int Order(in Samples s)
        {
            Span<float> none = default(Span<float>);
            return s.Dxx != none || s.Dxy != none || s.Dxz != none || s.Dyy != none || s.Dyz != none
                || s.Dzz != none ? 2 : s.Dx != none || s.Dy != none || s.Dz != none ? 1 : 0;
        }
    }

    // <arrays> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
    public ref partial struct Samples
    {
        public Span<float> Value, Dx, Dy, Dz, Dxx, Dxy, Dxz, Dyy, Dyz, Dzz, Dphase;

        internal static readonly string[] Names = {
            "to.Value", "to.Dx", "to.Dy", "to.Dz", "to.Dxx", "to.Dxy", "to.Dxz", "to.Dyy", "to.Dyz",
            "to.Dzz", "to.Dphase", "", "", "", "", ""
        };

        // How many arrays are given. Throws if one is too short.
        internal static int Check(in Samples s, long needed, string name)
        {
            return 0
                + Arguments.Room(s.Value, needed, name, "Value")
                + Arguments.Room(s.Dx, needed, name, "Dx")
                + Arguments.Room(s.Dy, needed, name, "Dy")
                + Arguments.Room(s.Dz, needed, name, "Dz")
                + Arguments.Room(s.Dxx, needed, name, "Dxx")
                + Arguments.Room(s.Dxy, needed, name, "Dxy")
                + Arguments.Room(s.Dxz, needed, name, "Dxz")
                + Arguments.Room(s.Dyy, needed, name, "Dyy")
                + Arguments.Room(s.Dyz, needed, name, "Dyz")
                + Arguments.Room(s.Dzz, needed, name, "Dzz")
                + Arguments.Room(s.Dphase, needed, name, "Dphase");
        }
    }

    /// <summary>What is near a point. F1, F2: distances to the nearest feature and to the second,
    /// in units of input; Id: a number drawn for the nearest one's cell; X, Y, Z: where it is; Dx1
    /// ... and Dx2 ...: the gradients of F1 and F2.</summary>
    public ref partial struct Cells
    {
        public Span<float> F1, F2;
        public Span<uint> Id;
        public Span<float> X, Y, Z, Dx1, Dy1, Dz1, Dx2, Dy2, Dz2;

        internal static readonly string[] Names = {
            "to.F1", "to.F2", "to.Id", "to.X", "to.Y", "to.Z", "to.Dx1", "to.Dy1", "to.Dz1",
            "to.Dx2", "to.Dy2", "to.Dz2", "", "", "", ""
        };

        // How many arrays are given. Throws if one is too short.
        internal static int Check(in Cells s, long needed, string name)
        {
            return 0
                + Arguments.Room(s.F1, needed, name, "F1")
                + Arguments.Room(s.F2, needed, name, "F2")
                + Arguments.Room(s.Id, needed, name, "Id")
                + Arguments.Room(s.X, needed, name, "X")
                + Arguments.Room(s.Y, needed, name, "Y")
                + Arguments.Room(s.Z, needed, name, "Z")
                + Arguments.Room(s.Dx1, needed, name, "Dx1")
                + Arguments.Room(s.Dy1, needed, name, "Dy1")
                + Arguments.Room(s.Dz1, needed, name, "Dz1")
                + Arguments.Room(s.Dx2, needed, name, "Dx2")
                + Arguments.Room(s.Dy2, needed, name, "Dy2")
                + Arguments.Room(s.Dz2, needed, name, "Dz2");
        }

        // The first array for which the plane has nothing, or null
        internal static string AlongZ(in Cells s)
        {
            Span<float> none = default(Span<float>);
            return
                s.Z != none ? "to.Z" :
                s.Dz1 != none ? "to.Dz1" :
                s.Dz2 != none ? "to.Dz2" :
                null;
        }
    }

    /// <summary>A velocity without divergence, and its Jacobian: Vxy is the derivative of Vx with
    /// respect to y. Per unit of input.</summary>
    public ref partial struct Flow
    {
        public Span<float> Vx, Vy, Vz, Vxx, Vxy, Vxz, Vyx, Vyy, Vyz, Vzx, Vzy, Vzz;

        internal static readonly string[] Names = {
            "to.Vx", "to.Vy", "to.Vz", "to.Vxx", "to.Vxy", "to.Vxz", "to.Vyx", "to.Vyy", "to.Vyz",
            "to.Vzx", "to.Vzy", "to.Vzz", "", "", "", ""
        };

        // How many arrays are given. Throws if one is too short.
        internal static int Check(in Flow s, long needed, string name)
        {
            return 0
                + Arguments.Room(s.Vx, needed, name, "Vx")
                + Arguments.Room(s.Vy, needed, name, "Vy")
                + Arguments.Room(s.Vz, needed, name, "Vz")
                + Arguments.Room(s.Vxx, needed, name, "Vxx")
                + Arguments.Room(s.Vxy, needed, name, "Vxy")
                + Arguments.Room(s.Vxz, needed, name, "Vxz")
                + Arguments.Room(s.Vyx, needed, name, "Vyx")
                + Arguments.Room(s.Vyy, needed, name, "Vyy")
                + Arguments.Room(s.Vyz, needed, name, "Vyz")
                + Arguments.Room(s.Vzx, needed, name, "Vzx")
                + Arguments.Room(s.Vzy, needed, name, "Vzy")
                + Arguments.Room(s.Vzz, needed, name, "Vzz");
        }

        // The first array for which the plane has nothing, or null
        internal static string AlongZ(in Flow s)
        {
            Span<float> none = default(Span<float>);
            return
                s.Vz != none ? "to.Vz" :
                s.Vxz != none ? "to.Vxz" :
                s.Vyz != none ? "to.Vyz" :
                s.Vzx != none ? "to.Vzx" :
                s.Vzy != none ? "to.Vzy" :
                s.Vzz != none ? "to.Vzz" :
                null;
        }
    }
    // </arrays>

    /// <summary>Noise: what to sample. Members are those of struct scarp_noise, and start with its
    /// defaults. Calls copy them, with those of warps, so nothing has to be pinned or disposed of.
    /// </summary>
    public sealed unsafe partial class Noise
    {
        internal const int MostLinks = 6; // itself, and one warp more than there may be
        Native.scarp_noise data;
        Block plan;

        public Noise()
        {
            Library.Check();
            data.frequency = 1;
            data.octaves = data.amplitude = data.erosion = data.jitter = 1;
            data.lacunarity = 2;
            data.gain = 0.5f;
        }

        /// <summary>A copy, which may be changed. It has the same warp.</summary>
        public Noise(Noise other)
        {
            data = other.data;
            Warp = other.Warp;
        }

        public Basis Basis { get { return data.basis; } set { data.basis = value; } }
        public Fade Fade { get { return data.fade; } set { data.fade = value; } }

        /// <summary>How octaves are summed. Some fractals have no Hessian: see scarp.h.</summary>
        public Fractal Fractal { get { return data.fractal; } set { data.fractal = value; } }

        /// <summary>Turns the axes between octaves, which hides the lattice's directions.</summary>
        public bool Rotate
        {
            get { return data.rotate != 0; }
            set { data.rotate = value ? 1u : 0u; }
        }

        public ulong Seed { get { return data.seed; } set { data.seed = value; } }

        /// <summary>The same seed with a sign, as an int of Unity has: -1 is 2^64 - 1.</summary>
        public long SignedSeed
        {
            get { return unchecked((long)data.seed); }
            set { data.seed = unchecked((ulong)value); }
        }

        /// <summary>Lattice cells per unit of input. Default 1.</summary>
        public double Frequency
        {
            get { return data.frequency; }
            set { data.frequency = NotZero(value, "Frequency"); }
        }

        /// <summary>In (0, 32]. Default 1; a fraction fades the last one in.</summary>
        public float Octaves
        {
            get { return data.octaves; }
            set { data.octaves = NotZero(value, "Octaves"); }
        }

        /// <summary>The frequency ratio between octaves, in [1/16, 16]. Default 2.</summary>
        public float Lacunarity
        {
            get { return data.lacunarity; }
            set { data.lacunarity = NotZero(value, "Lacunarity"); }
        }

        /// <summary>The amplitude ratio between octaves, in [1/16, 16]. Default 0.5.</summary>
        public float Gain { get { return data.gain; } set { data.gain = NotZero(value, "Gain"); } }

        /// <summary>Scales every output. Default 1.</summary>
        public float Amplitude
        {
            get { return data.amplitude; }
            set { data.amplitude = NotZero(value, "Amplitude"); }
        }

        /// <summary>Fractal.Erosion: how strongly slopes damp octaves. Default 1. For other
        /// fractals see scarp.h.</summary>
        public float Erosion
        {
            get { return data.erosion; }
            set { data.erosion = NotZero(value, "Erosion"); }
        }

        /// <summary>Turns of the gradients: noise that flows, of gradient noise alone. 1 is a loop.
        /// </summary>
        public float Phase { get { return data.phase; } set { data.phase = value; } }

        /// <summary>Cellular noise: how far features stray, in (0, 1]. Default 1.</summary>
        public float Jitter
        {
            get { return data.jitter; }
            set { data.jitter = NotZero(value, "Jitter"); }
        }

        /// <summary>Of some fractals, in [2^-8, 2^8]: see scarp.h. 0: the default of the fractal.</summary>
        public float Sharpness { get { return data.sharpness; } set { data.sharpness = value; } }

        /// <summary>Cells of octave 0 after which the noise repeats along x; 0: never.</summary>
        public uint PeriodX { get { return Period(0); } set { SetPeriod(0, value); } }
        public uint PeriodY { get { return Period(1); } set { SetPeriod(1, value); } }
        public uint PeriodZ { get { return Period(2); } set { SetPeriod(2, value); } }

        /// <summary>Amplitudes are those of a sum of so many octaves: levels of detail. 0: Octaves.
        /// </summary>
        public float OfOctaves { get { return data.of_octaves; } set { data.of_octaves = value; } }

        /// <summary>Displaces positions, in units of input. null: nothing does. It may have a warp,
        /// too, up to four in all.</summary>
        public Noise Warp { get; set; }

        /// <summary>Whether the first octave, too, has an offset that the seed draws. Without one
        /// every seed has a lattice point at the origin.</summary>
        public bool OffsetFirst
        {
            get { return data.offset_first != 0; }
            set { data.offset_first = value ? 1u : 0u; }
        }

        uint Period(int axis)
        {
            fixed (uint* period = data.period) {
                return period[axis];
            }
        }

        void SetPeriod(int axis, uint value)
        {
            fixed (uint* period = data.period) {
                period[axis] = value;
            }
        }

        static double NotZero(double value, string name)
        {
            if (value == 0) {
                throw new ScarpException(Status.Parameter, name, "0 would stand for the default");
            }
            return value;
        }

        static float NotZero(float value, string name)
        {
            return (float)NotZero((double)value, name);
        }

        // On its way to C

        internal int Links
        {
            get
            {
                int links = 1;
                for (Noise warp = Warp; warp != null && links < MostLinks; warp = warp.Warp) {
                    links++;
                }
                return links;
            }
        }

        // Writes this noise and its warps, one behind the other, and links them.
        internal void Write(Native.scarp_noise* to, int links, Native.scarp_plan* constants)
        {
            Noise noise = this;
            for (int i = 0; i < links && noise != null; i++, noise = noise.Warp) {
                to[i] = noise.data;
                to[i].warp = null;
                to[i].plan = i == 0 ? constants : null;
                if (i > 0) {
                    to[i - 1].warp = to + i;
                }
            }
        }

        void Run(Request* r, in Samples to)
        {
            int links = Links;
            Native.scarp_noise* chain = stackalloc Native.scarp_noise[links];
            Native.scarp_samples into = default(Native.scarp_samples);
            Block constants = plan;
            Write(chain, links, constants == null ? null : (Native.scarp_plan*)constants.Pointer);
            r->noise = chain;
            Status status = Request.Pin(r, &into, 1, to);
            GC.KeepAlive(constants);
            if (status != Status.Ok) {
                throw Complain(status, r->dimensions, chain, to.Dphase != default(Span<float>),
                               Samples.Order(to) == 2);
            }
        }

        // Vector noise, for which MakePlan makes no plan
        void Run(Request* r, in Samples first, in Samples second, in Samples third)
        {
            int links = Links;
            Native.scarp_noise* chain = stackalloc Native.scarp_noise[links];
            Native.scarp_samples* into = stackalloc Native.scarp_samples[3];
            Write(chain, links, null);
            r->noise = chain;
            Status status = Request.Pin(r, into, 0, r->dimensions, first, second, third,
                                        default(Samples));
            if (status != Status.Ok) {
                bool hasSecond = Samples.Order(first) == 2 || Samples.Order(second) == 2
                    || Samples.Order(third) == 2;
                throw Complain(status, r->dimensions, chain, !hasSecond, hasSecond);
            }
        }

        Exception Complain(Status status, int dimensions, Native.scarp_noise* noise, bool hasPhase,
                           bool hasSecond)
        {
            ScarpException fault = Fault(noise, dimensions);
            if (fault != null) {
                return fault;
            }
            if (status == Status.Unsupported) {
                bool hasHessian = Native.scarp_noise_fault(noise, dimensions, 2, 0, null) == null;
                return hasPhase && !(hasSecond && !hasHessian)
                    ? new ScarpException(status, "Dphase",
                                         "this noise has no derivative with respect to the phase")
                    : new ScarpException(status, "Dxx",
                                         "this noise, or a warp of it, has no second "
                                         + "derivatives");
            }
            return new ScarpException(status, null);
        }

        // What is wrong with a noise, or a warp of it: "Warp.Octaves". null: nothing.
        static ScarpException Fault(Native.scarp_noise* noise, int dimensions)
        {
            byte* member;
            Status status = Native.scarp_noise_check(noise, dimensions, &member);
            return status == Status.Ok ? null : new ScarpException(status, Text.Member(member),
                Text.Of(Native.scarp_noise_fault(noise, dimensions, 0, 0, null)));
        }

        /// <summary>Throws what calls in 2 or 3 dimensions would throw for this noise:
        /// ScarpException, with the member at fault.</summary>
        public void Check(int dimensions)
        {
            Arguments.Dimensions(dimensions);
            int links = Links;
            Native.scarp_noise* chain = stackalloc Native.scarp_noise[links];
            Write(chain, links, null);
            ScarpException fault = Fault(chain, dimensions);
            if (fault != null) {
                throw fault;
            }
        }

        /// <summary>The interval that values never leave, in 2 or 3 dimensions.</summary>
        public Interval Range(int dimensions)
        {
            Check(dimensions);
            int links = Links;
            Native.scarp_noise* chain = stackalloc Native.scarp_noise[links];
            Write(chain, links, null);
            var range = new Interval();
            Status status = Native.scarp_range(chain, dimensions, &range.Lowest, &range.Highest);
            if (status != Status.Ok) {
                throw new ScarpException(status, null);
            }
            return range;
        }

        /// <summary>Computes the constants of this noise once, for calls with few points. Change
        /// members before: with others, calls do without it. It has nothing of warps, whose
        /// constants each call computes.</summary>
        public void MakePlan(int dimensions)
        {
            Check(dimensions);
            var made = new Block(sizeof(Native.scarp_plan));
            Native.scarp_noise noise = data;
            Status status = Native.scarp_plan_make(&noise, dimensions,
                                                   (Native.scarp_plan*)made.Pointer);
            if (status != Status.Ok) {
                throw new ScarpException(status, null);
            }
            plan = made;
        }

        /// <summary>A copy in memory that stays where it is, with its warps and a plan for 2 or 3
        /// dimensions: for jobs, which call Native.</summary>
        public PinnedNoise Pin(int dimensions)
        {
            Check(dimensions);
            return new PinnedNoise(this, dimensions);
        }

        // Points

        /// <summary>The value at a point. For many points, Sample2 is faster by far.</summary>
        public float At(double x, double y)
        {
            float value;
            var to = new Native.scarp_samples { value = &value };
            Point(Op.Sample2F64, &x, &y, null, &to, 2);
            return value;
        }

        /// <summary>The value at a point, and its gradient.</summary>
        public float At(double x, double y, out float dx, out float dy)
        {
            float value, alongX, alongY;
            var to = new Native.scarp_samples { value = &value, dx = &alongX, dy = &alongY };
            Point(Op.Sample2F64, &x, &y, null, &to, 2);
            dx = alongX;
            dy = alongY;
            return value;
        }

        /// <summary>The value at a point of space.</summary>
        public float At(double x, double y, double z)
        {
            float value;
            var to = new Native.scarp_samples { value = &value };
            Point(Op.Sample3F64, &x, &y, &z, &to, 3);
            return value;
        }

        void Point(Op op, double* x, double* y, double* z, Native.scarp_samples* to, int dimensions)
        {
            int links = Links;
            Native.scarp_noise* chain = stackalloc Native.scarp_noise[links];
            Block constants = plan;
            Write(chain, links, constants == null ? null : (Native.scarp_plan*)constants.Pointer);
            Status status = op == Op.Sample2F64
                ? Native.scarp_sample2_f64(chain, (UIntPtr)1u, x, y, to)
                : Native.scarp_sample3_f64(chain, (UIntPtr)1u, x, y, z, to);
            GC.KeepAlive(constants);
            if (status != Status.Ok) {
                throw Complain(status, dimensions, chain, false, false);
            }
        }

        // <points> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
        /// <summary>Samples at points (x[i], y[i]). Arrays of <c>to</c> have at least as many
        /// elements as x. Detail fades some 2^23 cells from the origin: doubles are for large
        /// worlds. With floats an output may be the very same array as a coordinate.</summary>
        public void Sample2(ReadOnlySpan<float> x, ReadOnlySpan<float> y, in Samples to)
        {
            Arguments.Same(x.Length, y.Length, "y");
            fixed (float* px = x, py = y) {
                var r = new Request(Op.Sample2, x.Length, px, py, null);
                Run(&r, to);
            }
        }

        /// <summary>Samples at points of doubles, as Sample2 of floats. Outputs cannot be in
        /// place.</summary>
        public void Sample2(ReadOnlySpan<double> x, ReadOnlySpan<double> y, in Samples to)
        {
            Arguments.Same(x.Length, y.Length, "y");
            fixed (double* px = x, py = y) {
                var r = new Request(Op.Sample2F64, x.Length, px, py, null);
                Run(&r, to);
            }
        }

        /// <summary>Samples at points (x[i], y[i], z[i]) of space.</summary>
        public void Sample3(ReadOnlySpan<float> x, ReadOnlySpan<float> y, ReadOnlySpan<float> z,
            in Samples to)
        {
            Arguments.Same(x.Length, y.Length, "y");
            Arguments.Same(x.Length, z.Length, "z");
            fixed (float* px = x, py = y, pz = z) {
                var r = new Request(Op.Sample3, x.Length, px, py, pz);
                Run(&r, to);
            }
        }

        /// <summary>Samples at points of space of doubles.</summary>
        public void Sample3(ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> z,
            in Samples to)
        {
            Arguments.Same(x.Length, y.Length, "y");
            Arguments.Same(x.Length, z.Length, "z");
            fixed (double* px = x, py = y, pz = z) {
                var r = new Request(Op.Sample3F64, x.Length, px, py, pz);
                Run(&r, to);
            }
        }

        /// <summary>Vector noise: component 0 and 1 at points of the plane, as warps displace
        /// them.</summary>
        public void Vector2(ReadOnlySpan<float> x, ReadOnlySpan<float> y, in Samples first,
            in Samples second)
        {
            Arguments.Same(x.Length, y.Length, "y");
            fixed (float* px = x, py = y) {
                var r = new Request(Op.Vector2, x.Length, px, py, null);
                Run(&r, first, second, default(Samples));
            }
        }

        public void Vector2(ReadOnlySpan<double> x, ReadOnlySpan<double> y, in Samples first,
            in Samples second)
        {
            Arguments.Same(x.Length, y.Length, "y");
            fixed (double* px = x, py = y) {
                var r = new Request(Op.Vector2F64, x.Length, px, py, null);
                Run(&r, first, second, default(Samples));
            }
        }

        /// <summary>Vector noise at points of space: components 0, 1 and 2.</summary>
        public void Vector3(ReadOnlySpan<float> x, ReadOnlySpan<float> y, ReadOnlySpan<float> z,
            in Samples first, in Samples second, in Samples third)
        {
            Arguments.Same(x.Length, y.Length, "y");
            Arguments.Same(x.Length, z.Length, "z");
            fixed (float* px = x, py = y, pz = z) {
                var r = new Request(Op.Vector3, x.Length, px, py, pz);
                Run(&r, first, second, third);
            }
        }

        public void Vector3(ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> z,
            in Samples first, in Samples second, in Samples third)
        {
            Arguments.Same(x.Length, y.Length, "y");
            Arguments.Same(x.Length, z.Length, "z");
            fixed (double* px = x, py = y, pz = z) {
                var r = new Request(Op.Vector3F64, x.Length, px, py, pz);
                Run(&r, first, second, third);
            }
        }

        /// <summary>The cells around points, of frequency, seed, jitter and period; the basis
        /// changes nothing.</summary>
        public void Cells2(ReadOnlySpan<float> x, ReadOnlySpan<float> y, in Cells to)
        {
            Arguments.Same(x.Length, y.Length, "y");
            fixed (float* px = x, py = y) {
                Fields(2, x.Length, px, py, null, true, to);
            }
        }

        public void Cells2(ReadOnlySpan<double> x, ReadOnlySpan<double> y, in Cells to)
        {
            Arguments.Same(x.Length, y.Length, "y");
            fixed (double* px = x, py = y) {
                Fields(2, x.Length, px, py, null, false, to);
            }
        }

        public void Cells3(ReadOnlySpan<float> x, ReadOnlySpan<float> y, ReadOnlySpan<float> z,
            in Cells to)
        {
            Arguments.Same(x.Length, y.Length, "y");
            Arguments.Same(x.Length, z.Length, "z");
            fixed (float* px = x, py = y, pz = z) {
                Fields(3, x.Length, px, py, pz, true, to);
            }
        }

        public void Cells3(ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> z,
            in Cells to)
        {
            Arguments.Same(x.Length, y.Length, "y");
            Arguments.Same(x.Length, z.Length, "z");
            fixed (double* px = x, py = y, pz = z) {
                Fields(3, x.Length, px, py, pz, false, to);
            }
        }

        /// <summary>A velocity without divergence at points, of which this noise is the
        /// potential.</summary>
        public void Curl2(ReadOnlySpan<float> x, ReadOnlySpan<float> y, in Flow to)
        {
            Arguments.Same(x.Length, y.Length, "y");
            fixed (float* px = x, py = y) {
                Fields(2, x.Length, px, py, null, true, to);
            }
        }

        public void Curl2(ReadOnlySpan<double> x, ReadOnlySpan<double> y, in Flow to)
        {
            Arguments.Same(x.Length, y.Length, "y");
            fixed (double* px = x, py = y) {
                Fields(2, x.Length, px, py, null, false, to);
            }
        }

        public void Curl3(ReadOnlySpan<float> x, ReadOnlySpan<float> y, ReadOnlySpan<float> z,
            in Flow to)
        {
            Arguments.Same(x.Length, y.Length, "y");
            Arguments.Same(x.Length, z.Length, "z");
            fixed (float* px = x, py = y, pz = z) {
                Fields(3, x.Length, px, py, pz, true, to);
            }
        }

        public void Curl3(ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> z,
            in Flow to)
        {
            Arguments.Same(x.Length, y.Length, "y");
            Arguments.Same(x.Length, z.Length, "z");
            fixed (double* px = x, py = y, pz = z) {
                Fields(3, x.Length, px, py, pz, false, to);
            }
        }

        void Fields(int dimensions, int count, void* x, void* y, void* z, bool isFloat,
                    in Cells to)
        {
            Arguments.Given(Cells.Check(to, count, "to"), count,
                            dimensions == 2 ? Cells.AlongZ(to) : null);
            fixed (float* f1_ = to.F1, f2_ = to.F2, x_ = to.X, y_ = to.Y, z_ = to.Z, dx1_ = to.Dx1,
                dy1_ = to.Dy1, dz1_ = to.Dz1, dx2_ = to.Dx2, dy2_ = to.Dy2, dz2_ = to.Dz2)
            fixed (uint* id_ = to.Id) {
                var into = new Native.scarp_cells {
                    f1 = f1_, f2 = f2_, id = id_, x = x_, y = y_, z = z_, dx1 = dx1_, dy1 = dy1_,
                    dz1 = dz1_, dx2 = dx2_, dy2 = dy2_, dz2 = dz2_
                };
                Other(dimensions, count, x, y, z, isFloat, &into, null);
            }
        }

        void Fields(int dimensions, int count, void* x, void* y, void* z, bool isFloat,
                    in Flow to)
        {
            Arguments.Given(Flow.Check(to, count, "to"), count,
                            dimensions == 2 ? Flow.AlongZ(to) : null);
            fixed (float* vx_ = to.Vx, vy_ = to.Vy, vz_ = to.Vz, vxx_ = to.Vxx, vxy_ = to.Vxy,
                vxz_ = to.Vxz, vyx_ = to.Vyx, vyy_ = to.Vyy, vyz_ = to.Vyz, vzx_ = to.Vzx,
                vzy_ = to.Vzy, vzz_ = to.Vzz) {
                var into = new Native.scarp_flow {
                    vx = vx_, vy = vy_, vz = vz_, vxx = vxx_, vxy = vxy_, vxz = vxz_, vyx = vyx_,
                    vyy = vyy_, vyz = vyz_, vzx = vzx_, vzy = vzy_, vzz = vzz_
                };
                Other(dimensions, count, x, y, z, isFloat, null, &into);
            }
        }
        // </points>

        // Grids

        /// <summary>Samples on a grid of the plane, to the bit what Sample2 of doubles gives at its
        /// points. Arrays of `to` reach to the last element of the grid, at least.</summary>
        public void Grid2(Raster grid, in Samples to)
        {
            OnGrid(Op.Grid2, grid, to, 2);
        }

        /// <summary>Samples on a grid of space.</summary>
        public void Grid3(Raster grid, in Samples to)
        {
            OnGrid(Op.Grid3, grid, to, 3);
        }

        void OnGrid(Op op, in Raster grid, in Samples to, int dimensions)
        {
            long length = grid.Length(dimensions);
            Native.scarp_grid native = grid.ToNative();
            var r = new Request {
                op = op, grid = &native, length = length, row = grid.Gapped(dimensions),
                dimensions = dimensions
            };
            Run(&r, to);
        }

        // Cells, or a flow, whose arrays are pinned
        void Other(int dimensions, int count, void* x, void* y, void* z, bool isFloat,
                   Native.scarp_cells* cells, Native.scarp_flow* flow)
        {
            byte** coordinates = stackalloc byte*[3];
            coordinates[0] = (byte*)x;
            coordinates[1] = (byte*)y;
            coordinates[2] = (byte*)z;
            Arguments.Overlap(coordinates, 3, (isFloat ? 4L : 8L) * count,
                              cells != null ? (byte**)cells : (byte**)flow, 16, 4L * count, isFloat,
                              cells != null ? Cells.Names : Flow.Names);
            int links = Links;
            Native.scarp_noise* noise = stackalloc Native.scarp_noise[links];
            Block constants = plan;
            Write(noise, links, constants == null ? null : (Native.scarp_plan*)constants.Pointer);
            var n = (UIntPtr)(uint)count;
            float* fx = (float*)x, fy = (float*)y, fz = (float*)z;
            double* dx = (double*)x, dy = (double*)y, dz = (double*)z;
            Status status;
            if (cells != null && dimensions == 2) {
                status = isFloat ? Native.scarp_cells2(noise, n, fx, fy, cells)
                    : Native.scarp_cells2_f64(noise, n, dx, dy, cells);
            } else if (cells != null) {
                status = isFloat ? Native.scarp_cells3(noise, n, fx, fy, fz, cells)
                    : Native.scarp_cells3_f64(noise, n, dx, dy, dz, cells);
            } else if (dimensions == 2) {
                status = isFloat ? Native.scarp_curl2(noise, n, fx, fy, flow)
                    : Native.scarp_curl2_f64(noise, n, dx, dy, flow);
            } else {
                status = isFloat ? Native.scarp_curl3(noise, n, fx, fy, fz, flow)
                    : Native.scarp_curl3_f64(noise, n, dx, dy, dz, flow);
            }
            GC.KeepAlive(constants);
            if (status == Status.Unsupported && Fault(noise, dimensions) == null) {
                throw new ScarpException(status, "Vxx",
                                         "this noise, or a warp of it, has no Jacobian");
            }
            if (status != Status.Ok) {
                throw Complain(status, dimensions, noise, false, false);
            }
        }

        // Shaders

        /// <summary>The constant buffer of this noise for scarp.hlsl and its like, in 2 or 3
        /// dimensions: 1344 words.</summary>
        public uint[] ShaderPlan(int dimensions)
        {
            return Constants(dimensions, false);
        }

        /// <summary>The same for vector noise and curl in shaders.</summary>
        public uint[] VectorShaderPlan(int dimensions)
        {
            return Constants(dimensions, true);
        }

        uint[] Constants(int dimensions, bool isVector)
        {
            Check(dimensions);
            int links = Links;
            Native.scarp_noise* chain = stackalloc Native.scarp_noise[links];
            Write(chain, links, null);
            var words = new uint[sizeof(Native.scarp_gpu_plan) / 4];
            byte* member;
            fixed (uint* p = words) {
                var to = (Native.scarp_gpu_plan*)p;
                Status status = isVector
                    ? Native.scarp_gpu_vector_plan_make(chain, dimensions, to, &member)
                    : Native.scarp_gpu_plan_make(chain, dimensions, to, &member);
                if (status != Status.Ok) {
                    throw new ScarpException(status, Text.Member(member), Text.Of(
                        Native.scarp_gpu_plan_fault(chain, dimensions, isVector ? 1 : 0, null)));
                }
            }
            return words;
        }

        /// <summary>What scarp_answer2, or 3, must give in a shader, with derivatives up to an
        /// order from 0 to 2: Native.SCARP_GPU_ANSWERS words. If all are equal, the driver keeps
        /// the bits.</summary>
        public uint[] ShaderAnswers(int dimensions, int order)
        {
            Check(dimensions);
            int links = Links;
            Native.scarp_noise* chain = stackalloc Native.scarp_noise[links];
            Write(chain, links, null);
            var words = new uint[Native.SCARP_GPU_ANSWERS];
            fixed (uint* p = words) {
                Status status = Native.scarp_gpu_answers(chain, dimensions, order, p);
                if (status != Status.Ok) {
                    ShaderPlan(dimensions); // which may be what fails
                    throw new ScarpException(status, "order");
                }
            }
            return words;
        }
    }

    /// <summary>A noise in memory that stays where it is until Dispose, with its warps and a plan:
    /// what jobs and Burst hand to the calls of Native. Hold on to it while jobs run, and dispose it
    /// when the last one is done: memory that nobody holds is freed, too.</summary>
    public sealed unsafe class PinnedNoise : IDisposable
    {
        readonly Block block;

        internal PinnedNoise(Noise noise, int dimensions)
        {
            int links = noise.Links, bytes = links * sizeof(Native.scarp_noise);
            block = new Block(bytes + sizeof(Native.scarp_plan));
            var plan = (Native.scarp_plan*)((byte*)block.Pointer + bytes);
            noise.Write((Native.scarp_noise*)block.Pointer, links, plan);
            Status status = Native.scarp_plan_make((Native.scarp_noise*)block.Pointer, dimensions,
                                                   plan);
            GC.KeepAlive(this);
            if (status != Status.Ok) {
                throw new ScarpException(status, null);
            }
        }

        /// <summary>For the calls of Native. ObjectDisposedException after Dispose.</summary>
        public Native.scarp_noise* Pointer { get { return (Native.scarp_noise*)Address; } }

        /// <summary>The same, where code is not unsafe.</summary>
        public IntPtr Address
        {
            get
            {
                if (block.IsClosed) {
                    throw new ObjectDisposedException("PinnedNoise");
                }
                return (IntPtr)block.Pointer;
            }
        }

        public void Dispose()
        {
            block.Dispose();
        }
    }

    // The chain rule: functions of samples, with exact derivatives. Arrays have `count` elements at
    // least. What `to` has is computed; every input needs the same members, and for derivatives the
    // values, too. An output may be the very same array as an input.
    public unsafe ref partial struct Samples
    {
        // <chain> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
        /// <summary><c>scale * a + offset</c>.</summary>
        public static void Affine(int count, in Samples a, float scale, float offset, in Samples to)
        {
            Run(Function.Affine, "scale, offset", count, 1, a, default(Samples), default(Samples),
                to, scale, offset);
        }

        /// <summary><c>a + b</c>, in all members.</summary>
        public static void Add(int count, in Samples a, in Samples b, in Samples to)
        {
            Run(Function.Add, "", count, 2, a, b, default(Samples), to);
        }

        /// <summary><c>a * b</c>: a product is 0 where a factor is 0, even if the other one is
        /// NaN.</summary>
        public static void Multiply(int count, in Samples a, in Samples b, in Samples to)
        {
            Run(Function.Multiply, "", count, 2, a, b, default(Samples), to);
        }

        /// <summary><c>a</c> where <c>m</c> is 0, <c>b</c> where <c>m</c> is 1, and
        /// <c>a + m * (b - a)</c> between: slopes of <c>m</c> count, too.</summary>
        public static void Mix(int count, in Samples a, in Samples b, in Samples m, in Samples to)
        {
            Run(Function.Mix, "", count, 3, a, b, m, to);
        }

        /// <summary>The lesser of <c>a</c> and <c>b</c>, with a crease where both are equal; NaN
        /// before any number.</summary>
        public static void Min(int count, in Samples a, in Samples b, in Samples to)
        {
            Run(Function.Min, "", count, 2, a, b, default(Samples), to);
        }

        /// <summary>The greater of <c>a</c> and <c>b</c>, with a crease where both are equal; NaN
        /// before any number.</summary>
        public static void Max(int count, in Samples a, in Samples b, in Samples to)
        {
            Run(Function.Max, "", count, 2, a, b, default(Samples), to);
        }

        /// <summary>The lesser of <c>a</c> and <c>b</c>, without a crease: less by <c>k / 6</c> at
        /// most, where they differ by less than <c>k</c>.</summary>
        public static void SmoothMin(int count, in Samples a, in Samples b, float k, in Samples to)
        {
            Run(Function.SmoothMin, "k", count, 2, a, b, default(Samples), to, k);
        }

        /// <summary>The greater of <c>a</c> and <c>b</c>, without a crease: more by <c>k / 6</c> at
        /// most, where they differ by less than <c>k</c>.</summary>
        public static void SmoothMax(int count, in Samples a, in Samples b, float k, in Samples to)
        {
            Run(Function.SmoothMax, "k", count, 2, a, b, default(Samples), to, k);
        }

        /// <summary><c>a</c>, but <c>lo</c> where it is less and <c>hi</c> where it is more, with
        /// creases there.</summary>
        public static void Clamp(int count, in Samples a, float lo, float hi, in Samples to)
        {
            Run(Function.Clamp, "lo, hi", count, 1, a, default(Samples), default(Samples), to, lo,
                hi);
        }

        /// <summary><c>|a|</c>, with a crease at 0.</summary>
        public static void Abs(int count, in Samples a, in Samples to)
        {
            Run(Function.Abs, "", count, 1, a, default(Samples), default(Samples), to);
        }

        /// <summary><c>sqrt(a^2 + round^2)</c>: the magnitude of <c>a</c>, with a round
        /// floor.</summary>
        public static void SmoothAbs(int count, in Samples a, float round, in Samples to)
        {
            Run(Function.SmoothAbs, "round", count, 1, a, default(Samples), default(Samples), to,
                round);
        }

        /// <summary>From 0 where <c>a</c> is <c>lo</c> or beyond, to 1 where it is <c>hi</c> or
        /// beyond: masks for mixes.</summary>
        public static void Smoothstep(int count, in Samples a, float lo, float hi, in Samples to)
        {
            Run(Function.Smoothstep, "lo, hi", count, 1, a, default(Samples), default(Samples), to,
                lo, hi);
        }

        /// <summary>Steps in a slope: <c>steps</c> per unit of value, of which the part
        /// <c>riser</c>, in [2^-20, 1], rises. <c>strength</c>, in [0, 1], says how level treads
        /// are.</summary>
        public static void Terrace(int count, in Samples a, float steps, float riser,
            float strength, in Samples to)
        {
            Run(Function.Terrace, "steps, riser, strength", count, 1, a, default(Samples),
                default(Samples), to, steps, riser, strength);
        }

        /// <summary><c>a / b</c>: infinite or NaN where <c>b</c> is 0.</summary>
        public static void Divide(int count, in Samples a, in Samples b, in Samples to)
        {
            Run(Function.Divide, "", count, 2, a, b, default(Samples), to);
        }

        /// <summary>The square root of <c>a</c>, and 0 where <c>a</c> is less than 0.</summary>
        public static void Sqrt(int count, in Samples a, in Samples to)
        {
            Run(Function.Sqrt, "", count, 1, a, default(Samples), default(Samples), to);
        }

        /// <summary><c>sin(2 pi a)</c>: <c>a</c> counts turns.</summary>
        public static void Sine(int count, in Samples a, in Samples to)
        {
            Run(Function.Sine, "", count, 1, a, default(Samples), default(Samples), to);
        }

        /// <summary><c>a</c> folded to and fro between -1 and 1, with the period 2.</summary>
        public static void Pulse(int count, in Samples a, in Samples to)
        {
            Run(Function.Pulse, "", count, 1, a, default(Samples), default(Samples), to);
        }

        /// <summary>The length of the gradient of <c>a</c>. It has first derivatives where <c>a</c>
        /// has second ones.</summary>
        public static void Slope(int count, in Samples a, in Samples to)
        {
            Run(Function.Slope, "", count, 1, a, default(Samples), default(Samples), to);
        }

        internal enum Function
        {
            Affine, Add, Multiply, Mix, Min, Max, SmoothMin, SmoothMax, Clamp, Abs, SmoothAbs,
            Smoothstep, Terrace, Divide, Sqrt, Sine, Pulse, Slope
        }

        internal static Status Call(Function function, UIntPtr count,
                                    Native.scarp_samples* s, float* x)
        {
            switch (function) {
            case Function.Affine: return Native.scarp_affine(count, s, x[0], x[1], s + 1);
            case Function.Add: return Native.scarp_add(count, s, s + 1, s + 2);
            case Function.Multiply: return Native.scarp_multiply(count, s, s + 1, s + 2);
            case Function.Mix: return Native.scarp_mix(count, s, s + 1, s + 2, s + 3);
            case Function.Min: return Native.scarp_min(count, s, s + 1, s + 2);
            case Function.Max: return Native.scarp_max(count, s, s + 1, s + 2);
            case Function.SmoothMin: return Native.scarp_smooth_min(count, s, s + 1, x[0], s + 2);
            case Function.SmoothMax: return Native.scarp_smooth_max(count, s, s + 1, x[0], s + 2);
            case Function.Clamp: return Native.scarp_clamp(count, s, x[0], x[1], s + 1);
            case Function.Abs: return Native.scarp_abs(count, s, s + 1);
            case Function.SmoothAbs: return Native.scarp_smooth_abs(count, s, x[0], s + 1);
            case Function.Smoothstep: return Native.scarp_smoothstep(count, s, x[0], x[1], s + 1);
            case Function.Terrace: return Native.scarp_terrace(count, s, x[0], x[1], x[2], s + 1);
            case Function.Divide: return Native.scarp_divide(count, s, s + 1, s + 2);
            case Function.Sqrt: return Native.scarp_sqrt(count, s, s + 1);
            case Function.Sine: return Native.scarp_sine(count, s, s + 1);
            case Function.Pulse: return Native.scarp_pulse(count, s, s + 1);
            default: return Native.scarp_slope(count, s, s + 1);
            }
        }
        // </chain>

        /// <summary>A smooth curve through 2 to 64 knots: value[k] where a is x[k]. x
        /// rises.</summary>
        public static void Curve(int count, in Samples a, ReadOnlySpan<float> x,
                                 ReadOnlySpan<float> value, in Samples to)
        {
            Arguments.Same(x.Length, value.Length, "value");
            fixed (float* px = x, pv = value) {
                var r = new Request {
                    op = Op.Curve, x = px, y = pv, knots = (UIntPtr)(uint)x.Length
                };
                Run(&r, "x, value", count, 1, a, default(Samples), default(Samples), to);
            }
        }

        static void Run(Function function, string numbers, int count, int inputs, in Samples a,
                        in Samples b, in Samples m, in Samples to, float first = 0,
                        float second = 0, float third = 0, float fourth = 0)
        {
            float* given = stackalloc float[4];
            given[0] = first;
            given[1] = second;
            given[2] = third;
            given[3] = fourth;
            var r = new Request { op = Op.Chain, function = function, numbers = given };
            Run(&r, numbers, count, inputs, a, b, m, to);
        }

        static void Run(Request* r, string numbers, int count, int inputs, in Samples a,
                        in Samples b, in Samples m, in Samples to)
        {
            if (count < 0) {
                throw new ArgumentOutOfRangeException("count");
            }
            Library.Check();
            r->count = (UIntPtr)(uint)count;
            r->length = count;
            r->reads = inputs;
            r->dimensions = 3;
            Native.scarp_samples* into = stackalloc Native.scarp_samples[4];
            Status status = inputs == 1
                ? Request.Pin(r, into, 0, 2, a, to, default(Samples), default(Samples))
                : inputs == 2 ? Request.Pin(r, into, 0, 3, a, b, to, default(Samples))
                : Request.Pin(r, into, 0, 4, a, b, m, to);
            if (status == Status.Null) {
                throw new ArgumentException("lacks an array that an output needs", inputs == 1 ? "a"
                                            : inputs == 2 ? "a, b" : "a, b, m");
            }
            if (status != Status.Ok) {
                throw new ScarpException(status, numbers.Length == 0 || status != Status.Parameter
                                         ? null
                                         : numbers);
            }
        }

        static readonly string[] NormalNames = { "nx", "ny", "nz" };

        /// <summary>Unit normals of the surface z = heightScale value, from its gradient: x and y
        /// are the axes of the input, z points up. Arrays have as many elements as dx; any of the
        /// last three may be missing, and may be the very same array as an input.</summary>
        public static void Normals(ReadOnlySpan<float> dx, ReadOnlySpan<float> dy,
                                          float heightScale, Span<float> nx, Span<float> ny,
                                          Span<float> nz)
        {
            Library.Check();
            if (dy.Length != dx.Length) {
                throw new ArgumentException("has " + dy.Length + " elements, and dx has "
                                            + dx.Length, "dy");
            }
            Arguments.Room(nx, dx.Length, null, "nx");
            Arguments.Room(ny, dx.Length, null, "ny");
            Arguments.Room(nz, dx.Length, null, "nz");
            fixed (float* px = dx, py = dy, ax = nx, ay = ny, az = nz) {
                byte** read = stackalloc byte*[2];
                byte** written = stackalloc byte*[3];
                read[0] = (byte*)px;
                read[1] = (byte*)py;
                written[0] = (byte*)ax;
                written[1] = (byte*)ay;
                written[2] = (byte*)az;
                long bytes = 4L * dx.Length;
                Arguments.Overlap(read, 2, bytes, written, 3, bytes, true, NormalNames);
                Status status = Native.scarp_normals((UIntPtr)(uint)dx.Length, px, py, heightScale,
                                                     ax, ay, az);
                if (status != Status.Ok) {
                    throw new ScarpException(status, "heightScale");
                }
            }
        }
    }

    /// <summary>An error of a recipe's text. Line and Column count from 1.</summary>
    public sealed class RecipeError
    {
        public int Line { get; internal set; }
        public int Column { get; internal set; }

        /// <summary>A clause without a full stop.</summary>
        public string Text { get; internal set; }

        /// <summary>The argument at fault, as the language spells it; or null.</summary>
        public string Member { get; internal set; }

        /// <summary>A number that would do there; 0: none is told.</summary>
        public double Nearest { get; internal set; }

        public override string ToString()
        {
            return "line " + Line + ", column " + Column + ": " + (Member == null ? "" : Member
                + ": ")
                + Text;
        }
    }

    /// <summary>A text that is no recipe, or a parameter with which it is none.</summary>
    public sealed class RecipeException : ScarpException
    {
        /// <summary>In the order of the text, at most 32.</summary>
        public IReadOnlyList<RecipeError> Errors { get; }

        public int Line { get { return Errors[0].Line; } }
        public int Column { get { return Errors[0].Column; } }

        internal RecipeException(Status status, List<RecipeError> errors)
            : base(status, null, string.Join("\n", errors))
        {
            Errors = errors;
        }
    }

    /// <summary>A parameter of a recipe, and the interval that the text gives it.</summary>
    public struct Parameter
    {
        public double Value, Lowest, Highest;
    }

    /// <summary>What an output of a recipe is made of: the lengths of its largest and its smallest
    /// cell, 0 without a noise; whether values may jump; the highest order of derivatives.</summary>
    public struct OutputInfo
    {
        public double LargestCell, SmallestCell;
        public bool Jumps;
        public int Order;
    }

    /// <summary>A box of points; the plane ignores z.</summary>
    public struct Box
    {
        public double LowestX, LowestY, LowestZ, HighestX, HighestY, HighestZ;
    }

    /// <summary>A composition of noises as a text; src/recipe/README.md teaches the language.
    /// Threads may sample it while another one changes it: calls under way keep what they began
    /// with.</summary>
    public sealed unsafe class Recipe
    {
        const int MostErrors = 32;

        const int MostScratch = 1 << 28; // bytes that calls are tried with

        struct Entry
        {
            public int index, output, dimensions;
            public uint order;
            public bool isParameter, isField;
            public Parameter parameter;
            public OutputInfo info;
        }

        // What calls read. It is never changed, but replaced.
        sealed class State
        {
            public Block block, plan;
            public ulong seed;
            public double finest;
            public readonly Dictionary<string, Entry> entries = new Dictionary<string, Entry>();

            public Native.scarp_recipe* Pointer
            {
                get { return (Native.scarp_recipe*)block.Pointer; }
            }
        }

        [ThreadStatic] static ulong[] scratch;
        readonly byte[] bytes;
        readonly string[] outputs;
        readonly object gate = new object();
        volatile State state;

        /// <summary>Reads a text. Throws RecipeException, which has line and column, if it has
        /// errors.</summary>
        public Recipe(string text, ulong seed = 0)
        {
            if (text == null) {
                throw new ArgumentNullException("text");
            }
            Library.Check();
            Text = text;
            bytes = Encoding.UTF8.GetBytes(text + "\0");
            var made = new State { block = new Block(sizeof(Native.scarp_recipe)) };
            Native.scarp_recipe_error* errors = stackalloc Native.scarp_recipe_error[MostErrors];
            UIntPtr found;
            fixed (byte* p = bytes) {
                Status status = Native.scarp_recipe_parse(p, (UIntPtr)(uint)(bytes.Length - 1),
                                                          made.Pointer, errors,
                                                          (UIntPtr)(uint)MostErrors, &found);
                if (status != Status.Ok && (uint)found > 0) {
                    int count = (int)Math.Min((uint)found, MostErrors);
                    throw new RecipeException(status, ErrorsOf(errors, count));
                }
                if (status != Status.Ok) {
                    throw new ScarpException(status, "text",
                                             "a recipe has at most 16,384 bytes, not "
                                             + (bytes.Length - 1));
                }
            }
            Describe(made);
            made.plan = PlanOf(made.block);
            state = made;
            outputs = OutputsOf(made);
            Dimensions = made.entries[outputs[0]].dimensions;
            if (seed != 0) {
                Seed = seed;
            }
        }

        /// <summary>The same with a seed that may be negative: -1 is 2^64 - 1.</summary>
        public Recipe(string text, long seed) : this(text, unchecked((ulong)seed))
        {
        }

        public string Text { get; }

        /// <summary>2, or 3 for a recipe of space.</summary>
        public int Dimensions { get; }

        /// <summary>The names of the outputs, in the order of the text.</summary>
        public IReadOnlyList<string> Outputs { get { return outputs; } }

        /// <summary>The seed of the world, which all noises follow.</summary>
        public ulong Seed { get { return state.seed; } set { SetSeed(value); } }

        /// <summary>The same seed with a sign: -1 is 2^64 - 1.</summary>
        public long SignedSeed
        {
            get { return unchecked((long)state.seed); }
            set { SetSeed(unchecked((ulong)value)); }
        }

        void SetSeed(ulong seed)
        {
            Change((r, error) => Native.scarp_recipe_seed(r, seed), "Seed",
                   made => made.seed = seed);
        }

        /// <summary>Octaves whose cells are smaller than so many units are left out; 0:
        /// none.</summary>
        public double Finest
        {
            get { return state.finest; }
            set { SetNumber("finest", value); }
        }

        void SetNumber(string name, double value)
        {
            byte[] text = Encoding.UTF8.GetBytes(name + "\0");
            Change((r, error) => {
                fixed (byte* p = text) {
                    return Native.scarp_recipe_set(r, p, value, error);
                }
            }, name, made => made.finest = name == "finest" ? value : made.finest);
        }

        /// <summary>Makes the recipe repeat after so many units along each axis, in place of a tile
        /// in the text; with 0 for all it does not. The plane ignores z.</summary>
        public void Tile(double x, double y, double z = 0)
        {
            Change((r, error) => Native.scarp_recipe_tile(r, x, y, z, error), "Tile", null);
        }

        /// <summary>Makes the recipe so many times larger, as scale(..., by) does with each
        /// statement, and multiplies the first output by `heights`. Both are 1 at first.</summary>
        public void Scale(double by, double heights = 1)
        {
            Change((r, error) => Native.scarp_recipe_scale(r, by, heights, error), "Scale", null);
        }

        /// <summary>What an output is made of, or any other field of the text; default: the first
        /// output.</summary>
        public OutputInfo Info(string output = null)
        {
            return Field(state, output, 0, "output").info;
        }

        /// <summary>The parameters by name.</summary>
        public IReadOnlyDictionary<string, Parameter> Parameters
        {
            get
            {
                var made = new Dictionary<string, Parameter>();
                foreach (KeyValuePair<string, Entry> pair in state.entries) {
                    if (pair.Value.isParameter) {
                        made[pair.Key] = pair.Value.parameter;
                    }
                }
                return made;
            }
        }

        /// <summary>The value of a parameter. KeyNotFoundException for a name that there is not,
        /// ScarpException for a value outside its interval.</summary>
        public double this[string parameter]
        {
            get { return Find(parameter).Value; }
            set
            {
                Parameter old = Find(parameter);
                if (!(value >= old.Lowest && value <= old.Highest)) {
                    throw new ScarpException(Status.Parameter, parameter, value + " is not in ["
                                             + old.Lowest + ", " + old.Highest + "]");
                }
                SetNumber(parameter, value);
            }
        }

        Parameter Find(string name)
        {
            Entry entry;
            if (name == null || !state.entries.TryGetValue(name, out entry) || !entry.isParameter) {
                throw new KeyNotFoundException("the recipe has no parameter " + name
                                               + "; there are "
                                               + string.Join(", ", Parameters.Keys));
            }
            return entry.parameter;
        }

        static List<RecipeError> ErrorsOf(Native.scarp_recipe_error* errors, int count)
        {
            var made = new List<RecipeError>();
            for (int i = 0; i < count; i++) {
                made.Add(new RecipeError {
                    Line = errors[i].line, Column = errors[i].column,
                    Text = Internal.Text.Of(errors[i].text),
                    Member = Internal.Text.Of(errors[i].member), Nearest = errors[i].nearest
                });
            }
            return made;
        }

        void Describe(State made)
        {
            Native.scarp_recipe_entry entry;
            for (int i = 0; Native.scarp_recipe_entry_at(made.Pointer, (UIntPtr)(uint)i, &entry)
                     == Status.Ok; i++) {
                int from = (int)entry.name[0], to = (int)entry.name[1];
                made.entries[Encoding.UTF8.GetString(bytes, from, to - from)] = new Entry {
                    index = i, output = entry.output, order = entry.order,
                    dimensions = (int)entry.dimensions,
                    isParameter = entry.is_param != 0,
                    isField = entry.kind == (int)RecipeKind.Field
                        || entry.kind == (int)RecipeKind.Noise,
                    parameter = new Parameter {
                        Value = entry.value, Lowest = entry.slider[0], Highest = entry.slider[1]
                    },
                    info = new OutputInfo {
                        LargestCell = entry.cell[0], SmallestCell = entry.cell[1],
                        Jumps = entry.jumps != 0, Order = (int)entry.order
                    }
                };
            }
        }

        // The constants of all noises, so that calls with few points are fast
        internal static Block PlanOf(Block recipe)
        {
            var r = (Native.scarp_recipe*)recipe.Pointer;
            UIntPtr size = Native.scarp_recipe_plan_size(r);
            var plan = new Block((int)size);
            Native.scarp_recipe_plan_make(r, plan.Pointer, size); // else it is zeros: no plan
            GC.KeepAlive(recipe);
            return plan;
        }

        static string[] OutputsOf(State made)
        {
            var names = new SortedDictionary<int, string>();
            foreach (KeyValuePair<string, Entry> pair in made.entries) {
                if (pair.Value.output >= 0) {
                    names[pair.Value.output] = pair.Key;
                }
            }
            var found = new string[names.Count];
            names.Values.CopyTo(found, 0);
            return found;
        }

        delegate Status Call(Native.scarp_recipe* recipe, Native.scarp_recipe_error* error);

        // Changes a copy, and puts it in the place of the old one.
        void Change(Call call, string atFault, Action<State> keep)
        {
            lock (gate) {
                State old = state;
                var made = new State {
                    block = new Block(old.block), finest = old.finest, seed = old.seed
                };
                var error = new Native.scarp_recipe_error();
                Status status = call(made.Pointer, &error);
                if (status != Status.Ok && error.text != null) {
                    throw new RecipeException(status, ErrorsOf(&error, 1));
                }
                if (status != Status.Ok) {
                    throw new ScarpException(status, atFault);
                }
                if (keep != null) {
                    keep(made);
                }
                Describe(made);
                made.plan = PlanOf(made.block);
                state = made;
            }
        }

        // Samples

        // <recipe> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
        /// <summary>Samples an output, or any other field of the text, at points; default: the
        /// first output. Arrays of <c>to</c> have at least as many elements as x, and overlap
        /// nothing.</summary>
        public void Sample2(ReadOnlySpan<float> x, ReadOnlySpan<float> y, in Samples to,
            string output = null)
        {
            Arguments.Same(x.Length, y.Length, "y");
            fixed (float* px = x, py = y) {
                var r = new Request(Op.Recipe, x.Length, px, py, null);
                Run(&r, 2, to, output);
            }
        }

        public void Sample2(ReadOnlySpan<double> x, ReadOnlySpan<double> y, in Samples to,
            string output = null)
        {
            Arguments.Same(x.Length, y.Length, "y");
            fixed (double* px = x, py = y) {
                var r = new Request(Op.RecipeF64, x.Length, px, py, null);
                Run(&r, 2, to, output);
            }
        }

        public void Sample3(ReadOnlySpan<float> x, ReadOnlySpan<float> y, ReadOnlySpan<float> z,
            in Samples to, string output = null)
        {
            Arguments.Same(x.Length, y.Length, "y");
            Arguments.Same(x.Length, z.Length, "z");
            fixed (float* px = x, py = y, pz = z) {
                var r = new Request(Op.Recipe, x.Length, px, py, pz);
                Run(&r, 3, to, output);
            }
        }

        public void Sample3(ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> z,
            in Samples to, string output = null)
        {
            Arguments.Same(x.Length, y.Length, "y");
            Arguments.Same(x.Length, z.Length, "z");
            fixed (double* px = x, py = y, pz = z) {
                var r = new Request(Op.RecipeF64, x.Length, px, py, pz);
                Run(&r, 3, to, output);
            }
        }
        // </recipe>

        /// <summary>Samples an output, or any other field, on a grid: arrays are as Noise.Grid2, or
        /// Grid3 for a recipe of space, has them.</summary>
        public void Grid(Raster grid, in Samples to, string output = null)
        {
            Native.scarp_grid native = grid.ToNative();
            Request r = OnGrid(grid, &native);
            Run(&r, Dimensions, to, output);
        }

        /// <summary>Two outputs, or fields, at little more cost than one.</summary>
        public void Grid(Raster grid, in Samples to, string output, in Samples second,
                         string secondOutput)
        {
            Native.scarp_grid native = grid.ToNative();
            Request r = OnGrid(grid, &native);
            Run(&r, Dimensions, to, output, second, secondOutput, 2);
        }

        /// <summary>Two outputs, or fields, at points of the plane.</summary>
        public void Sample2(ReadOnlySpan<float> x, ReadOnlySpan<float> y, in Samples to,
                            string output,
                            in Samples second, string secondOutput)
        {
            Arguments.Same(x.Length, y.Length, "y");
            fixed (float* px = x, py = y) {
                var r = new Request(Op.Recipe, x.Length, px, py, null);
                Run(&r, 2, to, output, second, secondOutput, 2);
            }
        }

        Request OnGrid(in Raster grid, Native.scarp_grid* native)
        {
            return new Request {
                op = Op.RecipeGrid, grid = native, length = grid.Length(Dimensions),
                row = grid.Gapped(Dimensions)
            };
        }

        Entry Field(State now, string name, int order, string to)
        {
            Entry entry;
            if (!now.entries.TryGetValue(name ?? outputs[0], out entry) || !entry.isField) {
                throw new ArgumentException("there is no output or field " + name + "; outputs are "
                                            + string.Join(", ", outputs), "output");
            }
            if (entry.order < order) {
                throw new ScarpException(Status.Unsupported, to, (name ?? outputs[0])
                                         + " has no derivatives of the order " + order
                                         + ", only up to " + entry.order);
            }
            return entry;
        }

        void Run(Request* r, int dimensions, in Samples to, string output)
        {
            Run(r, dimensions, to, output, default(Samples), null, 1);
        }

        void Run(Request* r, int dimensions, in Samples to, string output, in Samples second,
                 string secondOutput, int count)
        {
            if (dimensions != Dimensions) {
                throw new ArgumentException(Dimensions == 3 ? "the recipe is of space: it needs z"
                                            : "the recipe is of the plane: it has no z", "z");
            }
            r->dimensions = dimensions;
            State now = state;
            int* which = stackalloc int[2];
            int order = Samples.Order(to);
            which[0] = Field(now, output, order, "to").index;
            if (count == 2) {
                which[1] = Field(now, secondOutput, Samples.Order(second), "second").index;
                order = Math.Max(order, Samples.Order(second));
            }
            if (to.Dphase != default(Span<float>) || second.Dphase != default(Span<float>)) {
                throw new ScarpException(Status.Unsupported, "Dphase",
                                         "recipes have no derivative with respect to the phase");
            }
            var asked = new Native.scarp_recipe_outputs { which = which, count = count };
            r->recipe = now.Pointer;
            r->outputs = &asked;
            Native.scarp_samples* into = stackalloc Native.scarp_samples[2];
            // That is the size for outputs of the text. Other fields may need more.
            long size = ScratchSize(now, order, r->length);
            Status status = Status.Size;
            for (; status == Status.Size && size <= MostScratch; size = Math.Max(2 * size, 8192)) {
                if (scratch == null || scratch.Length < size / 8 + 1) {
                    scratch = new ulong[size / 8 + 1];
                }
                fixed (ulong* memory = scratch) {
                    var room = new Native.scarp_scratch {
                        memory = memory, size = (UIntPtr)(ulong)(size / 8 * 8 + 8),
                        plan = now.plan.Pointer
                    };
                    r->scratch = &room;
                    status = Request.Pin(r, into, 0, count, to, second, default(Samples),
                                         default(Samples));
                }
            }
            GC.KeepAlive(now.block);
            GC.KeepAlive(now.plan);
            if (status != Status.Ok) {
                throw new ScarpException(status, r->grid != null && status == Status.Parameter
                                         ? "grid" : null);
            }
        }

        // The best size for outputs of the text, or less if fewer points do with that.
        static long ScratchSize(State now, int order, long points)
        {
            ulong best = (ulong)Native.scarp_recipe_scratch_size(now.Pointer, order, UIntPtr.Zero);
            ulong few = (ulong)Native.scarp_recipe_scratch_size(now.Pointer, order,
                                                                (UIntPtr)(ulong)Math.Max(points, 1));
            return (long)(few > 0 && few < best ? few : best);
        }

        /// <summary>The interval that values of an output, or another field, never leave: at all
        /// points, or those in a box. It is infinite where coordinates count and there is no
        /// box.</summary>
        public Interval Range(string output = null, Box? box = null)
        {
            State now = state;
            var where = new Native.scarp_box();
            Box given = box ?? default(Box);
            where.lowest[0] = given.LowestX;
            where.lowest[1] = given.LowestY;
            where.lowest[2] = given.LowestZ;
            where.highest[0] = given.HighestX;
            where.highest[1] = given.HighestY;
            where.highest[2] = given.HighestZ;
            var range = new Interval();
            int which = Field(now, output, 0, "to").index;
            Status status = Native.scarp_recipe_range(now.Pointer, which,
                                                      box == null ? null : &where, &range.Lowest,
                                                      &range.Highest);
            GC.KeepAlive(now.block);
            if (status != Status.Ok) {
                throw new ScarpException(status, "box");
            }
            return range;
        }

        /// <summary>A copy in memory that stays where it is, for jobs, which call Native.</summary>
        public PinnedRecipe Pin()
        {
            return new PinnedRecipe(state.block);
        }

        // Shaders

        /// <summary>This recipe as functions of a shading language. `file` is the text of
        /// scarp.glsl, scarp.hlsl or scarp.wgsl; order that of the derivatives, from 0 to
        /// 2.</summary>
        public string Shader(Language language, string file, int order = 1)
        {
            if (file == null) {
                throw new ArgumentNullException("file");
            }
            State now = state;
            byte[] content = Encoding.UTF8.GetBytes(file + "\0");
            fixed (byte* p = content) {
                var how = new Native.scarp_shader {
                    language = (int)language, order = order, file = p,
                    length = (UIntPtr)(uint)(content.Length - 1)
                };
                UIntPtr length;
                Status status = Native.scarp_recipe_shader(now.Pointer, &how, null, UIntPtr.Zero,
                                                           &length);
                var text = new byte[status == Status.Size ? (int)length + 1 : 1];
                fixed (byte* to = text) {
                    status = Native.scarp_recipe_shader(now.Pointer, &how, to,
                                                        (UIntPtr)(uint)text.Length, &length);
                }
                GC.KeepAlive(now.block);
                if (status != Status.Ok) {
                    throw new ScarpException(status, "file",
                                             "is not that of this language and version, "
                                             + "or there is no such order");
                }
                return Encoding.UTF8.GetString(text, 0, (int)length);
            }
        }

        /// <summary>The uniform buffer of that shader, with seed and parameters.</summary>
        public byte[] ShaderUniforms()
        {
            State now = state;
            var made = new byte[0];
            for (;;) {
                UIntPtr size;
                Status status;
                fixed (byte* to = made) {
                    status = Native.scarp_recipe_uniforms(now.Pointer, to,
                                                          (UIntPtr)(uint)made.Length, &size);
                }
                GC.KeepAlive(now.block);
                if (status == Status.Ok) {
                    return made;
                }
                if (status != Status.Size || made.Length == (int)size) {
                    throw new ScarpException(status, null);
                }
                made = new byte[(int)size];
            }
        }

        /// <summary>What scarp_answer_recipe must give in that shader, with an order from 0 to
        /// 2.</summary>
        public uint[] ShaderAnswers(int order)
        {
            State now = state;
            var words = new uint[Native.SCARP_GPU_ANSWERS];
            fixed (uint* p = words) {
                Status status = Native.scarp_recipe_answers(now.Pointer, order, p);
                GC.KeepAlive(now.block);
                if (status != Status.Ok) {
                    throw new ScarpException(status, "order");
                }
            }
            return words;
        }
    }

    /// <summary>A recipe in memory that stays where it is until Dispose. Jobs call Native with it,
    /// each with scratch memory of its own, or without any.</summary>
    public sealed unsafe class PinnedRecipe : IDisposable
    {
        readonly Block block, plan;

        internal PinnedRecipe(Block of)
        {
            block = new Block(of);
            plan = Recipe.PlanOf(block);
        }

        /// <summary>For the calls of Native. ObjectDisposedException after Dispose.</summary>
        public Native.scarp_recipe* Pointer { get { return (Native.scarp_recipe*)Address; } }

        /// <summary>The same, where code is not unsafe.</summary>
        public IntPtr Address
        {
            get
            {
                if (block.IsClosed) {
                    throw new ObjectDisposedException("PinnedRecipe");
                }
                return (IntPtr)block.Pointer;
            }
        }

        /// <summary>For scarp_scratch.plan: with it, calls with few points are fast.</summary>
        public void* Plan
        {
            get
            {
                if (plan.IsClosed) {
                    throw new ObjectDisposedException("PinnedRecipe");
                }
                return plan.Pointer;
            }
        }

        public void Dispose()
        {
            block.Dispose();
            plan.Dispose();
        }
    }

    public static unsafe partial class Native
    {
        // Where libraries are linked into the program, they have this name.
#if (UNITY_IOS || UNITY_TVOS || UNITY_VISIONOS || UNITY_WEBGL) && !UNITY_EDITOR
        const string Library = "__Internal";
#else
        const string Library = "scarp"; // scarp.dll, libscarp.so, libscarp.dylib
#endif
    }

    // <tables> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
    /// <summary>enum scarp_status</summary>
    public enum Status
    {
        Ok = 0,
        Null = 1,
        Enum = 2,
        Parameter = 3,
        Size = 4,
        Unsupported = 5,
    }

    /// <summary>enum scarp_basis</summary>
    public enum Basis
    {
        Gradient = 0,
        Value = 1,
        Simplex = 2,
        CellF1 = 3,
        CellF2 = 4,
        CellEdge = 5,
        CellSoft = 6,
        CellValue = 7,
    }

    /// <summary>enum scarp_fade</summary>
    public enum Fade
    {
        Quintic = 0,
        Cubic = 1,
    }

    /// <summary>enum scarp_fractal</summary>
    public enum Fractal
    {
        Fbm = 0,
        Turbulence = 1,
        Ridged = 2,
        Erosion = 3,
        Pingpong = 4,
        Hybrid = 5,
        Swiss = 6,
        Jordan = 7,
    }

    /// <summary>enum scarp_recipe_kind</summary>
    public enum RecipeKind
    {
        Bad = 0,
        Number = 1,
        Field = 2,
        Noise = 3,
        Word = 4,
        Knot = 5,
    }

    /// <summary>enum scarp_language</summary>
    public enum Language
    {
        Glsl = 0,
        Hlsl = 1,
        Wgsl = 2,
    }

    /// <summary>enum scarp_isa</summary>
    public enum Isa
    {
        None = 0,
        Scalar = 1,
        Sse41 = 2,
        Avx2 = 3,
        Avx512 = 4,
        Neon = 5,
        Generic = 6,
        Wasm128 = 7,
    }

    /// <summary>The calls and structures of scarp.h, as it has them: for jobs, Burst, and
    /// what no class wraps. include/scarp.h has their contracts.</summary>
    public static unsafe partial class Native
    {
        public const int VersionMajor = 0, VersionMinor = 2, VersionPatch = 0;
        public const int SCARP_CURVE_KNOTS = 64;
        public const int SCARP_RECIPE_PARTS = 65536;
        public const int SCARP_RECIPE_OUTPUT = -1;
        public const int SCARP_GPU_ANSWERS = 4096;

        [StructLayout(LayoutKind.Sequential, Size = 192)]
        public unsafe struct scarp_noise
        {
            public Basis basis;
            public Fade fade;
            public Fractal fractal;
            public uint rotate;
            public ulong seed;
            public double frequency;
            public float octaves;
            public float lacunarity;
            public float gain;
            public float amplitude;
            public float erosion;
            public float phase;
            public float jitter;
            public float sharpness;
            public fixed uint period[3];
            public float of_octaves;
            public scarp_noise* warp;
            public scarp_plan* plan;
            public uint offset_first;
            public uint spare_word;
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_samples
        {
            public float* value;
            public float* dx;
            public float* dy;
            public float* dz;
            public float* dxx;
            public float* dxy;
            public float* dxz;
            public float* dyy;
            public float* dyz;
            public float* dzz;
            public float* dphase;
            public float* spare0, spare1, spare2, spare3, spare4;
        }

        [StructLayout(LayoutKind.Sequential, Size = 192)]
        public unsafe struct scarp_grid
        {
            public fixed double origin[3];
            public fixed double step[3];
            public fixed long first[3];
            public UIntPtr count0, count1, count2;
            public UIntPtr row_stride;
            public UIntPtr slice_stride;
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_plan
        {
            public ulong first;
            public fixed byte rest[12280];
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_flow
        {
            public float* vx;
            public float* vy;
            public float* vz;
            public float* vxx;
            public float* vxy;
            public float* vxz;
            public float* vyx;
            public float* vyy;
            public float* vyz;
            public float* vzx;
            public float* vzy;
            public float* vzz;
            public float* spare0, spare1, spare2, spare3;
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_cells
        {
            public float* f1;
            public float* f2;
            public uint* id;
            public float* x;
            public float* y;
            public float* z;
            public float* dx1;
            public float* dy1;
            public float* dz1;
            public float* dx2;
            public float* dy2;
            public float* dz2;
            public float* spare0, spare1, spare2, spare3;
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_partials
        {
            public float* f;
            public float* fa;
            public float* fb;
            public float* faa;
            public float* fab;
            public float* fbb;
            public float* spare0, spare1;
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_gullies
        {
            public ulong seed;
            public double frequency;
            public float amplitude;
            public float octaves;
            public float of_octaves;
            public float lacunarity;
            public float gain;
            public float depth;
            public float cells;
            public float slope;
            public float slope_low;
            public float low;
            public float high;
            public float floor;
            public float stripes;
            public float branch;
            public float round;
            public float keep;
            public fixed uint period[2];
            public uint rotate;
            public uint offset_first;
            public fixed uint spare[8];
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_eroded
        {
            public float* value;
            public float* dx;
            public float* dy;
            public float* displacement;
            public float* displacement_dx;
            public float* displacement_dy;
            public float* spare0, spare1, spare2, spare3, spare4, spare5, spare6, spare7, spare8;
            public float* spare9;
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_recipe
        {
            public ulong first;
            public fixed byte rest[65528];
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_recipe_error
        {
            public UIntPtr from;
            public UIntPtr to;
            public int line;
            public int column;
            public byte* text;
            public byte* member;
            public double nearest;
            public fixed uint spare[6];
        }

        [StructLayout(LayoutKind.Sequential, Size = 64)]
        public unsafe struct scarp_scratch
        {
            public void* memory;
            public UIntPtr size;
            public void* plan;
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_recipe_outputs
        {
            public scarp_samples* @out;
            public int* which;
            public int count;
            public fixed uint spare[9];
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_box
        {
            public fixed double lowest[3];
            public fixed double highest[3];
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_recipe_entry
        {
            public fixed uint span[2];
            public fixed uint name[2];
            public int kind;
            public int is_param;
            public int output;
            public int part;
            public double value;
            public fixed double slider[2];
            public fixed float range[2];
            public uint axes;
            public uint order;
            public ulong hash;
            public fixed double cell[2];
            public uint jumps;
            public uint dimensions;
            public fixed uint spare[2];
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_recipe_part
        {
            public fixed uint span[2];
            public fixed uint name[2];
            public fixed uint argument[2];
            public int kind;
            public int function;
            public int entry;
            public int parent;
            public int operation;
            public uint axes;
            public uint order;
            public fixed float range[2];
            public double value;
            public ulong hash;
            public fixed uint spare[8];
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_recipe_argument
        {
            public byte* name;
            public byte* text;
            public int kind;
            public int is_needed;
            public double otherwise;
            public double lowest;
            public double highest;
            public byte** words;
            public fixed uint spare[4];
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_recipe_function
        {
            public byte* name;
            public byte* text;
            public scarp_recipe_argument* argument;
            public int arguments;
            public fixed uint spare[5];
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_gpu_octave
        {
            public fixed uint key[3];
            public float frequency;
            public float weight;
            public float amplitude;
            public float slope;
            public float curvature;
            public fixed uint last[3];
            public float share;
            public fixed float turn[4];
            public fixed float jacobian[12];
            public fixed float gradient[12];
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_gpu_level
        {
            public uint basis;
            public uint fade;
            public uint fractal;
            public uint octaves;
            public uint rotate;
            public uint flows;
            public uint first;
            public uint spare0;
            public float erosion;
            public float sharpness;
            public float inverse_weight;
            public float spare1;
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_gpu_plan
        {
            public uint depth;
            public uint dimensions;
            public uint zero;
            public float unit;
            public scarp_gpu_level level0, level1, level2, level3, level4;
            public scarp_gpu_octave octave0, octave1, octave2, octave3, octave4, octave5, octave6;
            public scarp_gpu_octave octave7, octave8, octave9, octave10, octave11, octave12;
            public scarp_gpu_octave octave13, octave14, octave15, octave16, octave17, octave18;
            public scarp_gpu_octave octave19, octave20, octave21, octave22, octave23, octave24;
            public scarp_gpu_octave octave25, octave26, octave27, octave28, octave29, octave30;
            public scarp_gpu_octave octave31;
        }

        [StructLayout(LayoutKind.Sequential)]
        public unsafe struct scarp_shader
        {
            public int language;
            public int order;
            public byte* file;
            public UIntPtr length;
            public fixed uint spare[12];
        }

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_sample2(scarp_noise* noise, UIntPtr count, float* x,
            float* y, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_sample3(scarp_noise* noise, UIntPtr count, float* x,
            float* y, float* z, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_sample2_f64(scarp_noise* noise, UIntPtr count, double* x,
            double* y, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_sample3_f64(scarp_noise* noise, UIntPtr count, double* x,
            double* y, double* z, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_grid2(scarp_noise* noise, scarp_grid* grid,
            scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_grid3(scarp_noise* noise, scarp_grid* grid,
            scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_normals(UIntPtr count, float* dx, float* dy,
            float height_scale, float* nx, float* ny, float* nz);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_range(scarp_noise* noise, int dimensions, float* lowest,
            float* highest);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_noise_check(scarp_noise* noise, int dimensions,
            byte** member);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* scarp_noise_fault(scarp_noise* noise, int dimensions, int order,
            int dphase, byte** member);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* scarp_grid_fault(scarp_grid* grid, int dimensions,
            byte** member);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_plan_make(scarp_noise* noise, int dimensions,
            scarp_plan* plan);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_vector_plan_make(scarp_noise* noise, int dimensions,
            scarp_plan* plan);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_vector2(scarp_noise* noise, UIntPtr count, float* x,
            float* y, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_vector3(scarp_noise* noise, UIntPtr count, float* x,
            float* y, float* z, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_vector2_f64(scarp_noise* noise, UIntPtr count, double* x,
            double* y, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_vector3_f64(scarp_noise* noise, UIntPtr count, double* x,
            double* y, double* z, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_curl2(scarp_noise* noise, UIntPtr count, float* x,
            float* y, scarp_flow* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_curl3(scarp_noise* noise, UIntPtr count, float* x,
            float* y, float* z, scarp_flow* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_curl2_f64(scarp_noise* noise, UIntPtr count, double* x,
            double* y, scarp_flow* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_curl3_f64(scarp_noise* noise, UIntPtr count, double* x,
            double* y, double* z, scarp_flow* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_cells2(scarp_noise* noise, UIntPtr count, float* x,
            float* y, scarp_cells* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_cells3(scarp_noise* noise, UIntPtr count, float* x,
            float* y, float* z, scarp_cells* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_cells2_f64(scarp_noise* noise, UIntPtr count, double* x,
            double* y, scarp_cells* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_cells3_f64(scarp_noise* noise, UIntPtr count, double* x,
            double* y, double* z, scarp_cells* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_affine(UIntPtr count, scarp_samples* a, float scale,
            float offset, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_add(UIntPtr count, scarp_samples* a, scarp_samples* b,
            scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_multiply(UIntPtr count, scarp_samples* a,
            scarp_samples* b, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_mix(UIntPtr count, scarp_samples* a, scarp_samples* b,
            scarp_samples* m, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_min(UIntPtr count, scarp_samples* a, scarp_samples* b,
            scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_max(UIntPtr count, scarp_samples* a, scarp_samples* b,
            scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_smooth_min(UIntPtr count, scarp_samples* a,
            scarp_samples* b, float k, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_smooth_max(UIntPtr count, scarp_samples* a,
            scarp_samples* b, float k, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_clamp(UIntPtr count, scarp_samples* a, float lo, float hi,
            scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_abs(UIntPtr count, scarp_samples* a, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_smooth_abs(UIntPtr count, scarp_samples* a, float round,
            scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_smoothstep(UIntPtr count, scarp_samples* a, float lo,
            float hi, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_terrace(UIntPtr count, scarp_samples* a, float steps,
            float riser, float strength, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_divide(UIntPtr count, scarp_samples* a, scarp_samples* b,
            scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_sqrt(UIntPtr count, scarp_samples* a,
            scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_sine(UIntPtr count, scarp_samples* a,
            scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_pulse(UIntPtr count, scarp_samples* a,
            scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_curve(UIntPtr count, scarp_samples* a, UIntPtr knots,
            float* x, float* value, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_slope(UIntPtr count, scarp_samples* a,
            scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_apply1(UIntPtr count, scarp_samples* a,
            scarp_partials* function, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_apply2(UIntPtr count, scarp_samples* a, scarp_samples* b,
            scarp_partials* function, scarp_samples* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_gullies2(scarp_gullies* gullies, UIntPtr count, float* x,
            float* y, scarp_samples* @base, scarp_eroded* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_gullies2_f64(scarp_gullies* gullies, UIntPtr count,
            double* x, double* y, scarp_samples* @base, scarp_eroded* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_gullies_grid2(scarp_gullies* gullies, scarp_grid* grid,
            scarp_samples* @base, scarp_eroded* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_gullies_range(scarp_gullies* gullies, float base_lowest,
            float base_highest, float* lowest, float* highest);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_gullies_check(scarp_gullies* gullies, byte** member);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* scarp_gullies_fault(scarp_gullies* gullies, byte** member);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_parse(byte* text, UIntPtr length,
            scarp_recipe* recipe, scarp_recipe_error* errors, UIntPtr capacity, UIntPtr* found);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_seed(scarp_recipe* recipe, ulong seed);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_set(scarp_recipe* recipe, byte* name, double value,
            scarp_recipe_error* error);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_tile(scarp_recipe* recipe, double x, double y,
            double z, scarp_recipe_error* error);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_scale(scarp_recipe* recipe, double by,
            double heights, scarp_recipe_error* error);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_sample(scarp_recipe* recipe, UIntPtr count,
            float* x, float* y, float* z, scarp_recipe_outputs* outputs, scarp_scratch* scratch);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_sample_f64(scarp_recipe* recipe, UIntPtr count,
            double* x, double* y, double* z, scarp_recipe_outputs* outputs, scarp_scratch* scratch);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_grid(scarp_recipe* recipe, scarp_grid* grid,
            scarp_recipe_outputs* outputs, scarp_scratch* scratch);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern UIntPtr scarp_recipe_scratch_size(scarp_recipe* recipe, int order,
            UIntPtr points);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern UIntPtr scarp_recipe_plan_size(scarp_recipe* recipe);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_plan_make(scarp_recipe* recipe, void* memory,
            UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_range(scarp_recipe* recipe, int which,
            scarp_box* box, float* lowest, float* highest);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_entry_at(scarp_recipe* recipe, UIntPtr index,
            scarp_recipe_entry* entry);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_part_at(scarp_recipe* recipe, UIntPtr index,
            scarp_recipe_part* part);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_function_at(UIntPtr index,
            scarp_recipe_function* function);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_gpu_plan_make(scarp_noise* noise, int dimensions,
            scarp_gpu_plan* plan, byte** member);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_gpu_vector_plan_make(scarp_noise* noise, int dimensions,
            scarp_gpu_plan* plan, byte** member);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* scarp_gpu_plan_fault(scarp_noise* noise, int dimensions,
            int vector, byte** member);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_gpu_answers(scarp_noise* noise, int dimensions, int order,
            uint* answer);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_shader(scarp_recipe* recipe, scarp_shader* how,
            byte* text, UIntPtr capacity, UIntPtr* length);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_uniforms(scarp_recipe* recipe, void* bytes,
            UIntPtr capacity, UIntPtr* size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_recipe_answers(scarp_recipe* recipe, int order,
            uint* answer);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* scarp_basis_name(Basis basis);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* scarp_fade_name(Fade fade);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* scarp_fractal_name(Fractal fractal);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* scarp_status_text(Status status);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* scarp_version();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Isa scarp_isa_active();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int scarp_isa_supported(Isa isa);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern Status scarp_isa_select(Isa isa);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* scarp_isa_name(Isa isa);
    }
    // </tables>
}

// What the classes above share. It is in a namespace of its own, since its names are common ones.
namespace Scarp.Internal
{
    static unsafe class Arguments
    {
        // 1 if an array is given, 0 if it is not. Throws if it is too short.
        public static int Room<T>(Span<T> array, long needed, string name, string member)
        {
            if (array == default(Span<T>)) {
                return 0;
            }
            if (array.Length < needed) {
                throw new ArgumentException("has " + array.Length + " elements, and " + needed
                                            + " are needed",
                                            name == null ? member : name + "." + member);
            }
            return 1;
        }

        // All coordinates have as many elements as x.
        public static void Same(int x, int other, string name)
        {
            if (other != x) {
                throw new ArgumentException("has " + other + " elements, and x has " + x, name);
            }
        }

        // Throws if no array is given, or one for which the plane has nothing.
        public static void Given(int given, int needed, string alongZ)
        {
            if (given == 0 && needed > 0) {
                throw new ArgumentException("has no array", "to");
            }
            if (alongZ != null) {
                throw new ArgumentException("there is nothing along z in the plane", alongZ);
            }
        }

        public static void Dimensions(int dimensions)
        {
            if (dimensions != 2 && dimensions != 3) {
                throw new ArgumentOutOfRangeException("dimensions", "is neither 2 nor 3");
            }
        }

        // Throws if arrays overlap of which one is written: an output with another one, or with a
        // coordinate or an array of samples that are read. Where `inPlace`, an output may be the
        // very same array as an input.
        public static void Overlap(byte** read, int reads, long readBytes, byte** written,
                                   int writes,
                                   long bytes, bool inPlace, string[] names)
        {
            for (int i = 0; i < writes; i++) {
                byte* a = written[i];
                if (a == null) {
                    continue;
                }
                for (int j = 0; j < i; j++) {
                    byte* b = written[j];
                    if (b != null && a < b + bytes && b < a + bytes) {
                        throw new ArgumentException("overlaps with " + names[j % 16],
                                                    names[i % 16]);
                    }
                }
                for (int j = 0; j < reads; j++) {
                    byte* b = read[j];
                    if (b != null && a < b + readBytes && b < a + bytes && !(inPlace && a == b)) {
                        throw new ArgumentException("overlaps with an input", names[i % 16]);
                    }
                }
            }
        }
    }

    static unsafe class Text
    {
        // A text of C, or null.
        public static string Of(byte* text)
        {
            if (text == null) {
                return null;
            }
            int length = 0;
            while (text[length] != 0) {
                length++;
            }
            return Encoding.UTF8.GetString(text, length);
        }

        // A member in the spelling of this file: "warp.of_octaves" as "Warp.OfOctaves".
        public static string Member(byte* name)
        {
            string text = Of(name);
            if (text == null) {
                return null;
            }
            var made = new StringBuilder();
            bool starts = true;
            foreach (char letter in text.Replace("[0]", "_x").Replace("[1]", "_y").Replace("[2]",
                "_z")) {
                if (letter == '_') {
                    starts = true;
                } else {
                    made.Append(starts ? char.ToUpperInvariant(letter) : letter);
                    starts = letter == '.';
                }
            }
            return made.ToString();
        }
    }

    // Memory that stays where it is, at multiples of 8 bytes. It is freed when nobody has it any
    // more.
    sealed unsafe class Block : SafeHandle
    {
        readonly int size;

        public Block(int size) : base(IntPtr.Zero, true)
        {
            SetHandle(Marshal.AllocHGlobal(size));
            this.size = size;
            GC.AddMemoryPressure(size);
            new Span<byte>((void*)handle, size).Clear();
        }

        public Block(Block other) : this(other.size)
        {
            new Span<byte>(other.Pointer, size).CopyTo(new Span<byte>(Pointer, size));
            GC.KeepAlive(other);
        }

        public void* Pointer { get { return (void*)handle; } }

        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }

        protected override bool ReleaseHandle()
        {
            Marshal.FreeHGlobal(handle);
            GC.RemoveMemoryPressure(size);
            return true;
        }
    }

    enum Op
    {
        Sample2, Sample3, Sample2F64, Sample3F64, Vector2, Vector3, Vector2F64, Vector3F64, Grid2,
            Grid3,
        Recipe, RecipeF64, RecipeGrid,
        Curve, Chain
    }

    // A call, but for the arrays of samples: these are pinned one after another by Pin.
    unsafe struct Request
    {
        public Op op;
        public UIntPtr count;
        public void* x, y, z;
        public bool isFloat; // coordinates, with which outputs may be in place
        public long length; // elements of arrays of samples
        public int row; // elements of a row with a gap behind it, where others may lie; else 0
        public int dimensions;
        public int reads; // how many of the samples are inputs
        public Native.scarp_noise* noise;
        public Native.scarp_grid* grid;
        public Native.scarp_recipe* recipe;
        public Native.scarp_recipe_outputs* outputs;
        public Native.scarp_scratch* scratch;
        public Samples.Function function;
        public float* numbers;
        public UIntPtr knots;

        // Points
        public Request(Op op, int count, void* x, void* y, void* z) : this()
        {
            this.op = op;
            this.count = (UIntPtr)(uint)count;
            this.x = x;
            this.y = y;
            this.z = z;
            length = count;
            isFloat = op == Op.Sample2 || op == Op.Sample3 || op == Op.Vector2 || op == Op.Vector3
                || op == Op.Recipe;
            dimensions = op == Op.Sample3 || op == Op.Sample3F64 || op == Op.Vector3
                || op == Op.Vector3F64 ? 3 : 2;
        }

        // <pins> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
        // Pins the first of the samples, then the others, then calls.
        public static Status Pin(Request* r, Native.scarp_samples* into, int filled, int all,
                                 in Samples first, in Samples second, in Samples third,
                                 in Samples fourth)
        {
            if (filled + 1 == all) {
                return Pin(r, into, all, first);
            }
            fixed (float*
                value = &MemoryMarshal.GetReference(first.Value),
                dx = &MemoryMarshal.GetReference(first.Dx),
                dy = &MemoryMarshal.GetReference(first.Dy),
                dz = &MemoryMarshal.GetReference(first.Dz),
                dxx = &MemoryMarshal.GetReference(first.Dxx),
                dxy = &MemoryMarshal.GetReference(first.Dxy),
                dxz = &MemoryMarshal.GetReference(first.Dxz),
                dyy = &MemoryMarshal.GetReference(first.Dyy),
                dyz = &MemoryMarshal.GetReference(first.Dyz),
                dzz = &MemoryMarshal.GetReference(first.Dzz),
                dphase = &MemoryMarshal.GetReference(first.Dphase)) {
                long n = r->length;
                if (first.Value.Length < n && value != null
                    || first.Dx.Length < n && dx != null
                    || first.Dy.Length < n && dy != null
                    || first.Dz.Length < n && dz != null
                    || first.Dxx.Length < n && dxx != null
                    || first.Dxy.Length < n && dxy != null
                    || first.Dxz.Length < n && dxz != null
                    || first.Dyy.Length < n && dyy != null
                    || first.Dyz.Length < n && dyz != null
                    || first.Dzz.Length < n && dzz != null
                    || first.Dphase.Length < n && dphase != null) {
                    Samples.Check(first, n, r->NameOf(filled));
                }
                into[filled].value = value;
                into[filled].dx = dx;
                into[filled].dy = dy;
                into[filled].dz = dz;
                into[filled].dxx = dxx;
                into[filled].dxy = dxy;
                into[filled].dxz = dxz;
                into[filled].dyy = dyy;
                into[filled].dyz = dyz;
                into[filled].dzz = dzz;
                into[filled].dphase = dphase;
                return Pin(r, into, filled + 1, all, second, third, fourth, default(Samples));
            }
        }

        // The last one, which most calls have alone
        public static Status Pin(Request* r, Native.scarp_samples* into, int all, in Samples last)
        {
            fixed (float*
                value = &MemoryMarshal.GetReference(last.Value),
                dx = &MemoryMarshal.GetReference(last.Dx),
                dy = &MemoryMarshal.GetReference(last.Dy),
                dz = &MemoryMarshal.GetReference(last.Dz),
                dxx = &MemoryMarshal.GetReference(last.Dxx),
                dxy = &MemoryMarshal.GetReference(last.Dxy),
                dxz = &MemoryMarshal.GetReference(last.Dxz),
                dyy = &MemoryMarshal.GetReference(last.Dyy),
                dyz = &MemoryMarshal.GetReference(last.Dyz),
                dzz = &MemoryMarshal.GetReference(last.Dzz),
                dphase = &MemoryMarshal.GetReference(last.Dphase)) {
                long n = r->length;
                if (last.Value.Length < n && value != null
                    || last.Dx.Length < n && dx != null
                    || last.Dy.Length < n && dy != null
                    || last.Dz.Length < n && dz != null
                    || last.Dxx.Length < n && dxx != null
                    || last.Dxy.Length < n && dxy != null
                    || last.Dxz.Length < n && dxz != null
                    || last.Dyy.Length < n && dyy != null
                    || last.Dyz.Length < n && dyz != null
                    || last.Dzz.Length < n && dzz != null
                    || last.Dphase.Length < n && dphase != null) {
                    Samples.Check(last, n, r->NameOf(all - 1));
                }
                into[all - 1].value = value;
                into[all - 1].dx = dx;
                into[all - 1].dy = dy;
                into[all - 1].dz = dz;
                into[all - 1].dxx = dxx;
                into[all - 1].dxy = dxy;
                into[all - 1].dxz = dxz;
                into[all - 1].dyy = dyy;
                into[all - 1].dyz = dyz;
                into[all - 1].dzz = dzz;
                into[all - 1].dphase = dphase;
                return r->Run(into, all);
            }
        }
        // </pins>

        // The name of an argument
        string NameOf(int index)
        {
            if (index < reads) {
                return index == 0 ? "a" : index == 1 ? "b" : "m";
            }
            if (op >= Op.Vector2 && op <= Op.Vector3F64) {
                return index == 0 ? "first" : index == 1 ? "second" : "third";
            }
            return op >= Op.Recipe && op <= Op.RecipeGrid && index == 1 ? "second" : "to";
        }

        // Each of the samples has an array, but along z only in space.
        void CheckMembers(Native.scarp_samples* s, int all)
        {
            for (int i = 0; i < all && length > 0; i++) {
                bool isSpace = s[i].dz != null || s[i].dxz != null || s[i].dyz != null
                    || s[i].dzz != null;
                if (isSpace && dimensions == 2) {
                    throw new ArgumentException("there are no derivatives along z in the plane",
                                                NameOf(i) + (s[i].dz != null ? ".Dz"
                                                : s[i].dxz != null ? ".Dxz"
                                                : s[i].dyz != null ? ".Dyz" : ".Dzz"));
                }
                if (!isSpace && s[i].value == null && s[i].dx == null && s[i].dy == null
                    && s[i].dxx == null && s[i].dxy == null && s[i].dyy == null
                    && s[i].dphase == null) {
                    throw new ArgumentException("has no array", NameOf(i));
                }
            }
        }

        Status Run(Native.scarp_samples* s, int all)
        {
            CheckMembers(s, all);
            byte** coordinates = stackalloc byte*[3];
            coordinates[0] = (byte*)x;
            coordinates[1] = (byte*)y;
            coordinates[2] = (byte*)z;
            byte** written = (byte**)(s + reads);
            // With gaps, first rows are compared alone.
            long bytes = 4 * (row > 0 && length > 0 ? row : length);
            if (reads > 0) {
                Arguments.Overlap((byte**)s, 16 * reads, bytes, written, 16 * (all - reads), bytes,
                                  true, Samples.Names);
                Arguments.Overlap(coordinates, 2, 4 * (long)(ulong)knots, written,
                                  16 * (all - reads), bytes, false, Samples.Names);
            } else {
                Arguments.Overlap(coordinates, 3, isFloat ? bytes : 2 * bytes, written, 16 * all,
                                  bytes,
                                  isFloat && op < Op.Grid2, Samples.Names);
            }
            if (op <= Op.Grid3) {
                return RunNoise(s);
            }
            if (op <= Op.RecipeGrid) {
                return RunRecipe(s);
            }
            return op == Op.Curve
                ? Native.scarp_curve(count, s, knots, (float*)x, (float*)y, s + 1)
                : Samples.Call(function, count, s, numbers);
        }

        Status RunNoise(Native.scarp_samples* s)
        {
            switch (op) {
            case Op.Sample2: return Native.scarp_sample2(noise, count, (float*)x, (float*)y, s);
            case Op.Sample3:
                return Native.scarp_sample3(noise, count, (float*)x, (float*)y, (float*)z, s);
            case Op.Sample2F64: return Native.scarp_sample2_f64(noise, count, (double*)x,
                (double*)y, s);
            case Op.Sample3F64:
                return Native.scarp_sample3_f64(noise, count, (double*)x, (double*)y, (double*)z,
                                                s);
            case Op.Vector2: return Native.scarp_vector2(noise, count, (float*)x, (float*)y, s);
            case Op.Vector3:
                return Native.scarp_vector3(noise, count, (float*)x, (float*)y, (float*)z, s);
            case Op.Vector2F64: return Native.scarp_vector2_f64(noise, count, (double*)x,
                (double*)y, s);
            case Op.Vector3F64:
                return Native.scarp_vector3_f64(noise, count, (double*)x, (double*)y, (double*)z,
                                                s);
            case Op.Grid2: return Native.scarp_grid2(noise, grid, s);
            default: return Native.scarp_grid3(noise, grid, s);
            }
        }

        Status RunRecipe(Native.scarp_samples* s)
        {
            outputs->@out = s;
            switch (op) {
            case Op.Recipe:
                return Native.scarp_recipe_sample(recipe, count, (float*)x, (float*)y, (float*)z,
                                                  outputs, scratch);
            case Op.RecipeF64:
                return Native.scarp_recipe_sample_f64(recipe, count, (double*)x, (double*)y,
                                                      (double*)z, outputs, scratch);
            default: return Native.scarp_recipe_grid(recipe, grid, outputs, scratch);
            }
        }
    }
}
