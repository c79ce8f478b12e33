/* SPDX-License-Identifier: MIT
 *
 * The peer "plain C": gullies, by scarp's own formulas in plain loops, which the compiler turns
 * into vectors, and may reorder as -ffast-math allows. It shows what the kernels gain by being
 * written as vectors. Points are floats, axes are not turned, and all but the octaves has its
 * default.
 */
#include <math.h>
#include <stdlib.h>

#include "peer.h"

/* Loops with calls in them do not become vectors. */
#define inline __inline__ __attribute__((always_inline))

#include "../src/formulas/c.h"

static inline float magnitude(float a)
{
    return fabsf(a);
}

static inline float inverse(float a)
{
    return 1.0f / a;
}

static inline float root(float a)
{
    return sqrtf(a);
}

static inline float floor_of(float a)
{
    return floorf(a);
}

static inline float either(bool condition, float yes, float no)
{
    return condition ? yes : no;
}

static inline float lattice_value(uint hash)
{
    return (float)(int32_t)hash;
}

#include "../src/formulas/gullies.h"

#define CHUNK 256
#define OCTAVES 5
#define STRIPES 1.5
#define TWO_PI 6.283185307179586

/* What goes from octave to octave, in arrays: so the loops are long enough for vectors. */
struct chunk {
    float s[6][CHUNK], steep[3][CHUNK], exposure[3][CHUNK], sum[3][CHUNK];
};

struct plain_state {
    enum scarp_isa isa;
    int octaves;
    float frequency[OCTAVES], offset[OCTAVES][2];
    struct gully_shape shape;
    struct gully_octave octave[OCTAVES];
    struct lattice lattice[OCTAVES];
};

static inline void put_jet(float (*const of)[CHUNK], size_t i, struct jet j)
{
    of[0][i] = j.value;
    of[1][i] = j.d.x;
    of[2][i] = j.d.y;
}

static inline void put(struct chunk *c, size_t i, struct gully g)
{
    const struct pair_jet s = g.slope;
    const float of[6] = {s.value.x, s.value.y, s.dx.x, s.dx.y, s.dy.x, s.dy.y};
    for (int k = 0; k < 6; k++) {
        c->s[k][i] = of[k];
    }
    put_jet(c->steep, i, g.steep);
    put_jet(c->exposure, i, g.exposure);
    put_jet(c->sum, i, g.sum);
}

/* Without slopes, derivatives are 0, and the compiler drops them. */
static inline struct gully get(const struct chunk *c, size_t i, int slopes)
{
    const struct pair2 none = {0.0f, 0.0f};
    const struct gully g = {
        {{c->s[0][i], c->s[1][i]},
         slopes ? (struct pair2){c->s[2][i], c->s[3][i]} : none,
         slopes ? (struct pair2){c->s[4][i], c->s[5][i]} : none},
        {c->steep[0][i], slopes ? (struct pair2){c->steep[1][i], c->steep[2][i]} : none},
        {c->exposure[0][i], slopes ? (struct pair2){c->exposure[1][i], c->exposure[2][i]} : none},
        {c->sum[0][i], slopes ? (struct pair2){c->sum[1][i], c->sum[2][i]} : none}};
    return g;
}

/* The cell of a coordinate in the frame of an octave */
static inline uint cell_of(float x)
{
    return (uint)(int32_t)floorf(x);
}

/*/* Each pass is there twice: with derivatives, and without. */

static inline void begin(const struct plain_state *p, struct chunk *c, size_t n,
                         const struct scarp_samples *b, int slopes)
{
    const float *const v = b->value, *const dx = b->dx, *const dy = b->dy;
    const float *const dxx = b->dxx, *const dxy = b->dxy, *const dyy = b->dyy;
    const struct gully_shape shape = p->shape;
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        const struct gully_base base = {v[i],
                                        dx[i],
                                        dy[i],
                                        slopes ? dxx[i] : 0.0f,
                                        slopes ? dxy[i] : 0.0f,
                                        slopes ? dyy[i] : 0.0f};
        put(c, i, gully_begin(shape, base));
    }
}

static inline void add_octave(const struct plain_state *p, int k, struct chunk *c, size_t n,
                              const float *x, const float *y, int slopes)
{
    const struct gully_shape shape = p->shape;
    const struct gully_octave octave = p->octave[k];
    const struct lattice lattice = p->lattice[k];
    const float frequency = p->frequency[k], ox = p->offset[k][0], oy = p->offset[k][1];
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        const float px = x[i] * frequency + ox, py = y[i] * frequency + oy;
        const uint cx = cell_of(px), cy = cell_of(py);
        const struct location at = {
            {cx, cy, 0}, {cx + 1, cy + 1, 0}, {px - floorf(px), py - floorf(py), 0.0f}};
        const struct gully g = get(c, i, slopes);
        put(c, i, gully_octave_at(shape, octave, lattice, at, g));
    }
}

static inline void end(struct chunk *c, size_t n, const struct scarp_samples *b,
                       const struct scarp_eroded *out, int slopes)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        out->value[i] = b->value[i] + c->sum[0][i];
        if (slopes) {
            out->dx[i] = b->dx[i] + c->sum[1][i];
            out->dy[i] = b->dy[i] + c->sum[2][i];
        }
    }
}

static inline void run(const struct plain_state *p, size_t n, const float *const x[2],
                       const struct scarp_samples *base, const struct scarp_eroded *out, int slopes)
{
    struct chunk c;
    begin(p, &c, n, base, slopes);
    for (int k = 0; k < p->octaves; k++) {
        add_octave(p, k, &c, n, x[0], x[1], slopes);
    }
    end(&c, n, base, out, slopes);
}

#define RUN(name, sets)                                                                            \
    __attribute__((target(sets))) static void name(                                                \
        const struct plain_state *p, size_t n, const float *const x[2],                            \
        const struct scarp_samples *base, const struct scarp_eroded *out)                          \
    {                                                                                              \
        if (out->dx != NULL) {                                                                     \
            run(p, n, x, base, out, 1);                                                            \
        } else {                                                                                   \
            run(p, n, x, base, out, 0);                                                            \
        }                                                                                          \
    }

RUN(run_sse41, "sse4.1")
RUN(run_avx2, "avx2,fma")
RUN(run_avx512, "avx512f,avx512bw,avx512dq,avx512vl,fma")

static void set_octave(struct plain_state *p, int k, double weight)
{
    const double f = 3.0 * ldexp(1.0, k);
    p->frequency[k] = (float)f;
    p->offset[k][0] = k == 0 ? 0.0f : 0.3f + 0.1f * (float)k;
    p->offset[k][1] = k == 0 ? 0.0f : 0.7f - 0.1f * (float)k;
    p->octave[k] = (struct gully_octave){.weight = (float)weight,
                                         .keep = k == 0 ? 0.0f : 1.0f,
                                         .waves = {(float)STRIPES, 0.0f},
                                         .angles = {(float)(TWO_PI * STRIPES), 0.0f},
                                         .cells = {(float)f, 0.0f},
                                         .stretch = (float)(TWO_PI * STRIPES * f)};
    p->lattice[k] = (struct lattice){.key = {0x632be5abu * (uint)(k + 1), 1, 2}};
}

static void *plain_open(const struct bench_work *work, enum scarp_isa isa)
{
    const double gain = 0.45, round = 0.15;
    if (work->layout != BENCH_GULLIES || !scarp_isa_supported(isa) || work->octaves > OCTAVES ||
        (isa != SCARP_ISA_SSE41 && isa != SCARP_ISA_AVX2 && isa != SCARP_ISA_AVX512)) {
        return NULL;
    }
    struct plain_state *const p = malloc(sizeof *p);
    if (p != NULL) {
        double weight = 0.25 * (1.0 - gain) / (1.0 - pow(gain, work->octaves));
        p->isa = isa;
        p->octaves = work->octaves;
        p->shape = (struct gully_shape){.low = -1.0f,
                                        .steepness = 0.5f,
                                        .slope2 = 1.125f * 1.125f,
                                        .slope2_low = 1.75f * 1.75f,
                                        .lowered = 1.5f,
                                        .round = (float)round,
                                        .round2 = (float)(round * round),
                                        .fall = (float)(2.0 / (sqrt(1.0 + round * round) - round)),
                                        .branch = 0.8f};
        for (int k = 0; k < p->octaves; k++, weight *= gain) {
            set_octave(p, k, weight);
        }
    }
    return p;
}

static void plain_gullies(const void *state, size_t count, const float *const x[2],
                          const struct scarp_samples *base, const struct scarp_eroded *out)
{
    const struct plain_state *const p = state;
    for (size_t i = 0; i < count; i += CHUNK) {
        const size_t n = count - i < CHUNK ? count - i : CHUNK;
        const float *const from[2] = {x[0] + i, x[1] + i};
        const struct scarp_samples b = {.value = base->value + i,
                                        .dx = base->dx + i,
                                        .dy = base->dy + i,
                                        .dxx = base->dxx + i,
                                        .dxy = base->dxy + i,
                                        .dyy = base->dyy + i};
        const struct scarp_eroded to = {.value = out->value + i,
                                        .dx = out->dx != NULL ? out->dx + i : NULL,
                                        .dy = out->dy != NULL ? out->dy + i : NULL};
        (p->isa == SCARP_ISA_AVX512 ? run_avx512
         : p->isa == SCARP_ISA_AVX2 ? run_avx2
                                    : run_sse41)(p, n, from, &b, &to);
    }
}

const struct bench_peer bench_peer_plain = {
    .library = "plain C", .open = plain_open, .close = free, .gullies = plain_gullies};
