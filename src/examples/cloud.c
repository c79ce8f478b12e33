/* SPDX-License-Identifier: MIT
 *
 * Draws cumulus clouds over the sea: an example of ray marching with batches and exact gradients.
 *
 *     cloud [--isa NAME] [WIDTHxHEIGHT] [FILE.ppm]
 *
 * The picture is a PPM of 960x540 pixels, on stdout without a file name. The program needs scarp
 * and the C library, no more: cc -O3 cloud.c -lscarp -lm. With -fopenmp it uses all cores.
 *
 * What is worth copying:
 * - Rays go through a cloud together: one call samples the noise for all of them. Rays that have
 *   left the cloud, or see no further into it, leave the batch.
 * - The noise is sampled once per point, and never towards the light. The gradient from that same
 *   call tells how much cloud lies towards the sun, and how far a ray may step.
 * - The cloud is composed with the chain rule (scarp_smooth_max, scarp_add, ...), so the gradient
 *   is that of the cloud, not that of the noise only.
 * - All is + - * / and square roots, so every machine draws the same bytes, unless the compiler
 *   fuses operations, which -ffp-contract=off forbids.
 *
 * Lengths are in kilometres. x points to the right, y up, z away from the camera.
 */
#include <scarp.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    SIDE = 2, /* a pixel is the mean of SIDE x SIDE rays */
    EACH = SIDE * SIDE,
    RAYS = 8192, /* of a batch: as many as the caches hold */
    STEPS = 256, /* of a ray through a cloud, at most */
    CLOUDS = 24, /* in the sky */
    BALLS = 14   /* of a cloud */
};

struct vector { /* also a colour: red, green, blue */
    float x, y, z;
};
struct ball {
    struct vector centre;
    float radius;
};
struct cloud {
    struct ball ball[BALLS], bounds; /* what it is made of, and where it is */
    float scale;                     /* of all its lengths: 1 for the cloud in front */
    struct scarp_noise noise;
};
struct field { /* a function of the place, at the points of a call: its value and gradient */
    float value[RAYS], dx[RAYS], dy[RAYS], dz[RAYS];
};
struct batch {
    struct vector way[RAYS], colour[RAYS]; /* where each ray goes, and what it has met */
    float hidden[RAYS];                    /* how much that hides of what is behind */
    float t[RAYS], end[RAYS];              /* how far the ray is, and the bounds of the cloud go */
    int live[RAYS];                        /* the rays that are in the cloud, and see something */
    float x[RAYS], y[RAYS], z[RAYS];       /* where these are */
    struct field density, other;           /* and how far inside the cloud that is */
};

static const struct vector camera = {0, 0.25f, 0}, sun = {-0.82f, 0.56f, -0.12f};
static const float base = 1;     /* the height where clouds begin */
static const float octaves = 8;  /* of the noise of clouds that are near enough to show them */
static const float lens = 2.45f; /* focal length, in halves of the height of the picture */
static struct cloud clouds[CLOUDS];

static float dot(struct vector a, struct vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct vector add(struct vector a, struct vector b, float times)
{
    return (struct vector){a.x + b.x * times, a.y + b.y * times, a.z + b.z * times};
}

static struct vector mix(struct vector a, struct vector b, float part)
{
    return add(a, add(b, a, -1), part);
}

static float clamp(float a, float lo, float hi)
{
    return a < lo ? lo : a > hi ? hi : a;
}

/* What a depth of x >= 0 leaves of the light: about exp(-x). */
static float fade(float x)
{
    float left = 1 / (1 + x / 256);
    for (int i = 0; i < 8; i++) {
        left *= left;
    }
    return left;
}

/* A number in [0, 1) that looks random. */
static float dice(unsigned a)
{
    a *= 0x9e3779b9U;
    a = (a ^ a >> 16) * 0x7feb352dU;
    a = (a ^ a >> 15) * 0x846ca68bU;
    return (float)((a ^ a >> 16) >> 8) * 0x1p-24f;
}

static void fail(int status, const char *message)
{
    fprintf(stderr, "cloud: %s\n", message);
    exit(status);
}

static void must(enum scarp_status status)
{
    if (status != SCARP_OK) {
        fail(EXIT_FAILURE, scarp_status_text(status));
    }
}

static struct scarp_samples samples(struct field *a)
{
    return (struct scarp_samples){.value = a->value, .dx = a->dx, .dy = a->dy, .dz = a->dz};
}

/* The sky is deep blue above, paler where one looks through more air, and pale around the sun. */
static struct vector sky(struct vector way)
{
    static const struct vector high = {0.07f, 0.20f, 0.52f}, middle = {0.30f, 0.52f, 0.85f};
    static const struct vector low = {0.78f, 0.84f, 0.90f}, glow = {0.12f, 0.10f, 0.07f};
    const float up = clamp(way.y, 0, 1), near = clamp(dot(way, sun), 0, 1);
    const struct vector blue = mix(mix(high, middle, fade(3.2f * up)), low, fade(14 * up));
    return add(blue, glow, near * near * near * near);
}

/* Haze: 45 km turn all but 1 / e of a colour into that of the sky at the horizon. */
static struct vector haze(struct vector colour, struct vector way, float distance)
{
    return mix(sky((struct vector){way.x, clamp(way.y, 0, 1), way.z}), colour, fade(distance / 45));
}

/* What is behind the clouds: the sky, or the sea, which mirrors the more of it the flatter one
   looks (Schlick 1994). */
static struct vector backdrop(struct vector way)
{
    static const struct vector water = {0.02f, 0.06f, 0.09f};
    const float flat = 1 + way.y, flat2 = flat * flat;
    if (way.y >= 0) {
        return sky(way);
    }
    const struct vector mirrored = sky((struct vector){way.x, -way.y, way.z});
    return haze(add(water, mirrored, 0.85f * flat2 * flat2 * flat), way, camera.y / -way.y);
}

/*
 * How much cloud lies between a place and the sun, without the noise: the large shadows. As balls
 * are parabolas, this is a formula. Let the line to the sun pass the middle of its chord through a
 * ball at s = 0, and leave the ball at s = h: there the ball is (h^2 - s^2) / r^2 deep. The
 * integral goes from where the place is, s = m, or from where the ball begins, s = -h.
 */
static float shadow(const struct cloud *cloud, struct vector place)
{
    float sum = 0;
    for (int i = 0; i < BALLS; i++) {
        const struct vector to = add(place, cloud->ball[i].centre, -1);
        const float rr = 1.3f * cloud->ball[i].radius * cloud->ball[i].radius; /* with billows */
        const float m = dot(to, sun), hh = rr - (dot(to, to) - m * m);
        if (hh > 0 && (m < 0 || m * m < hh)) {
            const float h = sqrtf(hh), s = m > -h ? m : -h;
            sum += (hh * (h - s) - (h * hh - s * s * s) / 3) / rr;
        }
    }
    return sum;
}

/* The light that a place in the cloud sends to the camera. `slope` is the gradient of `density`. */
static struct vector shade(const struct cloud *cloud, struct vector place, struct vector way,
                           float density, struct vector slope)
{
    static const struct vector sunlight = {1.70f, 1.60f, 1.40f}, skylight = {0.22f, 0.34f, 0.52f};
    static const struct vector sealight = {0.060f, 0.068f, 0.075f};
    const float scale = cloud->scale;

    /* The small shadows: the density a little nearer to the sun is the density here plus the
       distance times the derivative along the sun, which is gradient . sun. Below 0 there is no
       cloud; the root makes that limit smooth. */
    const float ahead = density + 0.1f * scale * dot(slope, sun);
    const float near = 0.5f * (ahead + sqrtf(ahead * ahead + 0.004f * scale * scale));
    const float depth = (45 * near + 20 * shadow(cloud, place)) / scale;

    /* Droplets scatter light mostly ahead, g says how much so (Henyey and Greenstein 1941): that is
       the silver lining. What is scattered again is less, comes through more cloud, and goes more
       to all sides. */
    float lit = 0, share = 1, dense = 1, g = 0.75f;
    for (int i = 0; i < 4; i++) {
        const float q = 1 + g * g - 2 * g * dot(way, sun);
        lit += share * (0.6f + 0.25f * (1 - g * g) / (q * sqrtf(q))) * fade(dense * depth);
        share *= 0.55f;
        dense *= 0.3f;
        g *= 0.5f;
    }

    /* The sky lights what is high and faces up, the sea what is low and faces down. The density
       falls towards the outside, so the cloud faces where -slope points. */
    const float high = clamp((place.y - base) / (3 * scale), 0, 1);
    const float faces_up = -slope.y / sqrtf(dot(slope, slope) + 0.01f);
    const float above = (0.32f + 0.45f * high) * (0.75f + 0.25f * faces_up);
    struct vector light = {0};
    light = add(light, sunlight, lit);
    light = add(light, skylight, above);
    return add(light, sealight, (1 - high) * (1 - faces_up));
}

/* density = the smooth union of the balls. Each is (r^2 - d^2) / 2r at a distance d from its
   centre: about r - d near its surface. */
static void add_balls(const struct cloud *cloud, struct batch *batch, int count)
{
    const struct scarp_samples all = samples(&batch->density), one = samples(&batch->other);
    for (int k = 0; k < BALLS; k++) {
        const struct ball ball = cloud->ball[k];
        const float bend = 1 / ball.radius;
        struct field *field = k == 0 ? &batch->density : &batch->other;
        for (int i = 0; i < count; i++) {
            const float x = batch->x[i] - ball.centre.x, y = batch->y[i] - ball.centre.y;
            const float z = batch->z[i] - ball.centre.z;
            field->value[i] = 0.5f * (ball.radius - bend * (x * x + y * y + z * z));
            field->dx[i] = -bend * x;
            field->dy[i] = -bend * y;
            field->dz[i] = -bend * z;
        }
        if (k > 0) {
            must(scarp_smooth_max((size_t)count, &all, &one, 0.25f * cloud->scale, &all));
        }
    }
}

/* density = smooth minimum of (density + noise) and (height above the base + some of the noise): it
   has billows on top, and is almost flat below. The noise is fBm of magnitudes (turbulence): they
   rise roundly from creases, as billows do. It is lowered, so that it adds as much as it takes. */
static void add_noise(const struct cloud *cloud, struct batch *batch, int count)
{
    const size_t n = (size_t)count;
    const struct scarp_samples density = samples(&batch->density), noise = samples(&batch->other);
    must(scarp_sample3(&cloud->noise, n, batch->x, batch->y, batch->z, &noise));
    must(scarp_affine(n, &noise, 1, -0.43f * cloud->scale, &noise));
    must(scarp_add(n, &density, &noise, &density));
    must(scarp_affine(n, &noise, 0.12f, -base, &noise));
    for (int i = 0; i < count; i++) {
        batch->other.value[i] += batch->y[i];
        batch->other.dy[i] += 1;
    }
    must(scarp_smooth_min(n, &density, &noise, 0.25f * cloud->scale, &density));
}

/* Adds what live ray i sees where it is, and takes it a step on. `chance` is in [0, 1). */
static void step_ray(const struct cloud *cloud, struct batch *batch, int i, float chance)
{
    const int ray = batch->live[i];
    const struct vector place = {batch->x[i], batch->y[i], batch->z[i]}, way = batch->way[ray];
    const struct vector slope = {batch->density.dx[i], batch->density.dy[i], batch->density.dz[i]};
    const float density = batch->density.value[i], scale = cloud->scale;

    /* Outside, the surface is about -density / |gradient| away. As this is a guess, steps are
       shorter. All of them vary by chance, from the first on, so that no slices show. */
    const float away = -0.6f * density / sqrtf(dot(slope, slope) + 0.01f);
    const float most = 0.1f * scale - 0.3f * density;
    const float length = clamp(away, 0.03f * scale, most) * (0.6f + 0.8f * chance);
    if (density > 0) {
        /* Edges are soft: the cloud becomes denser up to 0.3 inside. */
        const float dense = 60 * clamp(density / (0.3f * scale), 0, 1) / scale;
        const float part = (1 - batch->hidden[ray]) * (1 - fade(dense * length));
        const struct vector light = shade(cloud, place, way, density, slope);
        batch->colour[ray] = add(batch->colour[ray], haze(light, way, batch->t[ray]), part);
        batch->hidden[ray] += part;
    }
    batch->t[ray] += length;
}

/* Takes those of `count` rays that meet the bounds of a cloud through it. */
static void march(const struct cloud *cloud, struct batch *batch, int count, unsigned first)
{
    const struct vector from = add(camera, cloud->bounds.centre, -1);
    const float outside = dot(from, from) - cloud->bounds.radius * cloud->bounds.radius;
    int lives = 0;
    for (int i = 0; i < count; i++) {
        const float m = dot(from, batch->way[i]), hh = m * m - outside;
        if (hh > 0) {
            batch->t[i] = -m - sqrtf(hh);
            batch->end[i] = -m + sqrtf(hh);
            batch->live[lives++] = i;
        }
    }
    for (unsigned step = 0; step < STEPS; step++) {
        int n = 0;
        for (int i = 0; i < lives; i++) {
            const int ray = batch->live[i];
            if (batch->t[ray] < batch->end[ray] && batch->hidden[ray] < 0.99f) {
                const struct vector place = add(camera, batch->way[ray], batch->t[ray]);
                batch->live[n] = ray;
                batch->x[n] = place.x;
                batch->y[n] = place.y;
                batch->z[n++] = place.z;
            }
        }
        lives = n;
        if (n == 0) {
            return;
        }
        add_balls(cloud, batch, n);
        add_noise(cloud, batch, n);
        for (int i = 0; i < n; i++) {
            step_ray(cloud, batch, i, dice((first + (unsigned)batch->live[i]) * STEPS + step));
        }
    }
}

/* Makes a cloud of the size place.radius, turned and more or less tall. A pixel is `pixel` wide at
   a distance of 1. */
static void make_cloud(struct cloud *cloud, struct ball place, float turn, float tall, float pixel)
{
    static const struct ball shape[BALLS] = {
        {{-2.3f, 0.25f, 0}, 0.55f},      {{-1.5f, 0.5f, -0.2f}, 0.8f},
        {{-0.6f, 0.55f, -0.45f}, 0.95f}, {{0.4f, 0.6f, -0.4f}, 0.95f},
        {{1.3f, 0.45f, -0.1f}, 0.8f},    {{2.1f, 0.3f, 0.1f}, 0.6f},
        {{2.8f, 0.2f, 0.2f}, 0.45f},     {{-0.9f, 1.35f, 0.1f}, 0.85f},
        {{0.1f, 1.6f, 0.05f}, 0.95f},    {{0.95f, 1.3f, 0.25f}, 0.75f},
        {{-0.3f, 2.35f, 0.2f}, 0.85f},   {{0.45f, 2.5f, 0.25f}, 0.7f},
        {{-0.05f, 3.0f, 0.3f}, 0.6f},    {{-1.75f, 1.1f, 0.3f}, 0.5f}};
    const float scale = place.radius, side = sqrtf(1 - turn * turn);
    cloud->scale = scale;
    cloud->bounds = (struct ball){add(place.centre, (struct vector){0, 1.2f * tall, 0}, scale), 0};
    for (int i = 0; i < BALLS; i++) {
        const struct vector c = shape[i].centre;
        const struct vector way = {turn * c.x - side * c.z, tall * c.y, side * c.x + turn * c.z};
        const struct vector centre = add(place.centre, way, scale);
        const struct vector to = add(centre, cloud->bounds.centre, -1);
        /* The noise hardly ever makes a ball larger by more than 0.6. */
        const float reach = sqrtf(dot(to, to)) + (shape[i].radius + 0.6f) * scale;
        cloud->ball[i] = (struct ball){centre, shape[i].radius * scale};
        cloud->bounds.radius = reach > cloud->bounds.radius ? reach : cloud->bounds.radius;
    }
    cloud->noise = (struct scarp_noise){
        .fractal = SCARP_TURBULENCE,
        .rotate = 1,
        .seed = 11 + (uint64_t)(cloud - clouds),
        .frequency = 0.85 / (double)scale,
        .octaves = 1,
        .lacunarity = 2.02f,
        .gain = 0.46f,
        .amplitude = 1.5f * scale,
        .of_octaves = octaves,
    };
    /* Octaves are left out where their waves are shorter than two pixels. The others stay as they
       are, since of_octaves says how many they belong to. */
    const float two_pixels = 2 * pixel * place.centre.z;
    float wave = 1 / (float)cloud->noise.frequency;
    while (wave > two_pixels && cloud->noise.octaves < octaves) {
        cloud->noise.octaves++;
        wave /= cloud->noise.lacunarity;
    }
}

/* One cloud is in front; the others are scattered by chance, each further away than the last. */
static void make_clouds(float pixel)
{
    make_cloud(&clouds[0], (struct ball){{0.1f, base, 6.2f}, 1}, 1, 1, pixel);
    float distance = 11;
    for (unsigned k = 1; k < CLOUDS; k++) {
        const float x = 1.7f * distance * (dice(3 * k + 2) - 0.5f), size = dice(3 * k);
        const struct ball place = {{x, base, distance}, 0.5f + 0.6f * size};
        make_cloud(&clouds[k], place, 2 * dice(3 * k + 1) - 1, 0.3f + 0.5f * size, pixel);
        distance *= 1.09f;
    }
}

/* Makes rays that go from the camera through pixels, from number `first` on. */
static void aim(struct batch *batch, int rays, int width, int height, int first)
{
    const float unit = 2.0f / (float)(height * SIDE); /* the picture is 2 high, and `lens` away */
    for (int i = 0; i < rays; i++) {
        const int pixel = first + i / EACH;
        const float column = (float)(pixel % width * SIDE + i % SIDE) + 0.5f;
        const float row = (float)(pixel / width * SIDE + i % EACH / SIDE) + 0.5f;
        const float u = unit * column - (float)width / (float)height, v = 1 - unit * row;
        /* The camera looks up a little: 0.25 and 0.968 are sine and cosine. */
        const struct vector way = {u, 0.968f * v + 0.25f * lens, 0.968f * lens - 0.25f * v};
        batch->way[i] = add((struct vector){0}, way, 1 / sqrtf(dot(way, way)));
    }
}

/* A screen has no more than 1: bright light is compressed. */
static float compress(float light)
{
    return clamp(1.18f * light / (1 + 0.25f * light), 0, 1);
}

/* The byte for a light from 0 to 1: the root is what screens expect. It is rounded up or down by
   chance, so that the sky has no bands. */
static unsigned char byte(float light, float chance)
{
    return (unsigned char)(255 * sqrtf(light) + 0.99f * chance);
}

/* Draws `count` pixels from number `first` on. */
static void draw(unsigned char *rgb, int width, int height, int first, int count)
{
    struct batch *batch = calloc(1, sizeof *batch);
    if (batch == NULL) {
        fail(EXIT_FAILURE, "not enough memory");
    }
    aim(batch, count * EACH, width, height, first);
    for (int k = 0; k < CLOUDS; k++) {
        march(&clouds[k], batch, count * EACH, (unsigned)(first * EACH));
    }
    for (int i = 0; i < count; i++) {
        struct vector light = {0};
        for (int ray = i * EACH; ray < (i + 1) * EACH; ray++) {
            const struct vector behind = backdrop(batch->way[ray]);
            const struct vector all = add(batch->colour[ray], behind, 1 - batch->hidden[ray]);
            const struct vector shown = {compress(all.x), compress(all.y), compress(all.z)};
            light = add(light, shown, 1.0f / (float)EACH);
        }
        const float chance = dice((unsigned)(first + i));
        unsigned char *pixel = &rgb[3 * (size_t)(first + i)];
        pixel[0] = byte(light.x, chance);
        pixel[1] = byte(light.y, chance);
        pixel[2] = byte(light.z, chance);
    }
    free(batch);
}

static void choose_isa(const char *name)
{
    enum scarp_isa isa = SCARP_ISA_SCALAR;
    while (scarp_isa_name(isa) != NULL && strcmp(scarp_isa_name(isa), name) != 0) {
        isa++;
    }
    if (scarp_isa_select(isa) != SCARP_OK) {
        fail(2, "--isa: this instruction set cannot run here");
    }
}

/* Reads WIDTHxHEIGHT, each from 1 to 16384. Returns 0 if that is not what the text says. */
static int read_size(const char *text, long *width, long *height)
{
    char *end;
    *width = strtol(text, &end, 10);
    *height = *end == 'x' ? strtol(end + 1, &end, 10) : 0;
    return *end == '\0' && *width >= 1 && *width <= 16384 && *height >= 1 && *height <= 16384;
}

int main(int argc, char **argv)
{
    long width = 960, height = 540;
    const char *path = NULL;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--isa") == 0 && i + 1 < argc) {
            choose_isa(argv[++i]);
        } else if (argv[i][0] >= '0' && argv[i][0] <= '9') {
            if (!read_size(argv[i], &width, &height)) {
                fail(2, "the size must be WIDTHxHEIGHT, each from 1 to 16384");
            }
        } else if (argv[i][0] != '-' && path == NULL) {
            path = argv[i];
        } else {
            fail(2, "usage: cloud [--isa NAME] [WIDTHxHEIGHT] [FILE.ppm]");
        }
    }
    make_clouds(2 / (lens * (float)height));

    const int pixels = (int)(width * height), most = RAYS / EACH;
    unsigned char *rgb = malloc(3 * (size_t)pixels);
    if (rgb == NULL) {
        fail(EXIT_FAILURE, "not enough memory");
    }
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic)
#endif
    for (int first = 0; first < pixels; first += most) {
        draw(rgb, (int)width, (int)height, first, pixels - first < most ? pixels - first : most);
    }
    FILE *file = path != NULL ? fopen(path, "wb") : stdout;
    if (file == NULL || fprintf(file, "P6\n%ld %ld\n255\n", width, height) < 0 ||
        fwrite(rgb, 3, (size_t)pixels, file) != (size_t)pixels || fclose(file) != 0) {
        fail(EXIT_FAILURE, "cannot write the picture");
    }
    free(rgb);
    return EXIT_SUCCESS;
}
