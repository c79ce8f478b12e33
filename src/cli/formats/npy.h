/* SPDX-License-Identifier: MIT
 *
 * The header of NumPy's .npy files: versions 1.0, 2.0 and 3.0 are read, 1.0 is written. It
 * knows nothing of points. Whatever reads or writes arrays uses it.
 */
#ifndef SCARP_CLI_NPY_H
#define SCARP_CLI_NPY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#define NPY_MAGIC "\x93NUMPY"
#define NPY_MAGIC_SIZE 6
#define NPY_PREAMBLE_SIZE 12 /* the first bytes, which say where the header's text is */
#define NPY_HEADER_SIZE 128  /* of a header that is written, for up to three dimensions */
#define NPY_DIMENSIONS_MAX 4

struct npy_array {
    char descr[24]; /* the element type, such as "<f4"; longer ones are cut off */
    bool fortran;   /* the first index runs fastest */
    size_t shape[NPY_DIMENSIONS_MAX];
    int dimensions;
};

/* Where the header's text begins and how long it is, from the first bytes of a file; the data
   follow it. False if they are not those of a version that is known. */
bool npy_preamble(const char bytes[NPY_PREAMBLE_SIZE], size_t *text, size_t *length);

/* Reads the header's text. Returns NULL, or what is wrong with it, to follow "the header": what
   NumPy would not write is refused, such as a key that comes twice. */
const char *npy_parse_header(const char *text, size_t length, struct npy_array *array);

/* Writes what comes before the data of an array in C order. For up to three dimensions that takes
   NPY_HEADER_SIZE bytes whatever the shape is, so it may be written again when the shape is known;
   in any case a multiple of 64, as NumPy aligns it. False if writing fails. */
bool npy_write_header(FILE *stream, const char *descr, const size_t *shape, int dimensions);

/* Elements in the byte order that "<f4" and "<f8" name, at any address */
void npy_put_float(unsigned char *to, float value);
void npy_put_double(unsigned char *to, double value);

/* A type of numbers */
struct npy_type {
    char kind; /* 'f' floats, 'i' integers, 'u' those without a sign */
    int size;  /* bytes */
    bool big_endian;
};

/* Reads a type such as "<f4", ">i2" or "|u1": floats of 2, 4 or 8 bytes, integers of 1, 2, 4 or 8.
   False if it is no such type. */
bool npy_read_type(const char *descr, struct npy_type *type);

/* An element at any address; integers beyond 2^53 are rounded. */
double npy_get(const unsigned char *from, struct npy_type type);

#endif
