/* SPDX-License-Identifier: MIT
 *
 * What a recipe is made of: the text, a tree of expressions, and the graph that they are compiled
 * to.
 *
 * All of it lies in the caller's struct scarp_recipe and refers to itself by indices, so that a
 * copy of the bytes is a recipe, too. An index is -1 where there is nothing.
 *
 *     text.c           words and names of the text, and errors in it
 *     parse.c          text -> statements; expressions.c, tokens.c, number.c: what is in these
 *     compile.c        statements -> nodes; values.c: expressions; functions.c: calls; members.c,
 *                      noises.c and places.c: noises and transforms; nodes.c: arithmetic
 *     graph.c          nodes, noises and places, equal ones once; interval.c: what nodes promise;
 *                      queries.c: what they read
 *     schedule.c       nodes -> steps and registers
 *     combine.c        the calls of functions that combine fields
 *     guards.c         what may be left out; skips.c: what bounds leave out of a chunk
 *     evaluate.c       steps over chunks of points; grids.c: over pieces of grids
 *     positions.c      one step of a node that has a place; coordinates.c: where that is;
 *                      operations.c: of another node; machine.c: where samples are
 *     plans.c          constants of noises that callers keep
 *     words.c          the functions and their arguments, for the compiler and for editors
 *     calls.c          the public functions; change.c: those that set something; describe.c: those
 *                      that editors ask, for which summary.c looks at nodes
 */
#ifndef SCARP_RECIPE_RECIPE_H
#define SCARP_RECIPE_RECIPE_H

#include <stdint.h>

#include "scarp.h"

enum {
    RECIPE_TEXT = 16384, /* bytes */
    RECIPE_EXPRESSIONS = 512,
    RECIPE_STATEMENTS = 96,
    RECIPE_OUTPUTS = 16,
    RECIPE_NODES = 256,
    RECIPE_NOISES = 48,
    RECIPE_GULLIES = 8,
    RECIPE_PLACES = 32,
    RECIPE_KNOTS = 128,
    RECIPE_GUARDS = 48,
    RECIPE_COPIES = 64,  /* of nodes that do not depend on all axes */
    RECIPE_ALL_AXES = 7, /* bits of x, y and z */
    RECIPE_NESTING = 24, /* of parentheses and signs in the text */
    RECIPE_DEPTH = 40,   /* of expressions, through names */
    RECIPE_FRAMES = 3    /* of frames in each other */
};

enum recipe_expression_type {
    EXPRESSION_NUMBER,
    EXPRESSION_NAME,
    EXPRESSION_CALL,
    EXPRESSION_KNOT,
    EXPRESSION_ADD,
    EXPRESSION_SUBTRACT,
    EXPRESSION_MULTIPLY,
    EXPRESSION_DIVIDE,
    EXPRESSION_NEGATIVE,
    EXPRESSION_POWER
};

/* Bytes of the text, `to` excluded. */
struct recipe_span {
    uint16_t from, to;
};

/* What was written. Expressions stand behind those that they contain, but for calls and signs,
   which stand in front. */
struct recipe_expression {
    double number; /* of numbers, and of expressions that are folded to one */
    struct recipe_span span;
    struct recipe_span name;     /* of a name, or of the function that is called */
    struct recipe_span argument; /* the name that it has as an argument; empty: none */
    int16_t a, b;                /* operands; of a call: the first argument */
    int16_t next;                /* the next argument of the same call */
    int16_t parent;              /* the expression around it */
    int16_t node;                /* what it is where nothing is transformed */
    uint8_t type, exponent;
    uint8_t kind; /* enum scarp_recipe_kind */
};

enum recipe_statement_type { STATEMENT_PARAM, STATEMENT_FIELD };

struct recipe_statement {
    double value, lowest, highest; /* of a param */
    struct recipe_span span, name;
    int16_t expression;
    uint8_t type, is_output;
};

/* What a noise is: struct scarp_noise up to its pointers, and the index of its warp. */
struct recipe_noise {
    unsigned char noise[80];
    int16_t warp;
};

/*
 * A place is where an expression looks: u = m x + t + rest along each of its axes. x are the
 * coordinates of the frame: those of the points, or of another place. Derivatives of what looks
 * there are by the coordinates of the frame.
 */
struct recipe_place {
    double m[3][3], t[3];
    int16_t rest[3]; /* fields */
    int16_t frame;   /* the place whose u are x here; -1: points */
    int16_t warp,
        before; /* the place `before`, displaced by a noise, which the library does if it can */
    uint8_t dimensions; /* of u */
};

#define OPERATOR(NAME, ...) OP_##NAME,
#define FUNCTION(NAME, ...) OP_##NAME,
enum recipe_operation {
    OP_CONSTANT,   /* k[0] */
    OP_COORDINATE, /* number `detail` of the place */
    OP_NOISE,      /* at the place */
    OP_VECTOR,     /* component 0 of vector noise, whose step computes the others, too */
    OP_COMPONENT,  /* number `detail`; in[0] is the OP_VECTOR */
    OP_CELL,       /* `detail`: 0 the id, 1 or 2 a distance */
    OP_GULLIES,    /* the displacement; in[0] is the base */
    OP_PULL,       /* in[0] with derivatives with respect to the frame of the place, not to its u */
/* These combine in[0] to in[2]. */
#include "../plan/functions.def"
    OP_COUNT
};

/* An interval; every value is inside. */
struct recipe_interval {
    float lowest, highest;
};

/* What is computed. Nodes stand behind those that they read. */
struct recipe_node {
    int16_t in[3];
    int16_t place;
    int16_t index; /* of a noise, of gullies, or of the first knot */
    uint8_t operation, detail;
    uint8_t knots;
    uint8_t axes;       /* on which it depends: 1 x, 2 y, 4 z, of the points */
    uint8_t dimensions; /* of its derivatives */
    uint8_t order;      /* the highest one of its derivatives */
    float k[3];
    struct recipe_interval interval;
};

/* What leaves the operand of a gate out */
enum recipe_guard_kind {
    GUARD_BY_0,     /* the mask, where it is 0 at all points of a chunk, without slopes */
    GUARD_BY_1,     /* likewise where it is 1 */
    GUARD_BY_BOUNDS /* of the operands in the chunk: skips.h */
};

/* What may be left out: nodes that are needed for one operand of a gate alone. */
struct recipe_guard {
    int16_t gate, mask; /* mask: -1 if there is none */
    uint8_t operand;    /* of the gate */
    uint8_t parent;     /* the guard of the gate; 0: none */
    uint8_t kind;
    uint8_t first; /* step */
};

/* A node as steps read it that depend on more axes than it does. */
struct recipe_copy {
    uint8_t node, axes, in_register;
};

/*
 * How some nodes are computed. On grids, steps that depend on the same axes run together: on a
 * plane, on a line, or at a point, if they do not depend on all. Axes are added bits, as those of
 * nodes.
 */
struct recipe_schedule {
    int16_t steps, registers;
    int16_t first_of[RECIPE_ALL_AXES + 2]; /* the first step that depends on these axes, or more */
    uint8_t all_axes;                      /* of the recipe */
    uint8_t guards, copies;
    uint8_t extra; /* the highest order of a register is this much above that of the outputs */
    uint8_t step[RECIPE_NODES];        /* nodes */
    uint8_t axes_of[RECIPE_NODES];     /* by node: those of its step */
    uint8_t register_of[RECIPE_NODES]; /* by node */
    uint8_t extra_of[RECIPE_NODES];    /* how much its order is above that of the outputs */
    uint8_t guard_of[RECIPE_NODES];    /* from 1; 0: none */
    /* The root, from 1, in whose arrays a node may be computed: the root itself if no step reads
       it, and those that are overwritten one by one on the way to it; 0: none */
    uint8_t home_of[RECIPE_NODES];
    struct recipe_guard guard[RECIPE_GUARDS + 1];
    struct recipe_copy copy[RECIPE_COPIES];
};

struct __attribute__((may_alias)) recipe {
    uint64_t version; /* of this structure, and whether there is a recipe: RECIPE_VERSION */
    uint64_t seed;
    double finest, tile[3];
    double scale[2]; /* of all places, and of the values of the first output */
    int16_t length;  /* of the text */
    int16_t expressions, statements, outputs, nodes, noises, gullies, places, knots;
    int16_t output[RECIPE_OUTPUTS]; /* statements */
    uint8_t dimensions, is_tiled;
    uint8_t is_bad; /* has errors */
    struct recipe_schedule schedule;
    struct recipe_statement statement[RECIPE_STATEMENTS];
    struct recipe_expression expression[RECIPE_EXPRESSIONS];
    struct recipe_node node[RECIPE_NODES];
    struct recipe_noise noise[RECIPE_NOISES];
    struct recipe_place place[RECIPE_PLACES];
    struct scarp_gullies gully[RECIPE_GULLIES];
    float knot[RECIPE_KNOTS][2]; /* x, value */
    char text[RECIPE_TEXT + 8];  /* with zeros behind it */
};

#define RECIPE_VERSION 0x7363617270723031u

_Static_assert(sizeof(struct recipe) <= sizeof(struct scarp_recipe),
               "a recipe fits into what callers have for it");

static inline struct recipe *scarpi_recipe_inside(struct scarp_recipe *recipe)
{
    return (struct recipe *)recipe;
}

static inline const struct recipe *scarpi_recipe_of(const struct scarp_recipe *recipe)
{
    return (const struct recipe *)recipe;
}

static inline int scarpi_is_recipe(const struct scarp_recipe *recipe)
{
    return recipe != NULL && scarpi_recipe_of(recipe)->version == RECIPE_VERSION;
}

#endif
