/* SPDX-License-Identifier: MIT
 *
 * The public functions that give words: for the enumerators of scarp.h, for a status, and the
 * version. Clients iterate over names until they meet NULL, so no list may have a gap;
 * tests/api_names.h looks for one.
 */
#include <stddef.h>

#include "../dispatch/isas.h"
#include "../plan/traits.h"
#include "scarp.h"

#define TEXT(x) #x
#define VERSION_TEXT(major, minor, patch) TEXT(major) "." TEXT(minor) "." TEXT(patch)

#define NAME(enumerator, name, ...) [SCARP_##enumerator] = name,
static const char *const bases[SCARP_BASES] = {SCARP_BASIS_LIST(NAME)};
static const char *const fractals[SCARP_FRACTALS] = {SCARP_FRACTAL_LIST(NAME)};
#undef NAME

static const char *const fades[SCARP_FADES] = {
    [SCARP_QUINTIC] = "quintic",
    [SCARP_CUBIC] = "cubic",
};

#define NAME(ISA, table, name, here) [SCARP_ISA_##ISA] = name,
static const char *const isas[SCARP_ISAS] = {[SCARP_ISA_NONE] = "none", SCARP_ISA_LIST(NAME)};
#undef NAME

/* Enumerators come as unsigned, so that negative numbers are too large as well. */
static const char *name_of(unsigned enumerator, const char *const names[], unsigned count)
{
    return enumerator < count ? names[enumerator] : NULL;
}

const char *scarp_basis_name(enum scarp_basis basis)
{
    return name_of((unsigned)basis, bases, SCARP_BASES);
}

const char *scarp_fade_name(enum scarp_fade fade)
{
    return name_of((unsigned)fade, fades, SCARP_FADES);
}

const char *scarp_fractal_name(enum scarp_fractal fractal)
{
    return name_of((unsigned)fractal, fractals, SCARP_FRACTALS);
}

const char *scarp_isa_name(enum scarp_isa isa)
{
    return name_of((unsigned)isa, isas, SCARP_ISAS);
}

const char *scarp_status_text(enum scarp_status status)
{
    switch (status) {
    case SCARP_OK: return "success";
    case SCARP_ERROR_NULL: return "a required pointer is NULL";
    case SCARP_ERROR_ENUM: return "unknown basis, fade, fractal or instruction set";
    case SCARP_ERROR_PARAMETER: return "a number is not finite or outside its interval";
    case SCARP_ERROR_SIZE: return "the arrays would exceed the address space";
    case SCARP_ERROR_UNSUPPORTED:
        return "this version, build, call or processor cannot serve the request";
    }
    return "unknown status";
}

const char *scarp_version(void)
{
    return VERSION_TEXT(SCARP_VERSION_MAJOR, SCARP_VERSION_MINOR, SCARP_VERSION_PATCH);
}
