/* SPDX-License-Identifier: MIT
 *
 * Describes the outputs of a call as a list of arrays, so that kernels need not spell out struct
 * scarp_samples. The files of calls/ know what is what.
 */
#ifndef SCARP_OUTPUTS_H
#define SCARP_OUTPUTS_H

/* The outputs, in the order of struct scarp_samples. */
enum { VALUE, DX, DY, DZ, DXX, DXY, DXZ, DYY, DYZ, DZZ, DPHASE, OUTPUTS };

/* An array for each output, NULL where it is not asked for. A struct scarp_samples is read as one,
   which `may_alias` permits. */
struct __attribute__((may_alias)) scarp_outputs {
    float *array[OUTPUTS];
};

/* How many outputs there are up to an order, without DPHASE: they are the first ones. */
#define OUTPUTS_UP_TO(order) ((order) == 0 ? DX : (order) == 1 ? DXX : DPHASE)

/* What scarp_cells2 and its like give, in the order of struct scarp_cells, and a list of arrays as
   above. The array of ids has uint32_t. */
enum {
    CELLS_F1,
    CELLS_F2,
    CELLS_ID,
    CELLS_X,
    CELLS_Y,
    CELLS_Z,
    CELLS_DX1,
    CELLS_DY1,
    CELLS_DZ1,
    CELLS_DX2,
    CELLS_DY2,
    CELLS_DZ2,
    CELLS_OUTPUTS
};

struct __attribute__((may_alias)) scarp_cell_arrays {
    float *array[CELLS_OUTPUTS];
};

/* What scarp_curl2 and its like give, in the order of struct scarp_flow, and a list of arrays as
   above: the components of the velocity, then the rows of its Jacobian. */
enum { FLOW_V, FLOW_JACOBIAN = FLOW_V + 3, FLOW_OUTPUTS = FLOW_JACOBIAN + 9 };

struct __attribute__((may_alias)) scarp_flow_arrays {
    float *array[FLOW_OUTPUTS];
};

#endif
