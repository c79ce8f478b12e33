/* SPDX-License-Identifier: MIT
 *
 * Plans that callers keep, of a noise and of each noise of a chain of warps: a plan that fits is
 * used, any other changes nothing, and scarp_plan_make refuses what scarp_noise_check refuses. (test_bits.c, test_threads.c and
 * test_fpmode.c use plans, too.)
 *
 *     test_plan ISA
 *     test_plan --must-differ ISA    some result must be wrong: for mutants
 */
#include "../src/plan/kept.h"
#include "api_reserved.h"

#define POINTS 21 /* a block of 16 and a part */

/* Makes a call of each kind; reserved_arguments() says with what. */
static void plan_calls(const struct reserved_test *t, const struct scarp_noise *noise, int call,
                       const struct outputs *o)
{
    const struct reserved_test to = {t->in, t->points, o, NULL};
    struct reserved_arguments a = reserved_arguments(&to, call);
    if (call >= FUNCTIONS) {
        a.grid.origin[0] = 0.37;
        a.grid.step[0] = a.grid.step[1] = a.grid.step[2] = 0.11;
    }
    a.noise = *noise;
    if (noise_order(noise) < 2) {
        a.out.dxx = a.out.dxy = a.out.dxz = a.out.dyy = a.out.dyz = a.out.dzz = NULL;
    }
    if ((outputs_of(noise, SAMPLE2) & OUTPUTS_PHASE) != 0) {
        a.out.dphase = o->array[OUTPUT_dphase];
    }
    outputs_poison(o);
    CHECK(reserved_call(t, call, &a) == SCARP_OK, "call %d", call);
}

static int plan_dimensions(int call)
{
    return call < FUNCTIONS ? function_dimensions((enum function)call) : 2 + call - FUNCTIONS;
}

/* Whether calls with the plan give the bits of calls without. */
static int plan_is_harmless(const struct reserved_test *t, const struct scarp_noise *noise,
                            const struct scarp_plan *plan, int call)
{
    int member = 0;
    size_t index = 0;
    struct scarp_noise with = *noise;
    with.plan = plan;
    plan_calls(t, noise, call, t->one);
    plan_calls(t, &with, call, t->two);
    return outputs_equal(t->one, t->two, ~0u, t->points, &member, &index);
}

static struct scarp_plan plan_of(const struct scarp_noise *noise, int dimensions)
{
    struct scarp_plan plan;
    memset(&plan, POISON, sizeof plan);
    CHECK(scarp_plan_make(noise, dimensions, &plan) == SCARP_OK, "no plan");
    return plan;
}

/* Changes constants of octave 0 and 1. */
static void plan_spoil(struct scarp_plan *plan)
{
    unsigned char *const bytes = (unsigned char *)plan;
    const size_t first = offsetof(struct kept, octave);
    for (size_t i = first; i < first + 400; i++) {
        bytes[i] ^= 0x10;
    }
}

/* A plan, and a copy of it elsewhere, give the same bits, and are what the calls use: if they are
   spoilt, results differ. */
static void test_plan_used(const struct reserved_test *t)
{
    for (int i = 0; i < 8 + count_names(basis_name) - SCARP_SIMPLEX; i++) {
        const struct scarp_noise noise = {
            .fractal = (enum scarp_fractal)(i < 8 ? i / 2 % 4 : i % count_names(fractal_name)),
            .octaves = 3.5f,
            .rotate = (uint32_t)i % 2,
            .seed = (uint64_t)i,
            .period = {i == 2, i == 4 ? 3 : 0, 0},
            .phase = i > 3 && i < 8 && i % 3 != 0 ? 0.4f : 0.0f,
            .jitter = i > 8 ? 0.7f : 0.0f,
            .offset_first = i % 3 == 1,
            .basis = (enum scarp_basis)(i < 8 ? i % 3 == 0 : SCARP_SIMPLEX + i - 8)};
        for (int call = 0; call < RESERVED_CALLS; call++) {
            const struct scarp_plan plan = plan_of(&noise, plan_dimensions(call));
            struct scarp_plan copy = plan;
            CHECK_BITS(plan_is_harmless(t, &noise, &plan, call), "noise %d, call %d", i, call);
            CHECK_BITS(plan_is_harmless(t, &noise, &copy, call), "noise %d, call %d, copy", i,
                       call);
            plan_spoil(&copy);
            CHECK_BITS(!plan_is_harmless(t, &noise, &copy, call),
                       "noise %d, call %d: the plan is unused", i, call);
        }
    }
}

/* Plans of other noises, which differ in one member, or in one bit. */
static void test_plan_stale(const struct reserved_test *t)
{
    static const struct scarp_noise noise = {
        .octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f};
    const struct scarp_noise others[] = {
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .basis = SCARP_VALUE},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .fade = SCARP_CUBIC},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .fractal = SCARP_RIDGED},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .rotate = 1},
        {.octaves = 3.0f, .seed = 2, .frequency = 0.7, .lacunarity = 1.9f},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.8, .lacunarity = 1.9f},
        {.octaves = 2.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.8f},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .gain = 0.6f},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .amplitude = 2.0f},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .phase = 0.25f},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 2.0f, .period = {0, 3}},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .offset_first = 1},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .basis = SCARP_SIMPLEX},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .basis = SCARP_CELL_F1}};
    for (int call = 0; call < RESERVED_CALLS; call++) {
        const int dimensions = plan_dimensions(call);
        for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
            const struct scarp_plan plan = plan_of(&others[i], dimensions);
            CHECK_BITS(plan_is_harmless(t, &noise, &plan, call), "call %d, plan of noise %zu", call,
                       i);
        }
        const struct scarp_plan other = plan_of(&noise, 5 - dimensions);
        CHECK_BITS(plan_is_harmless(t, &noise, &other, call), "call %d, plan of the other space",
                   call);
    }
}

/* Plans that no call has made: of one byte all over, random, and good ones of which one bit of the
   version, the dimensions or the noise is another one while all constants are spoilt. */
static void test_plan_garbage(const struct reserved_test *t)
{
    const struct scarp_noise noise = {.octaves = 2.0f};
    static const int fills[] = {0, 0xff, 0x77, 1};
    struct scarp_plan plan;
    unsigned char *const bytes = (unsigned char *)&plan;
    uint64_t state = 1;
    for (int call = 0; call < RESERVED_CALLS; call++) {
        for (size_t i = 0; i < sizeof fills / sizeof fills[0]; i++) {
            memset(&plan, fills[i], sizeof plan);
            CHECK_BITS(plan_is_harmless(t, &noise, &plan, call), "call %d, all %d", call, fills[i]);
        }
        for (size_t i = 0; i < sizeof plan; i++) {
            bytes[i] = (unsigned char)check_random(&state);
        }
        CHECK_BITS(plan_is_harmless(t, &noise, &plan, call), "call %d, random bytes", call);
    }
    plan = plan_of(&noise, 2);
    plan_spoil(&plan);
    const size_t pointers = 8 + offsetof(struct scarp_noise, warp);
    for (size_t bit = 0; bit < 8 * (8 + sizeof noise); bit++) {
        if (bit / 8 >= pointers && bit / 8 < pointers + 2 * sizeof(void *)) {
            continue; /* what is there is not compared */
        }
        bytes[bit / 8] ^= (unsigned char)(1u << bit % 8);
        CHECK_BITS(plan_is_harmless(t, &noise, &plan, SAMPLE2), "bit %zu is not looked at", bit);
        bytes[bit / 8] ^= (unsigned char)(1u << bit % 8);
    }
    CHECK_BITS(!plan_is_harmless(t, &noise, &plan, SAMPLE2), "the spoilt plan does not fit");
}

/* What scarp_plan_make refuses, and that it writes nothing then. A good plan does not make calls
   take a noise that they must refuse. */
static void test_plan_refused(const struct reserved_test *t)
{
    const struct scarp_noise good = {.octaves = 2.0f};
    const struct scarp_noise loop = {.warp = &loop};
    const struct scarp_noise bad[] = {{.basis = (enum scarp_basis)77},
                                      {.fade = (enum scarp_fade)9},
                                      {.fractal = (enum scarp_fractal)99},
                                      {.octaves = 33.0f},
                                      {.octaves = NAN},
                                      {.frequency = -1.0},
                                      {.phase = NAN},
                                      {.phase = 1.0f, .basis = SCARP_VALUE},
                                      {.phase = 1.0f, .basis = SCARP_CELL_SOFT},
                                      {.jitter = 1.5f},
                                      {.period = {0, 0x40000001, 0}},
                                      {.sharpness = 0x1p25f},
                                      {.octaves = 3.0f, .of_octaves = 2.9f},
                                      {.warp = &loop},
                                      {.spare_word = 1},
                                      {.spare = {1}}};
    struct scarp_plan plan = plan_of(&good, 2);
    const struct scarp_plan before = plan;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        for (int dimensions = 1; dimensions <= 4; dimensions++) {
            CHECK(scarp_plan_make(&bad[i], dimensions, &plan) ==
                      scarp_noise_check(&bad[i], dimensions, NULL),
                  "noise %zu, %d dimensions", i, dimensions);
        }
        struct scarp_noise noise = bad[i];
        noise.plan = &plan;
        const struct scarp_samples out = outputs_subset(t->one, OUTPUTS_ALL2);
        outputs_poison(t->one);
        CHECK(function_call(SAMPLE2, &noise, t->points, t->in, &out) ==
                  scarp_noise_check(&bad[i], 2, NULL),
              "noise %zu with the plan of another", i);
        CHECK(outputs_untouched(t->one, ~0u), "noise %zu: outputs were written", i);
    }
    CHECK(scarp_plan_make(NULL, 2, &plan) == SCARP_ERROR_NULL, "no noise");
    CHECK(scarp_plan_make(&good, 2, NULL) == SCARP_ERROR_NULL, "no plan");
    CHECK(scarp_plan_make(&good, 4, &plan) == SCARP_ERROR_PARAMETER, "4 dimensions");
    CHECK(memcmp(&plan, &before, sizeof plan) == 0, "a plan was written");
    struct scarp_noise erosion = {.fractal = SCARP_EROSION};
    plan = plan_of(&erosion, 2);
    erosion.plan = &plan;
    const struct scarp_samples hessian = {.dxx = t->one->array[0]};
    CHECK(function_call(SAMPLE2, &erosion, 1, t->in, &hessian) == SCARP_ERROR_UNSUPPORTED,
          "the plan of an erosion gives it a Hessian");
    struct scarp_noise value = {.basis = SCARP_VALUE};
    plan = plan_of(&value, 2);
    value.plan = &plan;
    const struct scarp_samples turning = {.dphase = t->one->array[0]};
    CHECK(function_call(SAMPLE2, &value, 1, t->in, &turning) == SCARP_ERROR_UNSUPPORTED,
          "the plan of value noise gives it a phase");
}

/*
 * Chains of warps, of which each noise brings its own plan
 */

#define LEVELS 5

struct chain {
    struct scarp_noise noise[LEVELS];
    struct scarp_plan plan[LEVELS];
};

/* Calls of vector noise, which take a vector plan of the noise itself, and others that look at the
   whole chain; they come behind RESERVED_CALLS. */
enum {
    VECTOR2 = RESERVED_CALLS,
    VECTOR3,
    VECTOR2_F64,
    VECTOR3_F64,
    CURL3,
    CURL3_F64,
    CURL2,
    CELLS3,
    CHAIN_CALLS
};

static int takes_vector(int call)
{
    return call >= VECTOR2 && call <= CURL3_F64;
}

static int chain_dimensions(int call)
{
    return call < RESERVED_CALLS                                     ? plan_dimensions(call)
           : call == VECTOR2 || call == VECTOR2_F64 || call == CURL2 ? 2
                                                                     : 3;
}

static void chain_call(const struct reserved_test *t, const struct scarp_noise *noise, int call,
                       const struct outputs *o)
{
    float *const *const a = o->array;
    const size_t n = t->points;
    const float *const *const x = t->in->f;
    const double *const *const d = t->in->d;
    const struct scarp_samples vector[3] = {{.value = a[0], .dx = a[3], .dy = a[6]},
                                            {.value = a[1], .dx = a[4], .dy = a[7]},
                                            {.value = a[2], .dx = a[5], .dy = a[8]}};
    const struct scarp_flow flow = {.vx = a[0], .vy = a[1]}, flow3 = {.vx = a[0], .vz = a[2]};
    const struct scarp_cells cells = {.f1 = a[0], .f2 = a[1], .dx1 = a[2]};
    enum scarp_status status = SCARP_OK;
    if (call < RESERVED_CALLS) {
        plan_calls(t, noise, call, o);
        return;
    }
    outputs_poison(o);
    switch (call) {
    case VECTOR2: status = scarp_vector2(noise, n, x[0], x[1], vector); break;
    case VECTOR3: status = scarp_vector3(noise, n, x[0], x[1], x[2], vector); break;
    case VECTOR2_F64: status = scarp_vector2_f64(noise, n, d[0], d[1], vector); break;
    case VECTOR3_F64: status = scarp_vector3_f64(noise, n, d[0], d[1], d[2], vector); break;
    case CURL3: status = scarp_curl3(noise, n, x[0], x[1], x[2], &flow3); break;
    case CURL3_F64: status = scarp_curl3_f64(noise, n, d[0], d[1], d[2], &flow3); break;
    case CURL2: status = scarp_curl2(noise, n, x[0], x[1], &flow); break;
    default: status = scarp_cells3(noise, n, x[0], x[1], x[2], &cells); break;
    }
    CHECK(status == SCARP_OK, "call %d", call);
}

/* Makes the plan that fits level k for a call. */
static void keep_level(struct chain *c, int k, int call, int is_other_kind, int dimensions)
{
    const int is_vector = (k > 0 || takes_vector(call)) != is_other_kind;
    memset(&c->plan[k], POISON, sizeof c->plan[k]);
    CHECK((is_vector ? scarp_vector_plan_make : scarp_plan_make)(&c->noise[k], dimensions,
                                                                 &c->plan[k]) == SCARP_OK,
          "no plan");
    c->noise[k].plan = &c->plan[k];
}

/* Different noises at all levels, with plans. */
static void make_chain(struct chain *c, int number, int levels, int call)
{
    static const enum scarp_basis bases[] = {SCARP_GRADIENT, SCARP_VALUE, SCARP_SIMPLEX,
                                             SCARP_CELL_F1, SCARP_CELL_SOFT};
    memset(c, 0, sizeof *c);
    for (int k = 0; k < levels; k++) {
        const int i = number + 2 * k;
        c->noise[k] = (struct scarp_noise){.basis = bases[i % 5],
                                           .fractal = (enum scarp_fractal)(i % 8),
                                           .seed = (uint64_t)i,
                                           .octaves = k == 0 ? 3.5f : 2.0f,
                                           .frequency = 0.3 + 0.1 * k,
                                           .amplitude = k == 0 ? 1.0f : 0.5f,
                                           .rotate = (uint32_t)i % 2,
                                           .phase = i % 5 == 0 ? 0.2f : 0.0f,
                                           .offset_first = 1,
                                           .warp = k + 1 < levels ? &c->noise[k + 1] : NULL};
    }
    for (int k = 0; k < levels; k++) {
        keep_level(c, k, call, 0, chain_dimensions(call));
    }
}

/* Whether a call gives the same bits as without plans. */
static int chain_agrees(const struct reserved_test *t, const struct chain *c, int call)
{
    struct chain bare;
    int member = 0;
    size_t index = 0;
    memcpy(bare.noise, c->noise, sizeof bare.noise);
    for (int k = 0; k < LEVELS; k++) {
        bare.noise[k].plan = NULL;
        bare.noise[k].warp = c->noise[k].warp == NULL ? NULL : &bare.noise[k + 1];
    }
    chain_call(t, &bare.noise[0], call, t->one);
    chain_call(t, &c->noise[0], call, t->two);
    return outputs_equal(t->one, t->two, ~0u, t->points, &member, &index);
}

/* Plans of all levels are used, each for itself, and a level whose plan does not fit leaves the
   others alone. The warps of cells do not count. */
static void test_chain_level(const struct reserved_test *t, int number, int levels, int call, int k)
{
    static struct chain c;
    const int dimensions = chain_dimensions(call);
    for (int alone = 0; alone < 2; alone++) { /* also where no other level has a plan */
        make_chain(&c, number, levels, call);
        plan_spoil(&c.plan[k]);
        for (int other = 0; alone > 0 && other < levels; other++) {
            c.noise[other].plan = other == k ? &c.plan[k] : NULL;
        }
        CHECK_BITS(!chain_agrees(t, &c, call) || (call == CELLS3 && k > 0),
                   "chain %d of %d, call %d: the plan of level %d is unused", number, levels, call,
                   k);
    }
    for (int way = 0; way < 6; way++) { /* the plan does not fit; constants show if it is used */
        make_chain(&c, number, levels, call);
        if (way == 4 || way == 5) {
            keep_level(&c, k, call, way == 4, way == 4 ? dimensions : 5 - dimensions);
        }
        plan_spoil(&c.plan[k]);
        c.noise[k].seed += way == 0;
        c.noise[k].amplitude *= way == 1 ? 2.0f : 1.0f;
        c.noise[k].octaves -= way == 2 ? 1.0f : 0.0f;
        c.noise[k].offset_first += way == 3;
        CHECK_BITS(chain_agrees(t, &c, call), "chain %d of %d, call %d: level %d, way %d", number,
                   levels, call, k, way);
    }
}

/* The warp of a noise whose plan stays: others, in the same place and elsewhere, and none. */
static void test_chain_changed(const struct reserved_test *t, int number, int call)
{
    static struct chain c, other;
    make_chain(&c, number, 3, call);
    make_chain(&other, number + 1, 3, call);
    c.noise[1].warp = NULL;
    CHECK_BITS(chain_agrees(t, &c, call), "call %d: the deepest warp is gone", call);
    c.noise[0].warp = NULL;
    CHECK_BITS(chain_agrees(t, &c, call), "call %d: all warps are gone", call);
    make_chain(&c, number, 3, call);
    const struct scarp_plan *const plan = c.noise[1].plan;
    c.noise[1] = other.noise[1];
    c.noise[1].plan = plan;
    c.noise[1].warp = &c.noise[2];
    CHECK_BITS(chain_agrees(t, &c, call), "call %d: another warp", call);
}

static void test_chains(const struct reserved_test *t)
{
    static struct chain c;
    for (int call = 0; call < CHAIN_CALLS && !check_enough(); call++) {
        for (int i = 0; i < 2 * LEVELS; i++) {
            const int levels = 1 + i % LEVELS, number = 3 * call + i;
            make_chain(&c, number, levels, call);
            CHECK_BITS(chain_agrees(t, &c, call), "chain %d of %d, call %d", number, levels, call);
            for (int k = 0; k < levels; k++) {
                test_chain_level(t, number, levels, call, k);
            }
        }
        test_chain_changed(t, call, call);
    }
}

/* A plan has room for 50 octaves: those of three components with 16 octaves, but not with 17. Other
   levels have more than the stack has room for. */
static void test_chain_room(const struct reserved_test *t)
{
    static struct chain c;
    for (int octaves = 16; octaves <= 17; octaves++) {
        for (int planned = 1; planned < 4; planned++) { /* a bit for each level */
            make_chain(&c, 3, 2, VECTOR3);
            for (int k = 0; k < 2; k++) {
                c.noise[k].octaves = (float)octaves;
                c.noise[k].lacunarity = 1.1f;
                c.noise[k].fractal = SCARP_FBM;
                c.noise[k].phase = 0.0f;
                c.noise[k].basis = SCARP_SIMPLEX;
                keep_level(&c, k, VECTOR3, 0, 3);
                c.noise[k].plan = (planned >> k & 1) != 0 ? &c.plan[k] : NULL;
            }
            CHECK_BITS(chain_agrees(t, &c, VECTOR3), "%d octaves, plans %d", octaves, planned);
            plan_spoil(&c.plan[0]);
            plan_spoil(&c.plan[1]);
            CHECK_BITS(chain_agrees(t, &c, VECTOR3) == (octaves > 16), "%d octaves, plans %d",
                       octaves, planned);
        }
    }
}

/* Good plans do not make a call take a chain that it must refuse: one that is too long, one that
   never ends, and one with a warp that has no Hessian. */
static void test_chain_refused(const struct reserved_test *t)
{
    static struct chain c;
    static struct scarp_plan of_sixth;
    struct scarp_noise sixth = {.seed = 6};
    const struct scarp_samples value = {.value = t->one->array[0]};
    const struct scarp_samples hessian = {.dxx = t->one->array[0]};
    make_chain(&c, 0, LEVELS, SAMPLE2);
    CHECK(scarp_vector_plan_make(&sixth, 2, &of_sixth) == SCARP_OK, "no plan");
    sixth.plan = &of_sixth;
    CHECK(function_call(SAMPLE2, &c.noise[0], 1, t->in, &value) == SCARP_OK, "four warps");
    c.noise[4].warp = &sixth;
    CHECK(function_call(SAMPLE2, &c.noise[0], 1, t->in, &value) == SCARP_ERROR_UNSUPPORTED,
          "five warps");
    c.noise[4].warp = &c.noise[1];
    CHECK(function_call(SAMPLE2, &c.noise[0], 1, t->in, &value) == SCARP_ERROR_UNSUPPORTED,
          "a loop of warps");
    make_chain(&c, 0, 3, SAMPLE2);
    for (int k = 0; k < 3; k++) {
        c.noise[k].fractal = k == 2 ? SCARP_EROSION : SCARP_FBM;
        keep_level(&c, k, SAMPLE2, 0, 2);
    }
    CHECK(function_call(SAMPLE2, &c.noise[0], 1, t->in, &hessian) == SCARP_ERROR_UNSUPPORTED,
          "a Hessian through erosion");
    c.noise[1].octaves = 33.0f;
    CHECK(function_call(SAMPLE2, &c.noise[0], 1, t->in, &value) == SCARP_ERROR_PARAMETER,
          "a warp has become bad behind its plan");
    CHECK(scarp_vector_plan_make(NULL, 2, &c.plan[0]) == SCARP_ERROR_NULL, "no noise");
    CHECK(scarp_vector_plan_make(&sixth, 2, NULL) == SCARP_ERROR_NULL, "no plan");
    CHECK(scarp_vector_plan_make(&sixth, 1, &c.plan[0]) == SCARP_ERROR_PARAMETER, "a line");
    CHECK(scarp_vector_plan_make(&c.noise[1], 2, &c.plan[0]) == SCARP_ERROR_PARAMETER, "a bad one");
}

int main(int argc, char **argv)
{
    static float f[3][POINTS];
    static double d[3][POINTS];
    static const struct inputs in = {{f[0], f[1], f[2]}, {d[0], d[1], d[2]}};
    struct outputs one = outputs_make(POINTS), two = outputs_make(POINTS);
    const struct reserved_test t = {&in, POINTS, &one, &two};
    uint64_t state = 1;
    argc = check_take_aim(argc, &argv);
    check_select_isa(argc > 1 ? argv[1] : "scalar");
    for (int i = 0; i < 3 * POINTS; i++) {
        f[i % 3][i / 3] = check_random_float(&state, 64.0f);
        d[i % 3][i / 3] = check_random_double(&state, 0x1p20);
    }
    test_plan_used(&t);
    test_plan_stale(&t);
    test_plan_garbage(&t);
    test_chains(&t);
    test_chain_room(&t);
    if (check_aim == CHECK_SAME) { /* a mutant may crash on a noise that it has to refuse */
        test_plan_refused(&t);
        test_chain_refused(&t);
    }
    outputs_free(&one);
    outputs_free(&two);
    return check_done();
}
