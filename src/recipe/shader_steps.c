/* SPDX-License-Identifier: MIT
 *
 * The steps of a recipe as lines of a shader: node 7 is the variable r7. Nodes that a mask may hide
 * stand in an `if`, and have variables above all steps; where they are left out these are 0.
 */
#include <stdbool.h>
#include <string.h>

#include "evaluate.h"
#include "graph.h"
#include "schedule.h"
#include "shader.h"

/* The dimensions that derivatives of a place are by. */
static int frame_of(const struct recipe *r, int place)
{
    return scarpi_recipe_frame_dimensions(r, r->place[place].frame);
}

static int has_rest(const struct recipe_place *p)
{
    int has = 0;
    for (int i = 0; i < p->dimensions; i++) {
        has |= p->rest[i] >= 0;
    }
    return has;
}

/* What displaces a place, as samples. */
static void put_rest(const struct shader_writer *w, int place)
{
    const struct recipe_place *const p = &w->recipe->place[place];
    if (!has_rest(p)) {
        scarpi_shader_put(w->to, "scarp_not_displaced()");
        return;
    }
    scarpi_shader_put(w->to, "scarp_displaced_of(");
    for (int i = 0; i < 3; i++) {
        scarpi_shader_put(w->to, i > 0 ? ", " : "");
        if (i < p->dimensions && p->rest[i] >= 0) {
            scarpi_shader_put(w->to, "r%d", p->rest[i]);
        } else {
            scarpi_shader_put(w->to, "scarp_constant(0.0)");
        }
    }
    scarpi_shader_put(w->to, ")");
}

static void put_rows(const struct shader_writer *w, int place)
{
    const int first = w->slots->place_of[place];
    scarpi_shader_put(w->to, "scarp_own_number(%du), scarp_own_number(%du), scarp_own_number(%du)",
                      first, first + 1, first + 2);
}

/* The coordinates of a place: those of its frame, transformed. Frames are three deep at most. */
static void put_position(const struct shader_writer *w, int place)
{
    int chain[RECIPE_FRAMES + 2], depth = 0;
    for (int p = place; p > 0 && depth < RECIPE_FRAMES + 2; p = w->recipe->place[p].frame) {
        chain[depth++] = p;
    }
    for (int i = 0; i < depth; i++) {
        const int rests = has_rest(&w->recipe->place[chain[i]]);
        scarpi_shader_put(w->to, rests ? "scarp_add3(scarp_placed(" : "scarp_placed(");
    }
    scarpi_shader_put(w->to, "at");
    while (depth-- > 0) {
        const int p = chain[depth];
        scarpi_shader_put(w->to, ", ");
        put_rows(w, p);
        scarpi_shader_put(w->to, ", %d)", frame_of(w->recipe, p));
        if (has_rest(&w->recipe->place[p])) {
            scarpi_shader_put(w->to, ", scarp_values_of(");
            put_rest(w, p);
            scarpi_shader_put(w->to, "))");
        }
    }
}

/* What stands around a sample whose derivatives are by the coordinates of a place. */
static void put_pull(const struct shader_writer *w, int place)
{
    scarpi_shader_put(w->to, scarpi_recipe_is_frame(w->recipe, place) ? "" : "scarp_pulled(");
}

static void put_pulled(const struct shader_writer *w, int place)
{
    if (scarpi_recipe_is_frame(w->recipe, place)) {
        return;
    }
    scarpi_shader_put(w->to, ", scarp_jacobian_with(");
    put_rows(w, place);
    scarpi_shader_put(w->to, ", ");
    put_rest(w, place);
    scarpi_shader_put(w->to, "), ");
    put_rest(w, place);
    scarpi_shader_put(w->to, ", %d)", w->recipe->place[place].dimensions);
}

/* The guard of a node that an `if` is for; 0: none. */
static int guard_of(const struct shader_writer *w, int node)
{
    const struct recipe_schedule *const s = &w->recipe->schedule;
    return scarpi_recipe_mask_guard(s, s->guard_of[node]);
}

/* Begins the line that gives a node its value, a sample r, or all components of vector noise, v.
   Nodes within an `if` have a variable. */
static void put_variable(const struct shader_writer *w, int node, char letter)
{
    const int is_guarded = guard_of(w, node) != 0, is_sample = letter == 'r';
    scarpi_shader_put(w->to,
                      is_guarded  ? (is_sample ? "        r%d = " : "        v%d = ")
                      : is_sample ? "    %LScarpSample r%d = "
                                  : "    %LScarpDisplaced v%d = ",
                      node);
}

static const char *indent_of(const struct shader_writer *w, int node)
{
    return guard_of(w, node) != 0 ? "        " : "    ";
}

/* Whether two nodes look at the same place through the same warp. */
static int is_warped_alike(const struct recipe *r, int a, int b)
{
    const struct recipe_node *const m = &r->node[a], *const n = &r->node[b];
    return m->place == n->place && r->noise[m->index].warp == r->noise[n->index].warp;
}

/* The displacements of a noise with warps, from the deepest one: the variable y of a node, and u,
   where it looks. Returns the node that has them, which may be an earlier one, or -1. */
static int put_warps(struct shader_writer *w, int node, const struct scarp_noise noise[5])
{
    const struct recipe_node *const n = &w->recipe->node[node];
    const int level = w->slots->level_of[node], dimensions = w->recipe->place[n->place].dimensions;
    const char *const indent = indent_of(w, node);
    int depth = 0;
    while (noise[depth].warp != NULL) {
        depth++;
    }
    if (depth > 0 && w->warped >= 0 && is_warped_alike(w->recipe, w->warped, node)) {
        return w->warped;
    }
    scarpi_shader_put(w->to, "%s%L%V u%d = ", indent, node);
    put_position(w, n->place);
    scarpi_shader_put(w->to, ";\n");
    for (int i = depth; i > 0; i--) {
        const int kind = scarpi_shader_kind(w, &noise[i], dimensions);
        if (i == depth) {
            scarpi_shader_put(w->to, "%s%XScarpDisplaced y%d = ", indent, node);
            scarpi_shader_put(w->to, "scarp_positions_of(scarp_own_warp%d(%du, u%d));\n", kind,
                              level + i, node);
            continue;
        }
        scarpi_shader_put(w->to, "%sy%d = scarp_positions_of(scarp_composed_each(", indent, node);
        scarpi_shader_put(w->to, "scarp_own_warp%d(%du, scarp_add3(u%d, scarp_values_of(y%d)))",
                          kind, level + i, node, node);
        scarpi_shader_put(w->to, ", y%d, %d));\n", node, dimensions);
    }
    w->warped = depth > 0 ? node : w->warped;
    return depth > 0 ? node : -1;
}

/* Level 0, which looks at u, or at what warps made of it, which `warped` has. */
static void put_level(struct shader_writer *w, int node, const struct scarp_noise noise[5],
                      int warped)
{
    const struct recipe_node *const n = &w->recipe->node[node];
    const int dimensions = w->recipe->place[n->place].dimensions;
    const int kind = scarpi_shader_kind(w, &noise[0], dimensions);
    const int is_vector = n->operation == OP_VECTOR;
    if (warped >= 0) {
        scarpi_shader_put(w->to, is_vector ? "scarp_composed_each(" : "scarp_composed(");
    }
    scarpi_shader_put(w->to, is_vector ? "scarp_own_warp%d(%du, " : "scarp_own_kind%d(%du, 0u, ",
                      kind, w->slots->level_of[node]);
    if (warped >= 0) {
        scarpi_shader_put(w->to, "scarp_add3(u%d, scarp_values_of(y%d))), y%d, %d)", warped, warped,
                          warped, dimensions);
    } else {
        scarpi_shader_put(w->to, "u%d)", node);
    }
}

static void put_noise(struct shader_writer *w, int node)
{
    const struct recipe_node *const n = &w->recipe->node[node];
    struct scarp_noise noise[5];
    scarpi_recipe_spell_noise(w->recipe, n->index, noise);
    const int warped = put_warps(w, node, noise);
    put_variable(w, node, 'r');
    put_pull(w, n->place);
    put_level(w, node, noise, warped);
    put_pulled(w, n->place);
    scarpi_shader_put(w->to, ";\n");
}

/* A component of vector noise whose variable is v. */
static void put_component(struct shader_writer *w, int node, int vector, int component)
{
    const int place = w->recipe->node[vector].place;
    static const char *const axis[] = {"x", "y", "z"};
    put_variable(w, node, 'r');
    put_pull(w, place);
    scarpi_shader_put(w->to, "v%d.%s", vector, axis[component]);
    put_pulled(w, place);
    scarpi_shader_put(w->to, ";\n");
}

static void put_vector(struct shader_writer *w, int node)
{
    struct scarp_noise noise[5];
    scarpi_recipe_spell_noise(w->recipe, w->recipe->node[node].index, noise);
    const int warped = put_warps(w, node, noise);
    put_variable(w, node, 'v');
    put_level(w, node, noise, warped);
    scarpi_shader_put(w->to, ";\n");
    put_component(w, node, node, 0);
}

static void put_cell(struct shader_writer *w, int node)
{
    const struct recipe_node *const n = &w->recipe->node[node];
    const int dimensions = w->recipe->place[n->place].dimensions;
    const char *const indent = indent_of(w, node);
    const int octave = w->slots->level_of[node];
    scarpi_shader_put(w->to, "%s%L%V u%d = ", indent, node);
    put_position(w, n->place);
    scarpi_shader_put(w->to, ";\n%s%LScarpOctave o%d = ", indent, node);
    scarpi_shader_put(w->to, "scarp_own_octave(scarp_own_level(%du).first);\n", octave);
    put_variable(w, node, 'r');
    put_pull(w, n->detail == 0 ? 0 : n->place);
    scarpi_shader_put(w->to,
                      "scarp_cell_sample(scarp_cells_around(o%d, scarp_location_of(o%d, 3u, false, "
                      "u%d, %d), o%d.inverse, u%d, %d), %d)",
                      node, node, node, dimensions, node, node, dimensions, n->detail);
    if (n->detail != 0) {
        put_pulled(w, n->place);
    }
    scarpi_shader_put(w->to, ";\n");
}

static void put_gullies(struct shader_writer *w, int node)
{
    const struct recipe_node *const n = &w->recipe->node[node];
    const struct scarp_gullies *const g = &w->recipe->gully[n->index];
    const int first = w->slots->number_of[node];
    const char *const in = indent_of(w, node);
    scarpi_shader_put(w->to, "%s%L%V u%d = ", in, node);
    put_position(w, n->place);
    scarpi_shader_put(w->to, ";\n%s%LScarpLevel l%d = scarp_own_level(%du);\n", in, node,
                      w->slots->level_of[node]);
    scarpi_shader_put(w->to, "%s%LScarpGullyShape g%d = scarp_gully_shape_of(", in, node);
    scarpi_shader_put(w->to,
                      "scarp_own_number(%du), scarp_own_number(%du), scarp_own_number(%du));\n",
                      first, first + 1, first + 2);
    scarpi_shader_put(w->to, "%s%XScarpGully s%d = ", in, node);
    scarpi_shader_put(w->to, "scarp_gully_first(g%d, scarp_own_number(%du), r%d);\n", node,
                      first + 2, n->in[0]);
    scarpi_shader_put(w->to, "%sfor (%Xuint k = 0u; k < l%d.octaves; k++) {\n", in, node);
    scarpi_shader_put(
        w->to,
        "%s    s%d = scarp_gully_with(s%d, g%d, scarp_own_octave(l%d.first + k), l%d, "
        "%s, u%d);\n%s}\n",
        in, node, node, node, node, node, g->rotate ? "k > 0u" : "false", node, in);
    put_variable(w, node, 'r');
    scarpi_shader_put(w->to,
                      "scarp_gully_displacement(s%d, scarp_own_number(%du).x, "
                      "scarp_own_number(%du).y);\n",
                      node, first + 3, first + 3);
}

static void put_coordinate(const struct shader_writer *w, int node)
{
    static const char *const axis[] = {"x", "y", "z"};
    static const char *const row[] = {"1.0, 0.0, 0.0, 0.0", "0.0, 1.0, 0.0, 0.0",
                                      "0.0, 0.0, 1.0, 0.0"};
    const struct recipe_node *const n = &w->recipe->node[node];
    const struct recipe_place *const p = &w->recipe->place[n->place];
    const int rest = p->rest[n->detail];
    const char *const in = indent_of(w, node);
    scarpi_shader_put(w->to, "%s%L%V u%d = ", in, node);
    put_position(w, n->place);
    scarpi_shader_put(w->to, ";\n");
    put_variable(w, node, 'r');
    scarpi_shader_put(w->to, "scarp_coordinate_of(u%d.%s, ", node, axis[n->detail]);
    if (n->place == 0) {
        scarpi_shader_put(w->to, "%4(%s), ", row[n->detail]);
    } else {
        scarpi_shader_put(w->to, "scarp_own_number(%du), ",
                          w->slots->place_of[n->place] + n->detail);
    }
    if (rest >= 0) {
        scarpi_shader_put(w->to, "r%d);\n", rest);
    } else {
        scarpi_shader_put(w->to, "scarp_constant(0.0));\n");
    }
}

/* A curve looks for the knots around a. */
static void put_curve(const struct shader_writer *w, int node)
{
    const struct recipe_node *const n = &w->recipe->node[node];
    const int first = w->slots->number_of[node], last = first + n->knots - 1;
    const char *const in = indent_of(w, node);
    scarpi_shader_put(w->to, "%s%Xuint k%d = %du;\n", in, node, first);
    scarpi_shader_put(w->to, "%sfor (%Xuint i = %du; i < %du; i++) {\n", in, first + 1, last);
    scarpi_shader_put(w->to, "%s    if (r%d.value >= scarp_own_number(i).x) {\n", in, n->in[0]);
    scarpi_shader_put(w->to, "%s        k%d = i;\n%s    }\n%s}\n", in, node, in, in);
    put_variable(w, node, 'r');
    scarpi_shader_put(w->to,
                      "scarp_chain_curve(r%d, scarp_own_number(k%d), scarp_own_number(k%d + 1u), "
                      "scarp_own_number(%du), scarp_own_number(%du));\n",
                      n->in[0], node, node, first, last);
}

/* Functions of one or two samples and some numbers: the calls of plan/functions.def. */
static void put_call(const struct shader_writer *w, int node)
{
#define OPERATOR(NAME, name, FORM, COMPUTED, take, traits, range, shader, ...)                     \
    [OP_##NAME] = "scarp_" #shader,
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
    static const char *const call[OP_COUNT] = {
        [OP_CONSTANT] = "scarp_constant(k.x)",
#include "../plan/functions.def"
    };
    const struct recipe_node *const n = &w->recipe->node[node];
    put_variable(w, node, 'r');
    char before = '\0';
    for (const char *c = call[n->operation]; *c != '\0'; before = *c++) {
        const int is_argument =
            (before == '(' || before == ' ') && (c[1] == ',' || c[1] == ')' || c[1] == '.');
        if (!is_argument) {
            scarpi_shader_put_span(w->to, c, 1);
        } else if (*c == 'k') {
            scarpi_shader_put(w->to, "scarp_own_number(%du)", w->slots->number_of[node]);
            c += strncmp(c + 1, ".xyzw", 5) == 0 ? 5 : 0; /* which is all of it */
        } else if (*c == 'd') {
            scarpi_shader_put(w->to, "%d", w->recipe->node[n->in[0]].dimensions);
        } else {
            scarpi_shader_put(w->to, "r%d", n->in[*c == 'a' ? 0 : *c == 'b' ? 1 : 2]);
        }
    }
    scarpi_shader_put(w->to, ";\n");
}

static void put_step(struct shader_writer *w, int node)
{
    const struct recipe_node *const n = &w->recipe->node[node];
    switch (n->operation) {
    case OP_COORDINATE: put_coordinate(w, node); break;
    case OP_NOISE: put_noise(w, node); break;
    case OP_VECTOR: put_vector(w, node); break;
    case OP_COMPONENT: put_component(w, node, n->in[0], n->detail); break;
    case OP_CELL: put_cell(w, node); break;
    case OP_GULLIES: put_gullies(w, node); break;
    case OP_PULL:
        put_variable(w, node, 'r');
        put_pull(w, n->place);
        scarpi_shader_put(w->to, "r%d", n->in[0]);
        put_pulled(w, n->place);
        scarpi_shader_put(w->to, ";\n");
        break;
    case OP_CURVE: put_curve(w, node); break;
    default: put_call(w, node); break;
    }
}

/* Variables of nodes that stand in an `if` */
static void put_variables(const struct shader_writer *w)
{
    const struct recipe_schedule *const s = &w->recipe->schedule;
    for (int k = 0; k < s->steps; k++) {
        const int node = s->step[k];
        if (guard_of(w, node) == 0) {
            continue;
        }
        scarpi_shader_put(w->to, "    %XScarpSample r%d = scarp_constant(0.0);\n", node);
        if (w->recipe->node[node].operation == OP_VECTOR) {
            scarpi_shader_put(w->to, "    %XScarpDisplaced v%d = scarp_not_displaced();\n", node);
        }
    }
}

/* Whether a guard is open, in front of the first step that it leaves out: there its mask is known,
   and those of the guards around it, which may be computed later than its own. The order of the
   gate says which derivatives of the mask count. */
static void put_guard(const struct shader_writer *w, int guard, bool is_put[RECIPE_GUARDS + 1])
{
    const struct recipe_guard *const g = &w->recipe->schedule.guard[guard];
    if (guard == 0 || is_put[guard]) {
        return;
    }
    const int parent = scarpi_recipe_mask_guard(&w->recipe->schedule, g->parent);
    put_guard(w, parent, is_put);
    is_put[guard] = true;
    scarpi_shader_put(w->to, "    open%d = ", guard);
    if (parent != 0) {
        scarpi_shader_put(w->to, "open%d && ", parent);
    }
    scarpi_shader_put(w->to, "!scarp_is_level(r%d, %s, %d, %d);\n", g->mask,
                      g->kind == GUARD_BY_1 ? "1.0" : "0.0", w->order_of[g->gate],
                      w->recipe->node[g->mask].dimensions);
}

void scarpi_shader_put_steps(struct shader_writer *w)
{
    const struct recipe *const r = w->recipe;
    const struct recipe_schedule *const s = &r->schedule;
    const int is_space = r->dimensions == 3;
    bool is_put[RECIPE_GUARDS + 1] = {false};
    int open = 0;
    w->warped = -1;
    scarpi_shader_put(w->to, "    %L%V at = %s(x, y, %s);\n",
                      w->to->language == SCARP_WGSL ? "vec3f" : "scarp_vec3_of",
                      is_space ? "z" : "0.0");
    for (int i = 1; i <= s->guards; i++) {
        if (s->guard[i].kind != GUARD_BY_BOUNDS) {
            scarpi_shader_put(w->to, "    %Xbool open%d = false;\n", i);
        }
    }
    put_variables(w);
    for (int k = 0; k < s->steps; k++) {
        const int node = s->step[k];
        if (guard_of(w, node) != open) {
            scarpi_shader_put(w->to, open != 0 ? "    }\n" : "");
            open = guard_of(w, node);
            w->warped = -1; /* its variables end with their block */
            if (open != 0) {
                put_guard(w, open, is_put);
                scarpi_shader_put(w->to, "    if (open%d) {\n", open);
            }
        }
        put_step(w, node);
    }
    scarpi_shader_put(w->to, open != 0 ? "    }\n" : "");
    scarpi_shader_put(w->to, w->to->language == SCARP_WGSL ? "    var all: ScarpRecipe;\n"
                                                           : "    ScarpRecipe all;\n");
    for (int i = 0; i < r->outputs; i++) {
        scarpi_shader_put(w->to, "    all.out%d = r%d;\n", i, scarpi_recipe_output_node(r, i));
    }
    scarpi_shader_put(w->to, "    return all;\n");
}
