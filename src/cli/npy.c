/* SPDX-License-Identifier: MIT
 *
 * The header of NumPy's .npy files, format version 1.0: a magic number, the length of what follows,
 * and a Python dictionary as text, padded with spaces.
 */
#include "npy.h"

#include <string.h>

#define HEADER_BYTES 128

bool npy_write_header(FILE *stream, const char *descr, const size_t *shape, int dimensions)
{
    char header[HEADER_BYTES + 1] = "\x93NUMPY\x01";
    header[8] = HEADER_BYTES - 10; /* the bytes from 10 on, a 16-bit number */
    int length = 10;
    length += snprintf(header + length, sizeof header - (size_t)length,
                       "{'descr': '%s', 'fortran_order': False, 'shape': (", descr);
    for (int d = 0; d < dimensions; d++) {
        length += snprintf(header + length, sizeof header - (size_t)length,
                           d == 0 ? "%zu," : " %zu,", shape[d]);
    }
    length += snprintf(header + length, sizeof header - (size_t)length, "), }");
    memset(header + length, ' ', (size_t)(HEADER_BYTES - 1 - length));
    header[HEADER_BYTES - 1] = '\n';
    return fwrite(header, 1, HEADER_BYTES, stream) == HEADER_BYTES;
}
