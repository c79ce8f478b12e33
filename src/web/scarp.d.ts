// SPDX-License-Identifier: MIT

// Types of scarp for JavaScript. scarp.h has the contracts, and at its end the formulas.

// <words> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
/** Perlin's gradient noise, value noise, simplex noise, and five kinds of cellular noise. */
export type Basis =
    | 'gradient'
    | 'value'
    | 'simplex'
    | 'cell-f1'
    | 'cell-f2'
    | 'cell-edge'
    | 'cell-soft'
    | 'cell-value';
/** The blend between lattice points of gradient and value noise. */
export type Fade = 'quintic' | 'cubic';
/** How octaves are summed. */
export type Fractal =
    'fbm' | 'turbulence' | 'ridged' | 'erosion' | 'pingpong' | 'hybrid' | 'swiss' | 'jordan';
// </words>
/** 2: the plane; 3: space. */
export type Dimensions = 2 | 3;

/** What to sample. A member that is left out, or a number that is 0, stands for its default. */
export interface Noise {
    /** The noise of one octave; 'gradient' by default. */
    basis?: Basis | number;
    /** 'quintic' by default. */
    fade?: Fade | number;
    /** 'fbm' by default. */
    fractal?: Fractal | number;
    /** Turns the axes between octaves, which hides the directions of the lattice. */
    rotate?: boolean;
    /** All 64 bits count; a negative seed is 2^64 more. Beyond 2^53 - 1 it must be a BigInt. */
    seed?: number | bigint;
    /** Lattice cells per unit of input; 1 by default. */
    frequency?: number;
    /** In (0, 32]; 1 by default. A fraction fades the last octave in. */
    octaves?: number;
    /** Frequency ratio between octaves, in [1/16, 16]; 2 by default. */
    lacunarity?: number;
    /** Amplitude ratio between octaves, in [1/16, 16]; 0.5 by default. */
    gain?: number;
    /** Scales every output; its magnitude in [2^-24, 2^24]; 1 by default. */
    amplitude?: number;
    /**
     * Of 'erosion': how strongly slopes damp octaves, in [2^-24, 2^24]; 1 by default. scarp.h says
     * what it is for other fractals.
     */
    erosion?: number;
    /** How far gradients turn, in turns, so that noise flows; only for the basis 'gradient'. */
    phase?: number;
    /** Cellular noise: how far features stray from middles of cells, in (0, 1]; 1 by default. */
    jitter?: number;
    /**
     * In [2^-8, 2^8], for some fractals. scarp.h says what it is for each, and its default.
     */
    sharpness?: number;
    /** Cells of the first octave after which the noise repeats along x, y and z; 0: never. */
    period?: readonly number[];
    /** A level of detail: amplitudes are those of a sum of this many octaves. */
    ofOctaves?: number;
    /** A noise that displaces positions. It may have a warp, too; four in all. */
    warp?: Noise | null;
    /**
     * Whether the first octave, too, has an offset that the seed draws. Without one every seed has a
     * lattice point at the origin.
     */
    offsetFirst?: boolean;
}

/** A noise that is checked and whose constants are computed, for many calls with few points. */
export interface Plan {
    readonly dimensions: Dimensions;
}

/** A uniform grid: sample (i, j, k) lies at origin + (first + index) * step along each axis. */
export interface Grid {
    count: readonly number[];
    /** 0 by default. */
    origin?: readonly number[];
    /** 1 by default. */
    step?: readonly number[];
    /** 0 by default. */
    first?: readonly (number | bigint)[];
    /** Elements from one row to the next; by default rows follow each other. */
    rowStride?: number;
    /** Elements from one slice to the next; by default slices follow each other. */
    sliceStride?: number;
}

// <arrays> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
/** Arrays of values and of their derivatives. Members that are left out are not computed. */
export interface Samples {
    /** The value. */
    value?: Float32Array | null;
    /** The gradient along x, per unit of input. */
    dx?: Float32Array | null;
    /** The gradient along y, per unit of input. */
    dy?: Float32Array | null;
    /** The gradient along z, per unit of input, in space. */
    dz?: Float32Array | null;
    /** The second derivative with respect to x, per unit of input squared. */
    dxx?: Float32Array | null;
    /** The derivative with respect to x and y, per unit of input squared. */
    dxy?: Float32Array | null;
    /** The derivative with respect to x and z, per unit of input squared, in space. */
    dxz?: Float32Array | null;
    /** The second derivative with respect to y, per unit of input squared. */
    dyy?: Float32Array | null;
    /** The derivative with respect to y and z, per unit of input squared, in space. */
    dyz?: Float32Array | null;
    /** The second derivative with respect to z, per unit of input squared, in space. */
    dzz?: Float32Array | null;
    /** The derivative with respect to the phase, per turn. */
    dphase?: Float32Array | null;
}

/** What is near a point: distances, the cell's number, the feature's position, gradients. */
export interface Cells {
    /** The distance to the nearest feature, in units of input. */
    f1?: Float32Array | null;
    /** The distance to the second nearest feature, in units of input. */
    f2?: Float32Array | null;
    /** A number drawn for the cell of the nearest feature. */
    id?: Uint32Array | null;
    /** Where the nearest feature is along x. */
    x?: Float32Array | null;
    /** Where the nearest feature is along y. */
    y?: Float32Array | null;
    /** Where the nearest feature is along z, in space. */
    z?: Float32Array | null;
    /** The gradient of `f1` along x. */
    dx1?: Float32Array | null;
    /** The gradient of `f1` along y. */
    dy1?: Float32Array | null;
    /** The gradient of `f1` along z, in space. */
    dz1?: Float32Array | null;
    /** The gradient of `f2` along x. */
    dx2?: Float32Array | null;
    /** The gradient of `f2` along y. */
    dy2?: Float32Array | null;
    /** The gradient of `f2` along z, in space. */
    dz2?: Float32Array | null;
}

/** A velocity and its Jacobian: `vxy` is the derivative of `vx` with respect to y. */
export interface Flow {
    /** The velocity along x. */
    vx?: Float32Array | null;
    /** The velocity along y. */
    vy?: Float32Array | null;
    /** The velocity along z, in space. */
    vz?: Float32Array | null;
    /** The derivative of `vx` with respect to x. */
    vxx?: Float32Array | null;
    /** The derivative of `vx` with respect to y. */
    vxy?: Float32Array | null;
    /** The derivative of `vx` with respect to z, in space. */
    vxz?: Float32Array | null;
    /** The derivative of `vy` with respect to x. */
    vyx?: Float32Array | null;
    /** The derivative of `vy` with respect to y. */
    vyy?: Float32Array | null;
    /** The derivative of `vy` with respect to z, in space. */
    vyz?: Float32Array | null;
    /** The derivative of `vz` with respect to x, in space. */
    vzx?: Float32Array | null;
    /** The derivative of `vz` with respect to y, in space. */
    vzy?: Float32Array | null;
    /** The derivative of `vz` with respect to z, in space. */
    vzz?: Float32Array | null;
}

/** A function of a, or of a and b, at each point, with its partial derivatives. */
export interface Partials {
    /** The value. */
    f?: Float32Array | null;
    /** The derivative with respect to a. */
    fa?: Float32Array | null;
    /** The derivative with respect to b. */
    fb?: Float32Array | null;
    /** The second derivative with respect to a. */
    faa?: Float32Array | null;
    /** The derivative with respect to a and b. */
    fab?: Float32Array | null;
    /** The second derivative with respect to b. */
    fbb?: Float32Array | null;
}
// </arrays>

/** Components of unit normals. */
export interface Normals {
    nx?: Float32Array | null;
    ny?: Float32Array | null;
    nz?: Float32Array | null;
}

export declare const STATUS: Readonly<{
    OK: 0;
    NULL: 1;
    ENUM: 2;
    PARAMETER: 3;
    SIZE: 4;
    UNSUPPORTED: 5;
}>;

/** A request that the library refuses. The call wrote nothing. */
export declare class ScarpError extends Error {
    constructor(status: number, text: string, member?: string | null);
    /** As in STATUS. */
    readonly status: number;
    /** As the C header spells it: 'SCARP_ERROR_PARAMETER'. */
    readonly code: string;
    /** The member at fault, such as 'octaves' or 'warp.period[1]'; null if no member is. */
    readonly member: string | null;
    /** Why, without the member: 'turned axes cannot repeat'. */
    readonly text: string;
}

/** Coordinates: all Float32Array, or all Float64Array, which keep detail far from the origin. */
export type Coordinates = Float32Array | Float64Array;

export interface Scarp {
    /** Of the library: 'major.minor.patch'. */
    readonly version: string;
    readonly bases: readonly Basis[];
    readonly fades: readonly Fade[];
    readonly fractals: readonly Fractal[];
    /** The kernel set in use: 'wasm128', or 'generic' where engines have no vectors. */
    readonly isa: string;
    readonly isas: readonly string[];
    /** Uses a kernel set from now on; null: the best one. */
    selectIsa(name: string | null): void;

    /** An array in the memory of the module, filled with 0: calls use it without a copy. */
    alloc(type: Float32ArrayConstructor, length: number): Float32Array;
    alloc(type: Float64ArrayConstructor, length: number): Float64Array;
    alloc(type: Uint32ArrayConstructor, length: number): Uint32Array;
    /** Gives the memory of such an array back. Do not use the array after that. */
    free(array: Coordinates | Uint32Array): void;

    /** Noise at points: the arrays of `out` get the values and derivatives. Returns `out`. */
    sample2<T extends Samples>(noise: Noise | Plan, x: Coordinates, y: Coordinates, out: T): T;
    sample3<T extends Samples>(
        noise: Noise | Plan,
        x: Coordinates,
        y: Coordinates,
        z: Coordinates,
        out: T,
    ): T;
    /** The components of vector noise: what a warp displaces points by. */
    vector2<T extends [Samples, Samples]>(
        noise: Noise | Plan,
        x: Coordinates,
        y: Coordinates,
        out: T,
    ): T;
    vector3<T extends [Samples, Samples, Samples]>(
        noise: Noise | Plan,
        x: Coordinates,
        y: Coordinates,
        z: Coordinates,
        out: T,
    ): T;
    /** Noise on a grid: element j * rowStride + i is sample (i, j). */
    grid2<T extends Samples>(noise: Noise | Plan, grid: Grid, out: T): T;
    grid3<T extends Samples>(noise: Noise | Plan, grid: Grid, out: T): T;
    /** The nearest features of cellular noise. */
    cells2<T extends Cells>(noise: Noise | Plan, x: Coordinates, y: Coordinates, out: T): T;
    cells3<T extends Cells>(
        noise: Noise | Plan,
        x: Coordinates,
        y: Coordinates,
        z: Coordinates,
        out: T,
    ): T;
    /** A velocity without divergence: the curl of the noise. */
    curl2<T extends Flow>(noise: Noise | Plan, x: Coordinates, y: Coordinates, out: T): T;
    curl3<T extends Flow>(
        noise: Noise | Plan,
        x: Coordinates,
        y: Coordinates,
        z: Coordinates,
        out: T,
    ): T;
    /** Unit normals of the surface z = heightScale * value. */
    normals<T extends Normals>(dx: Float32Array, dy: Float32Array, heightScale: number, out: T): T;

    // The chain rule: each function computes the values and derivatives that `out` has arrays for.

    // <chain> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
    /** `scale * a + offset`. */
    affine<T extends Samples>(a: Samples, scale: number, offset: number, out: T): T;
    /** `a + b`, in all members. */
    add<T extends Samples>(a: Samples, b: Samples, out: T): T;
    /** `a * b`: a product is 0 where a factor is 0, even if the other one is NaN. */
    multiply<T extends Samples>(a: Samples, b: Samples, out: T): T;
    /**
     * `a` where `m` is 0, `b` where `m` is 1, and `a + m * (b - a)` between: slopes of `m` count,
     * too.
     */
    mix<T extends Samples>(a: Samples, b: Samples, m: Samples, out: T): T;
    /** The lesser of `a` and `b`, with a crease where both are equal; NaN before any number. */
    min<T extends Samples>(a: Samples, b: Samples, out: T): T;
    /** The greater of `a` and `b`, with a crease where both are equal; NaN before any number. */
    max<T extends Samples>(a: Samples, b: Samples, out: T): T;
    /**
     * The lesser of `a` and `b`, without a crease: less by `k / 6` at most, where they differ by
     * less than `k`.
     */
    smoothMin<T extends Samples>(a: Samples, b: Samples, k: number, out: T): T;
    /**
     * The greater of `a` and `b`, without a crease: more by `k / 6` at most, where they differ by
     * less than `k`.
     */
    smoothMax<T extends Samples>(a: Samples, b: Samples, k: number, out: T): T;
    /** `a`, but `lo` where it is less and `hi` where it is more, with creases there. */
    clamp<T extends Samples>(a: Samples, lo: number, hi: number, out: T): T;
    /** `|a|`, with a crease at 0. */
    abs<T extends Samples>(a: Samples, out: T): T;
    /** `sqrt(a^2 + round^2)`: the magnitude of `a`, with a round floor. */
    smoothAbs<T extends Samples>(a: Samples, round: number, out: T): T;
    /** From 0 where `a` is `lo` or beyond, to 1 where it is `hi` or beyond: masks for mixes. */
    smoothstep<T extends Samples>(a: Samples, lo: number, hi: number, out: T): T;
    /**
     * Steps in a slope: `steps` per unit of value, of which the part `riser`, in [2^-20, 1], rises.
     * `strength`, in [0, 1], says how level treads are.
     */
    terrace<T extends Samples>(
        a: Samples,
        steps: number,
        riser: number,
        strength: number,
        out: T,
    ): T;
    /** `a / b`: infinite or NaN where `b` is 0. */
    divide<T extends Samples>(a: Samples, b: Samples, out: T): T;
    /** The square root of `a`, and 0 where `a` is less than 0. */
    sqrt<T extends Samples>(a: Samples, out: T): T;
    /** `sin(2 pi a)`: `a` counts turns. */
    sine<T extends Samples>(a: Samples, out: T): T;
    /** `a` folded to and fro between -1 and 1, with the period 2. */
    pulse<T extends Samples>(a: Samples, out: T): T;
    /** The length of the gradient of `a`. It has first derivatives where `a` has second ones. */
    slope<T extends Samples>(a: Samples, out: T): T;
    // </chain>
    /** A smooth curve with values[k] where a is x[k], for 2 to 64 knots, level outside of them. */
    curve<T extends Samples>(
        a: Samples,
        x: ArrayLike<number>,
        values: ArrayLike<number>,
        out: T,
    ): T;
    /** Any other function of a: its value and its derivatives are given at each point. */
    apply1<T extends Samples>(a: Samples, f: Partials, out: T): T;
    /** Any other function of a and b. */
    apply2<T extends Samples>(a: Samples, b: Samples, f: Partials, out: T): T;

    /**
     * A composition of noises. A text with errors throws a RecipeError. A tolerant recipe has its
     * errors in `errors`, and throws only if the text is too long. Free it when you are done.
     */
    recipe(text: string, options?: { tolerant?: boolean }): Recipe;
    /** The functions of recipes. */
    readonly recipeFunctions: readonly RecipeFunction[];

    /** What calls would throw for this noise, or null. */
    noiseCheck(noise: Noise | Plan, dimensions: Dimensions): ScarpError | null;
    /** The interval that values never leave: [lowest, highest]. */
    range(noise: Noise | Plan, dimensions: Dimensions): [number, number];
    /** Computes the constants of a noise once, for many calls. Free the plan with freePlan(). */
    plan(noise: Noise, dimensions: Dimensions): Plan;
    freePlan(plan: Plan): void;
    /**
     * The constants for scarp.wgsl and its like: the bytes of a uniform buffer; with `vector`, for
     * vector noise and curl in space.
     */
    gpuPlan(
        noise: Noise | Plan,
        dimensions: Dimensions,
        options?: { vector?: boolean },
    ): Uint8Array;
    /** What a shader must answer: 4,096 numbers. */
    gpuAnswers(noise: Noise | Plan, dimensions: Dimensions, order: 0 | 1 | 2): Uint32Array;
}

/** The index of the first character of a string, and the one behind the last. */
export type Span = [from: number, to: number];

/** One thing that is wrong in the text of a recipe; lines and columns count from 1. */
export interface RecipeFault {
    line: number;
    column: number;
    /** Indices of the string, `to` excluded. */
    from: number;
    to: number;
    text: string;
    /** The member of a noise, or the argument, at fault. */
    member: string | null;
    /** A number that would do there. */
    nearest: number | null;
}

export declare class RecipeError extends ScarpError {
    readonly errors: RecipeFault[];
}

/** What a statement, or a part of one, is; 'bad': it has an error, or uses what has one. */
export type RecipeKind = 'bad' | 'number' | 'field' | 'noise' | 'word' | 'knot';

/** A statement: param, out or name = expression. */
export interface RecipeEntry {
    readonly index: number;
    readonly name: string;
    /** With the comment that ends its line. */
    readonly span: Span;
    readonly nameSpan: Span;
    readonly kind: RecipeKind;
    readonly isParam: boolean;
    /** Which output it is, counted from 0; -1: none. */
    readonly output: number;
    /** The number of its expression; -1 for param. */
    readonly part: number;
    /** Of numbers. */
    readonly value: number;
    /** Of param: the interval that the text gives, else that of all numbers. */
    readonly slider: [lowest: number, highest: number];
    /** Of fields: the interval that values never leave. */
    readonly range: [lowest: number, highest: number];
    /** Of fields: the axes that they depend on: 1 x, 2 y, 4 z, added. */
    readonly axes: number;
    /** Of fields: the highest order of their derivatives. */
    readonly order: number;
    /** The same as before an edit if nothing has to be drawn anew. */
    readonly hash: string;
    /** Of fields: the lengths of the largest and of the smallest cell, in units of x and y; 0
     * without a noise. */
    readonly cell: [largest: number, smallest: number];
    /** Of fields: whether values may jump. */
    readonly jumps: boolean;
    /** Of the recipe: 2, or 3 if it is of space. */
    readonly dimensions: number;
}

/**
 * A part of an expression. In the list, a call, and a sign, stands before the parts that it has.
 * Any other operator stands behind its parts.
 */
export interface RecipePart {
    readonly index: number;
    readonly span: Span;
    /** The name, or the function that is called; else ''. */
    readonly name: string;
    readonly nameSpan: Span | null;
    /** The name that it has as an argument; else ''. */
    readonly argument: string;
    readonly argumentSpan: Span | null;
    readonly kind: RecipeKind;
    /** Of a call: its number in recipeFunctions; else -1. */
    readonly function: number;
    /** Of a name: the statement that it stands for; else -1. */
    readonly entry: number;
    /** The part around it; -1: it is a whole expression. */
    readonly parent: number;
    readonly operation: '' | '+' | '-' | '*' | '/' | '^';
    readonly axes: number;
    readonly order: number;
    readonly range: [lowest: number, highest: number];
    readonly value: number;
    readonly hash: string;
}

export interface RecipeArgument {
    readonly name: string;
    /** What it does. */
    readonly text: string;
    /** What is expected; the last argument may be given again and again if that is 'knot'. */
    readonly kind: RecipeKind;
    readonly isNeeded: boolean;
    /** Of numbers: the value without the argument, and an interval for a slider. */
    readonly otherwise: number;
    readonly lowest: number;
    readonly highest: number;
    /** Of words: those that it may be; else null. */
    readonly words: readonly string[] | null;
}

export interface RecipeFunction {
    readonly name: string;
    /** A sentence. */
    readonly text: string;
    readonly arguments: readonly RecipeArgument[];
}

/** What to sample in place of the outputs: numbers of statements, or PARTS + numbers of parts. */
export interface Nodes {
    which?: number | readonly number[] | null;
}

/** What is added to the number of a part in `which`. */
export declare const PARTS: 65536;

/** A composition of noises as a text: src/recipe/README.md of scarp has the language. */
export interface Recipe {
    /** What is wrong with the text of a tolerant recipe. Statements without an error may be sampled. */
    readonly errors: readonly RecipeFault[];
    readonly entries: RecipeEntry[];
    readonly parts: RecipePart[];
    /** Parameters, with the intervals that the text gives. */
    readonly params: { name: string; value: number; lowest: number; highest: number }[];
    /** Outputs, with the intervals that values never leave. */
    readonly outputs: { name: string; range: [number, number] }[];
    /** Whether the recipe is of space. */
    readonly isSpace: boolean;
    /** The seed of the world, from 0 to 2^64 - 1: a negative one becomes 2^64 more. Give a BigInt
     * for more than 53 bits. */
    get seed(): bigint;
    set seed(seed: number | bigint);
    /** Sets a parameter; "finest" leaves out octaves with cells smaller than that. */
    set(name: string, value: number): this;
    /** Makes it repeat after so many units along each axis, in place of a tile in the text; with 0
     * for all it does not. */
    tile(x: number, y: number, z?: number): this;
    /** Makes it so many times larger, as scale(..., by) does with each statement, and multiplies
     * the first output by `heights`; both are 1 at first. */
    scale(by: number, heights?: number): this;
    /** The interval that values of an output, or of `which`, never leave; in a box if given. */
    range(
        output?: number,
        options?: {
            which?: number | null;
            box?: { lowest: readonly number[]; highest: readonly number[] } | null;
        },
    ): [number, number];
    /** `out` has arrays for the first output. An array of such objects is for the first outputs. */
    grid<T extends Samples | Samples[]>(grid: Grid, out: T, nodes?: Nodes): T;
    sample2<T extends Samples | Samples[]>(
        x: Coordinates,
        y: Coordinates,
        out: T,
        nodes?: Nodes,
    ): T;
    sample3<T extends Samples | Samples[]>(
        x: Coordinates,
        y: Coordinates,
        z: Coordinates,
        out: T,
        nodes?: Nodes,
    ): T;
    /**
     * The recipe as functions of a shading language, with what these use of `file`, the text of
     * scarp.wgsl or its like. Outputs have derivatives up to `order`, 1 by default.
     */
    shader(
        language: 'glsl' | 'hlsl' | 'wgsl',
        file: string,
        options?: { order?: 0 | 1 | 2 },
    ): string;
    /** The bytes of the shader's uniform buffer, which has the seed and the parameters. */
    uniforms(): Uint8Array;
    /** What the shader's self-test must answer, with derivatives up to `order`: 4,096 numbers. */
    answers(order?: 0 | 1 | 2): Uint32Array;
    /** Gives the memory back. */
    free(): void;
}

export interface Options {
    /** false: without vectors. By default the module uses them where the engine has them. */
    simd?: boolean;
    /** How many bytes alloc() may give; 64 MiB by default. They take memory when they are used. */
    memory?: number;
}

/** Loads the module. */
export declare function load(options?: Options): Promise<Scarp>;
