/* SPDX-License-Identifier: MIT
 *
 * The vector operations that compare and choose: contracts and portable definitions, as in vec.h,
 * which includes this. A vm is a mask, a bit or all bits for each lane; a set that has registers of
 * their own for masks defines VEC_MASK_NATIVE, the type and all vm_ operations.
 */
#ifndef SCARP_SIMD_VEC_CHOOSE_H
#define SCARP_SIMD_VEC_CHOOSE_H

#ifndef VEC_MASK_NATIVE
typedef vu vm;

/* Whether a < b; a NaN is less than nothing. */
VEC_INLINE vm vm_less(vf a, vf b)
{
    return (vu)(a < b);
}

VEC_INLINE vm vm_equal(vu a, vu b)
{
    return (vu)(a == b);
}

/* Whether bit `bit` of a is set. */
VEC_INLINE vm vm_bit(vu a, int bit)
{
    return vu_bit(a, bit);
}

VEC_INLINE vm vm_and(vm a, vm b)
{
    return a & b;
}

VEC_INLINE vm vm_or(vm a, vm b)
{
    return a | b;
}

/* a without b. */
VEC_INLINE vm vm_without(vm a, vm b)
{
    return a & ~b;
}

VEC_INLINE int vm_any(vm a)
{
    return vu_any(a);
}

/* a where the mask is set, else 0. */
VEC_INLINE vu vm_keep(vm mask, vu a)
{
    return a & mask;
}

/* a + b, or a - b, where the mask is set, else a, which is not -0. */
VEC_INLINE vf vf_add_where(vm mask, vf a, vf b)
{
    return a + (vf)((vu)b & mask);
}

VEC_INLINE vf vf_subtract_where(vm mask, vf a, vf b)
{
    return a - (vf)((vu)b & mask);
}

/* a + b where the mask is set, else a. */
VEC_INLINE vu vu_add_where(vm mask, vu a, vu b)
{
    return a + (b & mask);
}

/* a where the mask is set, else b. A set may have only vm_choose of its own. */
#ifndef VM_CHOOSE_NATIVE
VEC_INLINE vf vm_choose(vm mask, vf a, vf b)
{
    return (vf)vu_choose(mask, (vu)a, (vu)b);
}
#endif
#endif

/* The greater of a and 0; 0 of NaN. */
#ifndef VF_POSITIVE_NATIVE
VEC_INLINE vf vf_positive(vf a)
{
    return (vf)((vu)a & (vu)(a > vf_set(0.0f)));
}
#endif

/* a where a < b, else b. */
#ifndef VF_LESSER_NATIVE
VEC_INLINE vf vf_lesser(vf a, vf b)
{
    return vm_choose(vm_less(a, b), a, b);
}
#endif

/* a where a > b, else b. */
#ifndef VF_GREATER_NATIVE
VEC_INLINE vf vf_greater(vf a, vf b)
{
    return vm_choose(vm_less(b, a), a, b);
}
#endif

/* a b, but 0 where a or b is 0, whatever the other one is. */
#ifndef VF_TERM_NATIVE
VEC_INLINE vf vf_term(vf a, vf b)
{
    const vf zero = vf_set(0.0f);
    return (vf)((vu)(a * b) & (vu)(a != zero) & (vu)(b != zero));
}
#endif

/* Correctly rounded. */
#ifndef VF_SQRT_NATIVE
VEC_INLINE vf vf_sqrt(vf a)
{
    vf v = a;
    for (int i = 0; i < VEC_LANES; i++) {
        v[i] = __builtin_sqrtf(a[i]);
    }
    return v;
}
#endif

#endif
