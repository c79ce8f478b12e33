/* SPDX-License-Identifier: MIT
 *
 * Arguments of public calls, made of the bytes of an input, and what holds of every call for
 * points:
 *
 * - all kernel sets give the same status and the same bits;
 * - on an error no output is touched, and on success nothing behind the points;
 * - cutting the points in two, or asking for fewer outputs, changes no bit;
 * - nor does it if an output is one of the inputs.
 */
#ifndef SCARP_TESTS_ARGUMENTS_H
#define SCARP_TESTS_ARGUMENTS_H

#include "draw.h"
#include "scarp.h"

#define FUZZ_POINTS 80  /* of a call, at most */
#define FUZZ_ROOM 768   /* numbers of an output array: there is room behind the points */
#define FUZZ_MEMBERS 16 /* pointers of each structure of outputs */
#define FUZZ_OUTPUTS (3 * FUZZ_MEMBERS)

/* A hash of all statuses and results since the start, the same on every machine. */
extern uint64_t fuzz_digest;

void fuzz_note(uint64_t number);

/* How many calls fuzz_check has made, by the reference, and how many of them gave results. */
extern long fuzz_calls, fuzz_served;

/* What the message says then: the number of the case, or -1; the noise, or the text of a recipe, or
   NULL. */
extern long fuzz_case;
extern const struct scarp_noise *fuzz_case_noise;
extern const char *fuzz_case_text;

/* Ends the program if a promise is broken. */
#define fuzz_must(condition) ((condition) ? (void)0 : fuzz_broken(__FILE__, __LINE__, #condition))
_Noreturn void fuzz_broken(const char *file, int line, const char *condition);

#define FUZZ_LEVELS 6

/* A noise and its warps, one behind another. One in eight may be wrong, and has any numbers; the
   rest is mostly right. */
struct fuzz_noise {
    struct scarp_noise level[FUZZ_LEVELS];
};

void fuzz_draw_noise(struct draw *d, int dimensions, struct fuzz_noise *noise);

/* Coordinates of `count` points, once as floats: where they are doubles, floats are these, rounded.
 */
struct fuzz_points {
    size_t count;
    float f[3][FUZZ_POINTS];
    double d[3][FUZZ_POINTS];
};

void fuzz_draw_points(struct draw *d, struct fuzz_points *points);

/* Whether coordinates of point i are finite, and less than 2^40 in magnitude: floats if `doubles`
   is 0. */
int fuzz_point_is_near(const struct fuzz_points *points, size_t i, int dimensions, int doubles);

/* A grid that mostly is right, in the plane with one slice. Its samples, with what is between the
 * rows, fit into FUZZ_ROOM. */
void fuzz_draw_grid(struct draw *d, int dimensions, struct scarp_grid *grid);

/* Where the samples of a grid lie, and which element each is */
struct fuzz_places {
    size_t count, element[FUZZ_ROOM];
    double position[3][FUZZ_ROOM];
};

void fuzz_find_places(const struct scarp_grid *grid, struct fuzz_places *places);

/* Outputs as a structure of the public header: each has FUZZ_MEMBERS pointers, and nothing else. */
#define FUZZ_AS(type, pointers) ((const struct type *)fuzz_as(&(struct type){0}, pointers))
const void *fuzz_as(void *structure, float *const *pointers);

/* Calls the library for points from `first` to before first + count. `out` are the arrays of
   outputs, from the first of these points on, NULL where none is asked for. */
struct fuzz_call {
    enum scarp_status (*make)(const struct fuzz_call *call, size_t first, size_t count,
                              float *const out[FUZZ_OUTPUTS]);
    const void *arguments;

    size_t count;
    uint64_t mask;     /* the outputs asked for, by bits */
    uint64_t integers; /* those of them that are no floats */
    int is_grid;       /* the points cannot be cut in two */

    /* arrays of floats that the call reads, and NULL behind them: outputs may be one of these. The
       arrays have FUZZ_ROOM numbers, as outputs have. */
    float **inputs[40];
};

/* Results of the last call of fuzz_check, by the reference */
extern float fuzz_result[FUZZ_OUTPUTS][FUZZ_ROOM];

/* Makes the call, with all that holds of it, and returns its status. */
enum scarp_status fuzz_check(struct draw *d, const struct fuzz_call *call);

/* After a call on a grid: the call for points, at the places of the grid, must give what the
   elements have. What is between the rows must be untouched. */
void fuzz_check_places(const struct fuzz_call *of_points, const struct fuzz_places *places);

/* Makes the call for the best set only: whether it gives fuzz_result. */
int fuzz_same(const struct fuzz_call *call);

int fuzz_is_nan(float number);
int fuzz_is_finite(float number);
int fuzz_equal(float a, float b); /* to the bit, but that all NaNs are equal */

/* What each input is given to */
void fuzz_samples(const uint8_t *bytes, size_t size);
void fuzz_vectors(const uint8_t *bytes, size_t size);
void fuzz_chain(const uint8_t *bytes, size_t size);
void fuzz_gullies(const uint8_t *bytes, size_t size);
void fuzz_shaders(const uint8_t *bytes, size_t size);
void fuzz_compositions(const uint8_t *bytes, size_t size);

#endif
