/* SPDX-License-Identifier: MIT
 *
 * The contract of the vector operations that src/kernel is written in. Each vec_<isa>.h provides
 * all of them; each kernels_<isa>.c includes one, then the kernels. Not included by anything: a
 * page to read, kept beside the code that it describes.
 *
 * Types (gcc and clang vector extensions, so + - * / << >> ^ & | ~ work on them, lane by lane, and
 * comparisons, < and !=, give all ones or 0 in each lane):
 *   vf  VEC_LANES floats
 *   vu  VEC_LANES unsigned 32-bit integers; + - * wrap, >> shifts in zeros
 *   vi  VEC_LANES signed ones, for conversion
 *   vd  VEC_LANES / 2 doubles: a vf's worth of doubles is a pair (low lanes, high lanes)
 *   vf_table  VF_TABLE floats, for vf_permute; no operators
 *
 * Memory; addresses need no alignment beyond that of the element, but for vf_stream:
 *   vf   vf_load(const float *p)            p[0 .. VEC_LANES)
 *   void vf_store(float *p, vf v)           p[0 .. VEC_LANES)
 *   void vu_store(uint32_t *p, vu v)        p[0 .. VEC_LANES)
 *   vu   vu_load(const uint32_t *p)         p[0 .. VEC_LANES)
 *   vd   vd_load(const double *p)           p[0 .. VEC_LANES / 2)
 *   void vf_stream(float *p, vf v)          p[0 .. VEC_LANES), aligned to a vf; where VEC_STREAMS
 *                                           is 1, past the caches
 *   void vf_stream_end(void)                before other threads may learn that what was streamed
 *                                           is there: on x86 later stores overtake it, even those
 *                                           that release
 *
 * The same number in every lane:
 *   vf vf_set(float)      vu vu_set(uint32_t)      vd vd_set(double)
 *
 * Rounding and conversion:
 *   vf vf_floor(vf)       greatest integer not above; NaN and infinities as they are
 *   vd vd_floor(vd)       the same
 *   vu vu_from_vf(vf)     of an integral float in [-2^31, 2^31): its two's complement; of anything
 *                         else 0x80000000 (of NaN: anything)
 *   vf vf_from_vi(vi)     rounded to nearest
 *   vf vf_from_vd(vd low, vd high)   rounded to nearest
 *   vd vd_from_low(vf), vd vd_from_high(vf)   lanes below and from VEC_LANES / 2, exact
 *   vu vu_low_bits(vd low, vd high)  bits 0..31 of each double's representation
 *
 * Arithmetic that operators cannot say; correctly rounded, as IEEE 754 asks:
 *   vd vd_sqrt(vd)
 *
 * Bits:
 *   vu vu_turn8(vu)       each lane's bits turned right by 8: a >> 8 | a << 24
 *
 * Tables:
 *   vf vf_lookup(const struct lookup *table, vu hash)
 *                         table->entry[hash >> 28] in each lane; lookup.h tells what is known of
 *                         the entries, which helps where tables are small
 *   vu vu_top_index(vu hash)
 *                         what vf_lookup_top wants for the entries (hash >> 16) * 12 >> 16
 *   vf vf_lookup_top(const struct lookup_top *table, vu index)
 *                         in each lane the float with table->top[i] as its top byte and 0 below
 *
 * Permutation:
 *   vu vu_lanes(void)     0, 1, 2, ... VEC_LANES - 1
 *   vf_table vf_table_load(const float *p)   p[0 .. VF_TABLE); VF_TABLE is VEC_LANES or twice that
 *   vf_table vf_table_slide(vf_table t, vf next)   t without its first VEC_LANES entries, and next
 *   vu vf_index(vu i)     what vf_permute wants for these entries, each below VF_TABLE;
 *                         VF_INDEX_NEXT added to it asks for the entries after them (which must
 *                         also be below it)
 *   vf vf_permute(vf_table table, vu index)   table[i] in each lane
 *
 * In front of a loop of a dozen operations:
 *   VEC_SHORT_LOOP        unrolls it where that helps
 */
