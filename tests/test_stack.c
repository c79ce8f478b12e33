/* SPDX-License-Identifier: MIT
 *
 * Measures how much stack the calls take: each of them runs on a thread whose stack of 64 KiB was
 * painted before, in front of a page that cannot be touched. POSIX threads only.
 *
 *     test_stack ISA          every call
 *     test_stack ISA EVERY    one of EVERY calls: for emulators, on which all take minutes
 */
#include "guarded.h"

#include "chain.h"
#include "gullies.h"
#include "recipes.h"

#include <pthread.h>

#define STACK_BYTES 65536L
#define PERMITTED ((size_t)STACK_KIB << 10) /* by the build: tests/api.cmake */
#define RECIPES ((size_t)2 << 10)           /* more, of recipes, */
#define SCRATCH ((size_t)8 << 10)           /* and more without scratch memory */
#define PAINT 0xa5

#define MOST_POINTS 1100
#define MOST_SAMPLES (700 * 5 * 2)

/* 64 KiB, but where the system demands more of a thread, as it does on AArch64. */
static size_t stack_bytes(void)
{
    const long least = sysconf(_SC_THREAD_STACK_MIN);
    return (size_t)(least > STACK_BYTES ? least : STACK_BYTES);
}

/* One call. */
struct job {
    struct scarp_noise noise;
    enum {
        NOTHING,
        POINTS,
        GRID,
        CHAIN,
        VECTOR,
        FLOW,
        GULLIES,
        GULLY_GRID,
        SHADER,
        RECIPE,
        OTHERS
    } kind;
    int order, dimensions;
    enum function function;
    enum chain chain;
    size_t count;
    struct scarp_grid grid;
    enum {
        PARSE,
        SET,
        PLAN,
        SAMPLE,
        SAMPLE_PART,
        GRID_OF_RECIPE,
        GRID_OF_EROSION,
        RANGE,
        DESCRIBE,
        SHADER_OF_RECIPE,
        UNIFORMS,
        ANSWERS
    } recipe_call;
    const char *text;
    const struct scarp_scratch *scratch;
    const struct inputs *in;
    float *x[3]; /* of a function of samples */
    const struct outputs *out;
    enum scarp_status status;
};

/* Velocities; of order 2, with the Jacobian. The arrays stand for any. */
static enum scarp_status flow_call(const struct job *job)
{
    float *const *const a = job->out->array;
    const struct inputs *const in = job->in;
    struct scarp_flow out = {.vx = a[0], .vy = a[1], .vz = job->dimensions == 3 ? a[2] : NULL};
    if (job->order == 2) {
        out.vxx = a[3];
        out.vyx = a[4];
        out.vzz = job->dimensions == 3 ? a[5] : NULL;
    }
    switch (job->function) {
    case SAMPLE2: return scarp_curl2(&job->noise, job->count, in->f[0], in->f[1], &out);
    case SAMPLE3: return scarp_curl3(&job->noise, job->count, in->f[0], in->f[1], in->f[2], &out);
    case SAMPLE2_F64: return scarp_curl2_f64(&job->noise, job->count, in->d[0], in->d[1], &out);
    default: return scarp_curl3_f64(&job->noise, job->count, in->d[0], in->d[1], in->d[2], &out);
    }
}

/* Gullies; of order 1, with derivatives. The arrays stand for any. */
static enum scarp_status gully_call(const struct job *job)
{
    static const struct scarp_gullies gullies = {.octaves = 3.0f, .rotate = 1};
    const struct inputs *const in = job->in;
    const struct scarp_samples base = base_of_two(job->x[0], job->x[1]);
    const struct scarp_eroded out =
        eroded_of(job->out->array, job->order > 0 ? OUT_ALL : OUT_VALUES);
    if (job->kind == GULLY_GRID) {
        return scarp_gullies_grid2(&gullies, &job->grid, &base, &out);
    }
    return job->function == SAMPLE2
               ? scarp_gullies2(&gullies, job->count, in->f[0], in->f[1], &base, &out)
               : scarp_gullies2_f64(&gullies, job->count, in->d[0], in->d[1], &base, &out);
}

static struct scarp_recipe recipe;
static uint64_t plan[1 << 17]; /* of the recipe */

/* As a shader, of what passes for a file: what is cut takes the same stack, however long it is. */
static enum scarp_status shader_call(const struct job *job)
{
    static const char file[] = "#define scarp_pick(a) a\n#define SCARP_LAYOUT a\n"
                               "uint scarp_zero()\n{\n}\n";
    static char text[1 << 18];
    static uint64_t uniforms[1 << 13];
    static uint32_t answers[SCARP_GPU_ANSWERS];
    const struct scarp_shader how = {.order = 2, .file = file, .length = sizeof file - 1};
    size_t size;
    switch (job->recipe_call) {
    case SHADER_OF_RECIPE: return scarp_recipe_shader(&recipe, &how, text, sizeof text, &size);
    case UNIFORMS: return scarp_recipe_uniforms(&recipe, uniforms, sizeof uniforms, &size);
    default: return scarp_recipe_answers(&recipe, 2, answers);
    }
}

/* A call of a recipe, which is parsed already but for PARSE. */
static enum scarp_status recipe_call(const struct job *job, const struct scarp_samples *out)
{
    const int32_t part[1] = {SCARP_RECIPE_PARTS};
    struct scarp_recipe_outputs outputs = {.out = out, .count = 1};
    struct scarp_recipe_error error;
    struct scarp_recipe_entry entry;
    const double *const *const x = (const double *const *)job->in->d;
    float lowest, highest;
    switch (job->recipe_call) {
    case SHADER_OF_RECIPE:
    case UNIFORMS:
    case ANSWERS: return shader_call(job);
    case PARSE: return scarp_recipe_parse(job->text, strlen(job->text), &recipe, &error, 1, NULL);
    case SET: return scarp_recipe_set(&recipe, "finest", 0.01, &error);
    case PLAN: return scarp_recipe_plan_make(&recipe, plan, sizeof plan);
    case RANGE: {
        static const struct scarp_box box = {.highest = {1.0, 1.0, 1.0}};
        return scarp_recipe_range(&recipe, SCARP_RECIPE_OUTPUT, &box, &lowest, &highest);
    }
    case DESCRIBE: return scarp_recipe_entry_at(&recipe, 0, &entry);
    case GRID_OF_RECIPE: return scarp_recipe_grid(&recipe, &job->grid, &outputs, job->scratch);
    case SAMPLE_PART: outputs.which = part; break;
    case GRID_OF_EROSION: {
        const int32_t statement[1] = {1};
        outputs.which = statement;
        return scarp_recipe_grid(&recipe, &job->grid, &outputs, job->scratch);
    }
    default: break;
    }
    return scarp_recipe_sample_f64(&recipe, job->count, x[0], x[1], x[2], &outputs, job->scratch);
}

static void *run(void *opaque)
{
    struct job *const job = opaque;
    const unsigned flow = job->noise.phase != 0.0f ? OUTPUTS_PHASE : 0;
    const unsigned mask = outputs_up_to(job->order, job->dimensions) |
                          (flow & outputs_of(&job->noise, job->function));
    const struct scarp_samples out = outputs_subset(job->out, mask);
    const char *member;
    float lowest, highest;
    switch (job->kind) {
    case POINTS:
        job->status = function_call(job->function, &job->noise, job->count, job->in, &out);
        break;
    case VECTOR: {
        const struct scarp_samples all[3] = {out, out, out}; /* the arrays stand for any */
        job->status = vector_call(job->function, &job->noise, job->count, job->in, all);
        break;
    }
    case GRID: job->status = grid_call(job->dimensions, &job->noise, &job->grid, &out); break;
    case CHAIN: {
        const struct scarp_samples all = outputs_subset(job->out, (1u << OUTPUTS) - 1);
        job->status = chain_call_arrays(job->chain, job->count, job->x, &all);
        break;
    }
    case FLOW: job->status = flow_call(job); break;
    case GULLIES:
    case GULLY_GRID: job->status = gully_call(job); break;
    case RECIPE: job->status = recipe_call(job, &out); break;
    case SHADER: {
        static uint32_t answer[SCARP_GPU_ANSWERS];
        job->status = scarp_gpu_answers(&job->noise, job->dimensions, job->order, answer);
        break;
    }
    case OTHERS:
        scarp_normals(job->count, job->in->f[0], job->in->f[1], 1.0f, out.value, out.dx, out.dy);
        scarp_range(&job->noise, 2, &lowest, &highest);
        job->status = scarp_noise_check(&job->noise, 2, &member);
        break;
    default: job->status = SCARP_OK;
    }
    return NULL;
}

static int every = 1; /* one of so many calls is made */

/* How many bytes of the stack a thread with that job touches. */
static size_t touched(const struct guarded *stack, struct job *job)
{
    pthread_t thread;
    pthread_attr_t attributes;
    memset(stack->start, PAINT, stack->size);
    if (pthread_attr_init(&attributes) != 0 ||
        pthread_attr_setstack(&attributes, stack->start, stack->size) != 0 ||
        pthread_create(&thread, &attributes, run, job) != 0) {
        printf("no thread with %zu bytes of stack\n", stack->size);
        exit(EXIT_FAILURE);
    }
    pthread_join(thread, NULL);
    pthread_attr_destroy(&attributes);
    size_t free_bytes = 0;
    while (free_bytes < stack->size && stack->start[free_bytes] == PAINT) {
        free_bytes++;
    }
    CHECK(job->status == SCARP_OK, "status %d", (int)job->status);
    return stack->size - free_bytes;
}

struct worst {
    size_t bytes, nothing; /* `nothing`: of a thread that makes no call */
    char what[100];
};

static void measure(const struct guarded *stack, struct job *job, struct worst *worst,
                    const char *what)
{
    static int calls;
    if (calls++ % every != 0) {
        return;
    }
    const size_t bytes = touched(stack, job) - worst->nothing;
    const int has_memory = job->scratch != NULL && job->scratch->memory != NULL;
    const size_t more = job->kind != RECIPE ? 0 : has_memory ? RECIPES : RECIPES + SCRATCH;
    CHECK(bytes < PERMITTED + more, "%s, %s %s, order %d, octaves %g, turned %d: %zu bytes", what,
          scarp_basis_name(job->noise.basis), scarp_fractal_name(job->noise.fractal), job->order,
          (double)job->noise.octaves, job->noise.rotate, bytes);
    if (bytes > worst->bytes) {
        worst->bytes = bytes;
        snprintf(worst->what, sizeof worst->what, "%s, %s %s, order %d", what,
                 scarp_basis_name(job->noise.basis), scarp_fractal_name(job->noise.fractal),
                 job->order);
    }
}

static void measure_points(const struct guarded *stack, struct job *job, struct worst *worst)
{
    static const size_t counts[] = {1, 7, 100, MOST_POINTS};
    const size_t lengths = scarp_isa_active() == SCARP_ISA_SCALAR ? 2 : 4; /* one by one */
    job->kind = POINTS;
    for (int f = 0; f < FUNCTIONS; f++) {
        job->function = (enum function)f;
        job->dimensions = function_dimensions(job->function);
        for (size_t i = 0; i < lengths; i++) {
            job->count = counts[i];
            measure(stack, job, worst, function_names[f]);
        }
    }
}

static void measure_grids(const struct guarded *stack, struct job *job, struct worst *worst)
{
    static const size_t sizes[][2] = {{3, 40}, {33, 5}, {700, 5}};
    static const double steps[] = {0.01, -0.3, 5.0};
    const size_t shapes = scarp_isa_active() == SCARP_ISA_SCALAR ? 6 : 18; /* row by row */
    job->kind = GRID;
    for (size_t i = 0; i < shapes; i++) {
        struct scarp_grid grid = {.count = {sizes[i / 6][0], sizes[i / 6][1], 2}};
        job->dimensions = 2 + (int)(i % 2);
        for (int axis = 0; axis < 3; axis++) {
            grid.origin[axis] = 0.5;
            grid.step[axis] = steps[i / 2 % 3];
        }
        job->grid = grid;
        measure(stack, job, worst, job->dimensions == 2 ? "scarp_grid2" : "scarp_grid3");
    }
}

/* The answers for shaders, which take room for points besides that of their samples. */
static void measure_shaders(const struct guarded *stack, struct job *job, struct worst *worst)
{
    static struct scarp_gpu_plan of_shader;
    job->kind = SHADER;
    for (job->dimensions = 2; job->dimensions <= 3; job->dimensions++) {
        if (scarp_gpu_plan_make(&job->noise, job->dimensions, &of_shader, NULL) == SCARP_OK) {
            measure(stack, job, worst, "scarp_gpu_answers");
        }
    }
}

/* Noise with warps takes the most with those that bend, and with those that flow. */
static void measure_warped(const struct guarded *stack, struct job *job, struct worst *worst)
{
    static const struct scarp_noise bends = {.fractal = SCARP_SWISS, .octaves = 3.0f, .rotate = 1};
    static const struct scarp_noise flows = {.octaves = 2.0f, .phase = 0.3f};
    static const struct scarp_noise twice = {.octaves = 16.0f, .lacunarity = 1.0f, .warp = &flows};
    static const struct scarp_noise *const warps[] = {&bends, &flows, &twice};
    for (int i = 0; i < 3 * count_names(fractal_name); i++) {
        job->noise = (struct scarp_noise){
            .fractal = (enum scarp_fractal)(i / 3),
            .basis = (enum scarp_basis)(i % 2 == 0 ? SCARP_GRADIENT : SCARP_CELL_F1),
            .octaves = 2.0f,
            .warp = warps[i % 3]};
        job->order = noise_order(&job->noise);
        measure_points(stack, job, worst);
        measure_grids(stack, job, worst);
        measure_shaders(stack, job, worst);
    }
}

/* Velocities of the job's noise, and of the same with a warp of its kind. */
static void measure_flows(const struct guarded *stack, struct job *job, struct worst *worst)
{
    const struct scarp_noise warp = job->noise;
    job->kind = FLOW;
    for (int i = 0; i < 2 * FUNCTIONS; i++) {
        job->function = (enum function)(i % FUNCTIONS);
        job->dimensions = function_dimensions(job->function);
        job->noise.warp = i < FUNCTIONS ? NULL : &warp;
        const size_t most = scarp_isa_active() == SCARP_ISA_SCALAR ? 8 : MOST_POINTS;
        for (job->count = 7; job->count < most; job->count += 1000) {
            job->kind = VECTOR;
            measure(stack, job, worst, "scarp_vector2 and its like");
            job->kind = FLOW;
            measure(stack, job, worst, "scarp_curl2 and its like");
        }
    }
    job->noise.warp = NULL;
}

static void measure_gullies(const struct guarded *stack, struct job *job, struct worst *worst)
{
    static const enum function functions[2] = {SAMPLE2, SAMPLE2_F64};
    const size_t most = scarp_isa_active() == SCARP_ISA_SCALAR ? 8 : MOST_POINTS;
    for (int i = 0; i < 4; i++) {
        job->order = i / 2;
        job->kind = GULLIES;
        job->function = functions[i % 2];
        for (job->count = 7; job->count < most; job->count += 1000) {
            measure(stack, job, worst, "scarp_gullies2 and its like");
        }
        job->kind = GULLY_GRID;
        job->grid = (struct scarp_grid){.step = {0.1, 0.1}, .count = {33, i % 2 == 0 ? 1 : 33}};
        measure(stack, job, worst, "scarp_gullies_grid2");
    }
}

/* A recipe as deep as they may be, of noise that takes much stack itself. */
static void write_deep_recipe(struct recipe_writer *w, int is_space)
{
    memset(w, 0, sizeof *w);
    recipe_put(w,
               "recipe 1\n%sout n = noise(value, hybrid, rotate, octaves=13)\n"
               "out e = noise(erosion, octaves=3) + noise(swiss, octaves=3)\n",
               is_space ? "space 3\n" : "");
    recipe_put(w,
               "w = warp(noise(octaves=3, rotate), noise(ridged, octaves=13, rotate))\nf0 = n\n");
    for (int i = 1; i <= 6; i++) {
        recipe_put(w,
                   "f%d = warp(curve(mix(f%d, clamp(terrace(f%d, 3), -1, 1), smoothstep(n, 0, 1)), "
                   "0: 0, 1: 2, 3: 4), w) + blend(n, 0: f%d, 1: turn(n, 30))\n",
                   i, i - 1, i - 1, i - 1);
    }
    recipe_put(w, "%s\n", is_space ? "" : "g = gullies(f1)\nslopes = slope(warp(slope(n), w))");
}

static void measure_recipes(const struct guarded *stack, struct job *job, struct worst *worst,
                            struct worst *alone)
{
    static uint64_t memory[1 << 16];
    static const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory},
                                      planned = {.plan = plan};
    static struct recipe_writer w;
    job->kind = RECIPE;
    for (int i = 0; i < 4; i++) {
        write_deep_recipe(&w, i % 2);
        job->text = w.text;
        job->order = i < 2 ? 2 : 0;
        job->dimensions = i % 2 == 0 ? 2 : 3;
        job->scratch = NULL;
        job->recipe_call = PARSE;
        measure(stack, job, alone, "scarp_recipe_parse");
        (void)recipe_call(job, NULL); /* whatever calls are left out */
        job->recipe_call = SET;
        measure(stack, job, alone, "scarp_recipe_set");
        job->recipe_call = SHADER_OF_RECIPE;
        measure(stack, job, alone, "scarp_recipe_shader");
        job->recipe_call = UNIFORMS;
        measure(stack, job, alone, "scarp_recipe_uniforms");
        job->recipe_call = ANSWERS;
        measure(stack, job, alone, "scarp_recipe_answers");
        job->recipe_call = PLAN;
        measure(stack, job, worst, "scarp_recipe_plan_make");
        const enum scarp_isa isa = scarp_isa_active();
        for (int k = 0; k < 2; k++) {
            struct worst *const of = k == 0 ? worst : alone;
            job->scratch = k == 0 ? &scratch : i % 2 == 0 ? &planned : NULL;
            job->grid = (struct scarp_grid){.step = {0.1, 0.1, 0.1},
                                            .count = {isa == SCARP_ISA_SCALAR ? 9 : 33, 5, 3}};
            job->count = isa == SCARP_ISA_SCALAR ? 7 : MOST_POINTS;
            job->recipe_call = SAMPLE;
            measure(stack, job, of, "scarp_recipe_sample_f64");
            job->recipe_call = SAMPLE_PART;
            measure(stack, job, of, "scarp_recipe_sample_f64 of a part");
            job->recipe_call = GRID_OF_RECIPE;
            measure(stack, job, of, "scarp_recipe_grid");
            const int order = job->order;
            job->order = order < 1 ? order : 1;
            job->recipe_call = GRID_OF_EROSION;
            measure(stack, job, of, "scarp_recipe_grid of erosion");
            job->order = order;
            job->recipe_call = RANGE;
            measure(stack, job, of, "scarp_recipe_range");
            job->recipe_call = DESCRIBE;
            measure(stack, job, of, "scarp_recipe_entry_at");
        }
    }
}

int main(int argc, char **argv)
{
    every = argc == 3 ? atoi(argv[2]) : 1;
    if (argc < 2 || argc > 3 || every < 1) {
        printf("usage: test_stack ISA [EVERY]\n");
        return EXIT_FAILURE;
    }
    check_select_isa(argv[1]);
    static float f[3][MOST_POINTS];
    static double d[3][MOST_POINTS];
    uint64_t state = 1;
    for (int i = 0; i < 3 * MOST_POINTS; i++) {
        d[i % 3][i / 3] = check_random_double(&state, 100.0);
        f[i % 3][i / 3] = (float)d[i % 3][i / 3];
    }
    const struct inputs in = {{f[0], f[1], f[2]}, {d[0], d[1], d[2]}};
    struct outputs out = outputs_make(MOST_SAMPLES);
    const struct guarded stack = guarded_make(stack_bytes());
    struct job job = {
        .kind = NOTHING, .dimensions = 2, .in = &in, .x = {f[0], f[1], f[2]}, .out = &out};
    struct worst worst = {.nothing = touched(&stack, &job)}, flows = worst, shaders = worst,
                 gullies = worst, recipes = worst, alone = worst;
    for (int i = 0; scarp_basis_name((enum scarp_basis)i) != NULL; i++) {
        /* Fractals do the same with all octaves. */
        const int fractals = i <= SCARP_VALUE ? count_names(fractal_name) : 1;
        for (int k = 0; k < fractals; k++) {
            for (int j = 0; j < (i == SCARP_GRADIENT ? 24 : 12); j++) {
                job.noise = (struct scarp_noise){.basis = (enum scarp_basis)i,
                                                 .fractal = (enum scarp_fractal)k,
                                                 .octaves = j % 2 != 0 ? 3.0f : 1.0f,
                                                 .rotate = (uint32_t)(j / 2 % 2),
                                                 .phase = j < 12 ? 0.0f : 0.3f};
                job.order = j / 4 % 3;
                if (job.order <= noise_order(&job.noise)) {
                    measure_points(&stack, &job, &worst);
                    measure_grids(&stack, &job, &worst);
                    measure_shaders(&stack, &job, &shaders);
                }
                /* With so many, octaves take more of the stack. */
                job.noise.octaves = 13.0f;
                if (job.noise.rotate && job.order == noise_order(&job.noise) && j % 2 != 0) {
                    measure_points(&stack, &job, &worst);
                    measure_grids(&stack, &job, &worst);
                }
                job.noise.octaves = j % 2 != 0 ? 3.0f : 1.0f;
                if (job.order < 2 || k < SCARP_EROSION) {
                    measure_flows(&stack, &job, &flows);
                }
            }
        }
    }
    job.kind = CHAIN;
    for (int i = 0; i < 2 * CHAINS; i++) {
        job.chain = (enum chain)(i / 2);
        job.count = i % 2 == 0 ? 7 : MOST_POINTS;
        measure(&stack, &job, &worst, chain_kinds[i / 2].name);
    }
    measure_gullies(&stack, &job, &gullies);
    measure_recipes(&stack, &job, &recipes, &alone);
    measure_warped(&stack, &job, &worst);
    job.kind = OTHERS;
    measure(&stack, &job, &worst, "scarp_normals, scarp_range and scarp_noise_check");
    printf("%s: at most %zu bytes of stack: %s; a thread alone has %zu\n", argv[1], worst.bytes,
           worst.what, worst.nothing);
    printf("%s: at most %zu bytes: %s\n", argv[1], flows.bytes, flows.what);
    printf("%s: at most %zu bytes: %s\n", argv[1], gullies.bytes, gullies.what);
    printf("%s: at most %zu bytes: %s\n", argv[1], shaders.bytes, shaders.what);
    printf("%s: at most %zu bytes: %s\n", argv[1], recipes.bytes, recipes.what);
    printf("%s: at most %zu bytes without scratch memory: %s\n", argv[1], alone.bytes, alone.what);
    outputs_free(&out);
    return check_done();
}
