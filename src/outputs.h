/* SPDX-License-Identifier: MIT
 *
 * Describes the outputs of a call as a list of arrays, so that kernels need not spell out struct
 * scarp_samples. scarp.c makes the list.
 */
#ifndef SCARP_OUTPUTS_H
#define SCARP_OUTPUTS_H

/* The outputs, in the order of struct scarp_samples. */
enum { VALUE, DX, DY, DZ, DXX, DXY, DXZ, DYY, DYZ, DZZ, OUTPUTS };

/* An array for each output, NULL where it is not asked for. */
struct scarp_outputs {
    float *array[OUTPUTS];
    unsigned asked; /* a bit for each output that is */
};

/* The bits of the outputs of each order, and of those along z. */
enum {
    OUTPUTS_OF_ORDER1 = 1 << DX | 1 << DY | 1 << DZ,
    OUTPUTS_OF_ORDER2 = 1 << DXX | 1 << DXY | 1 << DXZ | 1 << DYY | 1 << DYZ | 1 << DZZ,
    OUTPUTS_ALONG_Z = 1 << DZ | 1 << DXZ | 1 << DYZ | 1 << DZZ
};

#endif
