/* SPDX-License-Identifier: MIT
 *
 * What readers of functions.def have in common.
 */
#ifndef SCARP_FUNCTIONS_H
#define SCARP_FUNCTIONS_H

/* Calls by their forms: in[0] to in[2] point to the inputs, k[0] to k[2] are the numbers. */
#define FORM_ONE_0(function, count, in, k, out) function(count, (in)[0], out)
#define FORM_ONE_1(function, count, in, k, out) function(count, (in)[0], (k)[0], out)
#define FORM_ONE_2(function, count, in, k, out) function(count, (in)[0], (k)[0], (k)[1], out)
#define FORM_ONE_3(function, count, in, k, out)                                                    \
    function(count, (in)[0], (k)[0], (k)[1], (k)[2], out)
#define FORM_TWO_0(function, count, in, k, out) function(count, (in)[0], (in)[1], out)
#define FORM_TWO_1(function, count, in, k, out) function(count, (in)[0], (in)[1], (k)[0], out)
#define FORM_THREE_0(function, count, in, k, out) function(count, (in)[0], (in)[1], (in)[2], out)

/* How many inputs and numbers each has. */
enum {
    INPUTS_OF_ONE_0 = 1,
    INPUTS_OF_ONE_1 = 1,
    INPUTS_OF_ONE_2 = 1,
    INPUTS_OF_ONE_3 = 1,
    INPUTS_OF_TWO_0 = 2,
    INPUTS_OF_TWO_1 = 2,
    INPUTS_OF_THREE_0 = 3,
    INPUTS_OF_CURVE = 1
};

/* Text for forms that have numbers. */
#define IF_NUMBERS_ONE_0(...)
#define IF_NUMBERS_ONE_1(...) __VA_ARGS__
#define IF_NUMBERS_ONE_2(...) __VA_ARGS__
#define IF_NUMBERS_ONE_3(...) __VA_ARGS__
#define IF_NUMBERS_TWO_0(...)
#define IF_NUMBERS_TWO_1(...) __VA_ARGS__
#define IF_NUMBERS_THREE_0(...)
#define IF_NUMBERS_CURVE(...)

/* Text for what kernels compute; of that, for what they compute by partial derivatives of one
   input, or of two; and for what is plain C. */
#define IF_KERNEL_LOOPS(...) __VA_ARGS__
#define IF_KERNEL_BENT(...) __VA_ARGS__
#define IF_KERNEL_STRAIGHT(...) __VA_ARGS__
#define IF_KERNEL_SMOOTH(...) __VA_ARGS__
#define IF_KERNEL_PLAIN(...)
#define IF_KERNEL_OWN(...)

#define IF_ONE_LOOPS(...)
#define IF_ONE_BENT(...) __VA_ARGS__
#define IF_ONE_STRAIGHT(...) __VA_ARGS__
#define IF_ONE_SMOOTH(...)
#define IF_ONE_PLAIN(...)
#define IF_ONE_OWN(...)

#define IF_SMOOTH_LOOPS(...)
#define IF_SMOOTH_BENT(...)
#define IF_SMOOTH_STRAIGHT(...)
#define IF_SMOOTH_SMOOTH(...) __VA_ARGS__
#define IF_SMOOTH_PLAIN(...)
#define IF_SMOOTH_OWN(...)

#define IF_PLAIN_LOOPS(...)
#define IF_PLAIN_BENT(...)
#define IF_PLAIN_STRAIGHT(...)
#define IF_PLAIN_SMOOTH(...)
#define IF_PLAIN_PLAIN(...) __VA_ARGS__
#define IF_PLAIN_OWN(...)

#endif
