/* SPDX-License-Identifier: MIT
 *
 * The form of inputs of the fuzz target of recipes, for what writes such inputs.
 */
#ifndef SCARP_TESTS_FUZZ_RECIPE_H
#define SCARP_TESTS_FUZZ_RECIPE_H

/* Before the text of a recipe: how it is sampled, and what its parameters become */
enum recipe_header {
    HEADER_ORDER, /* of derivatives, modulo 3; bit 7: no scratch memory; 5: no plan; 4: a plan of an
                      input before */
    HEADER_WHICH, /* 0: the outputs; up to 127 a statement; else a part */
    HEADER_PLACE, /* origin, and what scratch memory lacks */
    HEADER_STEP,  /* the low bits; from 128 on coordinates that are not finite are among them */
    HEADER_SHADER,  /* odd: a shader, whose language and order follow; from 192 on its answers */
    HEADER_SETTING, /* of parameters, as a part of their intervals */
    HEADER_SIZE
};

/* What inputs were: texts, those without an error, and calls that gave samples */
struct recipe_counts {
    long parsed, read_well, sampled;
};
extern struct recipe_counts recipe_counts;

#endif
