# SPDX-License-Identifier: MIT
# Lists mistakes that the tests must notice, one or more for each stage of the kernels, for the
# outputs and for the plan.
#
#   mutant(stage.mistake IN path... TEXT [[text]] BECOMES [[text]] SEEN_BY test [SETS set...])
#
# IN         files or folders of src/; TEXT must be found exactly once in all files there
# TEXT       what is replaced; short, so that it outlives changes nearby
# BECOMES    what is put in its place, where MUTANT is 1 if this mutant is switched on, or else 0
# SEEN_BY    bits (results of points differ from the scalar kernels'), chain (those of functions of
#            samples), curl (velocities from those of their potentials), gullies (those of sets from the
#            scalar kernels'), vector (components of vector
#            noise from those of the scalar kernels, or from samples and warps), plan (those of kept
#            plans from those without), grid (results of grids from those of points), large (the same, only large
#            grids), golden (hashes from golden.txt), recipe_bits (recipes on grids from those at points, and
#            hashes from recipes.txt), recipe_grids (recipes on grids from those at points, however they
#            are cut), recipe_skips (recipes with skips from those without), or crash
#            (the library crashes in the one call where only that shows it; see test_grid.c)
# SETS       the kernel sets that it is in; all but scalar if this is left out

# positions
mutant(positions.offset IN kernel TEXT [[p : p + vd_set(o->offset[axis])]]
       BECOMES [[p : p + vd_set(o->offset[MUTANT ? 0 : axis])]] SEEN_BY bits)
mutant(positions.first IN kernel/positions.h TEXT [[is_first && !has_offset(&plan->octave[octave])]]
       BECOMES [[is_first && (MUTANT || !has_offset(&plan->octave[octave]))]] SEEN_BY bits)
mutant(positions.turned_offset IN kernel TEXT [[TURNED_SHIFT - o->offset[axis] * stretch]]
       BECOMES [[TURNED_SHIFT - (MUTANT ? 0.0 : o->offset[axis] * stretch)]] SEEN_BY bits)
mutant(positions.turned_stretch IN kernel/unhashed.h TEXT [[o, axis, axis == 1 ? o->stretch : 1.0, low]]
       BECOMES [[o, axis, !MUTANT && axis == 1 ? o->stretch : 1.0, low]] SEEN_BY bits)
mutant(positions.turned_far IN kernel/points.h TEXT [[is_far(highest, here,]]
       BECOMES [[!MUTANT && is_far(highest, here,]] SEEN_BY bits)
mutant(positions.turned_far_few IN kernel TEXT [[is_far(highest_frequency(plan), count,]]
       BECOMES [[!MUTANT && is_far(highest_frequency(plan), count,]] SEEN_BY bits)
mutant(positions.turned_far_cell IN kernel TEXT [[return vd_floor(part + vd_set(0.5));]]
       BECOMES [[return vd_floor(part + vd_set(MUTANT ? 0.0 : 0.5));]] SEEN_BY bits)
mutant(positions.huge IN kernel TEXT [[const vf lower = vf_floor(p);]]
       BECOMES [[const vf lower = MUTANT ? vf_from_vi((vi)vu_from_vf(vf_floor(p))) : vf_floor(p);]]
       SEEN_BY bits)
mutant(positions.half_cell IN kernel TEXT [[(lower + vf_set(0.5f))]]
       BECOMES [[(lower + vf_set(MUTANT ? 0.0f : 0.5f))]] SEEN_BY bits)
mutant(positions.far IN kernel/lattice.h TEXT [[vu_any(far & vu_set(FAR_BITS))]]
       BECOMES [[!MUTANT && vu_any(far & vu_set(FAR_BITS))]] SEEN_BY bits)
mutant(positions.far_unhashed IN kernel/unhashed.h TEXT [[vu_any(far & vu_set(FAR_BITS))]]
       BECOMES [[!MUTANT && vu_any(far & vu_set(FAR_BITS))]] SEEN_BY bits)
mutant(positions.period_end IN kernel TEXT [[(vu)(cell == vu_set(o->last[i]))]]
       BECOMES [[(vu)(cell == vu_set(o->last[i] - (uint32_t)MUTANT))]] SEEN_BY bits)
mutant(positions.period_f64 IN kernel TEXT [[(lower + vd_set(0.5))]]
       BECOMES [[(lower + vd_set(MUTANT ? 0.0 : 0.5))]] SEEN_BY bits)
mutant(rows.period IN kernel TEXT [[next = next == o->last[0] ? 0 : next + 1]]
       BECOMES [[next = !MUTANT && next == o->last[0] ? 0 : next + 1]] SEEN_BY grid)
mutant(positions.hash IN kernel/lattice.h TEXT [[hash_corner3(h, y.h1, z.h1)]]
       BECOMES [[hash_corner3(h, y.h1, MUTANT ? z.h0 : z.h1)]] SEEN_BY bits)
mutant(positions.hash_of_axes IN kernel/basis TEXT [[hash_corner3(h, y.h1, z.h1)]]
       BECOMES [[hash_corner3(h, y.h1, MUTANT ? z.h0 : z.h1)]] SEEN_BY bits)
mutant(positions.hash_loop IN kernel/lattice.h TEXT [[m.axis[i] = axis_of(lattice, i, dimensions);]]
       BECOMES [[m.axis[i] = axis_of(lattice, MUTANT ? 0 : i, dimensions);]]
       SEEN_BY bits SETS sse4.1 avx2 neon wasm128 generic)
mutant(rows.hash IN kernel/lattice.h TEXT [[y.h1 ^ z.h1]]
       BECOMES [[(MUTANT ? y.h1 + z.h1 : y.h1 ^ z.h1)]] SEEN_BY grid)
mutant(positions.reference IN formulas TEXT [[magnitude(p) < 2147483648.0f]]
       BECOMES [[magnitude(p) < (MUTANT ? 0x1p30f : 0x1p31f)]] SEEN_BY golden SETS scalar)

# basis
mutant(basis.fused IN kernel TEXT [[return a + u * (b - a);]]
       BECOMES [[vf fused = a;
    for (int lane = 0; MUTANT && lane < VEC_LANES; lane++) {
        fused[lane] = __builtin_fmaf(u[lane], b[lane] - a[lane], a[lane]);
    }
    return MUTANT ? fused : a + u * (b - a);]] SEEN_BY bits)
mutant(basis.fade_order IN kernel TEXT [[(s * (t * 6.0f - 9.0f) + 1.0f)]]
       BECOMES [[(MUTANT ? (s * 6.0f * t - s * 9.0f) + 1.0f : s * (t * 6.0f - 9.0f) + 1.0f)]]
       SEEN_BY bits)
mutant(basis.quintic_ddu IN kernel TEXT [[60.0f * ts * (t + s)]]
       BECOMES [[60.0f * ts * (MUTANT ? t - s : t + s)]] SEEN_BY bits)
mutant(basis.cubic_ddu IN kernel TEXT [[6.0f - 12.0f * t]]
       BECOMES [[6.0f - (MUTANT ? 6.0f : 12.0f) * t]] SEEN_BY bits)
mutant(basis.across_dxx IN kernel TEXT [[2.0f * u.du * (r.a - l.a)]]
       BECOMES [[(MUTANT ? 1.0f : 2.0f) * u.du * (r.a - l.a)]] SEEN_BY bits)
mutant(basis.gradient_zz IN kernel TEXT [[product_plus(2.0f * w.du,]]
       BECOMES [[product_plus((MUTANT ? 1.0f : 2.0f) * w.du,]] SEEN_BY bits)
# flow
mutant(flow.octave IN plan/phase.c TEXT [[t = speeds[1];]]
       BECOMES [[t = speeds[MUTANT ? 0 : 1];]] SEEN_BY golden SETS scalar)
mutant(flow.slope IN kernel TEXT [[scarpi_phase_slope(o, k);]]
       BECOMES [[scarpi_phase_slope(o, MUTANT ? 0 : k);]] SEEN_BY bits)
mutant(flow.speed IN kernel TEXT [[vu_load(still->quick + i)]]
       BECOMES [[vu_load(still->quick + (MUTANT ? 0 : i))]] SEEN_BY bits SETS generic sse4.1 avx2 neon)
mutant(flow.opposite IN kernel TEXT [[turned[i ^ 9] = -turned[i];]]
       BECOMES [[turned[MUTANT ? i + 8 : i ^ 9] = -turned[i];]] SEEN_BY bits
       SETS generic sse4.1 avx512 neon)
mutant(flow.fused IN kernel TEXT [[v.flows ? a * b + c]]
       BECOMES [[v.flows && !MUTANT ? a * b + c]] SEEN_BY bits SETS avx2 avx512 neon)
mutant(flow.derivative IN kernel TEXT [[scarpi_phase_derivative(derivative, o->turn);]]
       BECOMES [[scarpi_phase_derivative(derivative, passes->plan->octave[MUTANT ? 0 : k].turn);]]
       SEEN_BY bits)
mutant(flow.rows IN kernel TEXT [[tile->row_octave->turn = passes->plan->octave[k].turn;]]
       BECOMES [[tile->row_octave->turn = passes->plan->octave[MUTANT ? 0 : k].turn;]] SEEN_BY grid)
mutant(flow.groups IN kernel TEXT [[tile->moving = moving + r * moving_of_row;]]
       BECOMES [[tile->moving = moving + (MUTANT ? 0 : r) * moving_of_row;]] SEEN_BY grid
       SETS generic sse4.1 neon) # others have few tiles with several groups
mutant(flow.ridged IN kernel TEXT [[(vu)(factor * ds) &]]
       BECOMES [[(vu)(factor * (MUTANT ? 0.5f : 1.0f) * ds) &]] SEEN_BY bits)
mutant(flow.hybrid IN kernel TEXT [[hybrid_first(weight, r, moving[0], turning[0])]]
       BECOMES [[hybrid_first(weight, r, MUTANT ? vf_set(0.0f) : moving[0], turning[0])]]
       SEEN_BY bits)
mutant(flow.erosion IN kernel TEXT [[vf_set(2.0f * erosion) * noise]]
       BECOMES [[vf_set((MUTANT ? 1.0f : 2.0f) * erosion) * noise]] SEEN_BY bits)
# vf_exact_fma where the product is rounded: the sets that fuse it must show that.
mutant(basis.inexact_2d IN kernel TEXT [[c.value.b = g.dot0 + f.u * ddot;]]
       BECOMES [[c.value.b = MUTANT ? vf_exact_fma(f.u, ddot, g.dot0) : g.dot0 + f.u * ddot;]]
       SEEN_BY bits SETS avx2 avx512 neon)
mutant(basis.inexact_six IN kernel TEXT [[e0.dgx + v.u * ddgx;]]
       BECOMES [[MUTANT ? vf_exact_fma(v.u, ddgx, e0.dgx) : e0.dgx + v.u * ddgx;]]
       SEEN_BY bits SETS avx2 avx512 neon) # ddgx may be 6
mutant(basis.value_yz IN kernel TEXT [[v.du * (w.du * ddz)]]
       BECOMES [[(MUTANT ? v.du * w.du * ddz : v.du * (w.du * ddz))]] SEEN_BY bits)

# driver
mutant(driver.tail IN kernel TEXT [[memcpy(to, from, (size_t)(end - to) * sizeof(float))]]
       BECOMES [[memcpy(to, from, MUTANT ? 0 : (size_t)(end - to) * sizeof(float))]]
       SEEN_BY bits)
mutant(driver.few IN kernel TEXT [[vf_load_partial(x, count)]]
       BECOMES [[vf_load_partial(x, MUTANT ? 1 : count)]] SEEN_BY bits)
mutant(driver.few_octaves IN kernel TEXT [[k < plan->octaves; k++) {
        const struct scarp_octave *const o = &plan->octave[k];
        const int is_turned]]
       BECOMES [[k < plan->octaves; k++) {
        const struct scarp_octave *const o = &plan->octave[MUTANT ? 0 : k];
        const int is_turned]] SEEN_BY bits)
mutant(driver.few_turned IN kernel TEXT [[is_turned ? turned_f32(o, axis, x->f32, f)]]
       BECOMES [[is_turned && !MUTANT ? turned_f32(o, axis, x->f32, f)]] SEEN_BY bits)
mutant(driver.few_ridged IN kernel TEXT [[weighted(o, n, &state->weight,]]
       BECOMES [[weighted(o, n, MUTANT ? &(struct sample){.value = state->weight.value}
                              : &state->weight,]] SEEN_BY bits)
mutant(driver.few_eroded IN kernel TEXT [[octave_axes ? o->amplitude : o->slope]]
       BECOMES [[octave_axes && !MUTANT ? o->amplitude : o->slope]] SEEN_BY bits)
mutant(driver.few_one IN kernel TEXT [[n.value *= vf_set(o->amplitude);]]
       BECOMES [[n.value *= vf_set(MUTANT ? o->weight : o->amplitude);]] SEEN_BY bits)
mutant(driver.values IN kernel TEXT [[k > 0 ? PUT_ADD : PUT_FIRST);
        }]]
       BECOMES [[k > MUTANT ? PUT_ADD : PUT_FIRST);
        }]] SEEN_BY bits)
mutant(driver.group_state IN kernel TEXT [[state + r * state_of_row]]
       BECOMES [[state + (MUTANT ? 0 : r) * state_of_row]] SEEN_BY grid)
mutant(driver.remainder IN kernel TEXT [[least(i, count - blocks * VEC_LANES)]]
       BECOMES [[MUTANT ? i : least(i, count - blocks * VEC_LANES)]] SEEN_BY grid)
mutant(driver.turned IN kernel TEXT [[s.dxy = column_dot(aj, 0, hy, v.dimensions)]]
       BECOMES [[s.dxy = MUTANT ? column_dot(aj, 1, hx, v.dimensions)
                       : column_dot(aj, 0, hy, v.dimensions)]]
       SEEN_BY bits)

# shape
mutant(shape.sign_of_zero IN kernel TEXT [[(vu)(n != vf_set(0.0f))]]
       BECOMES [[MUTANT ? vu_set(~0u) : (vu)(n != vf_set(0.0f))]] SEEN_BY bits)
mutant(shape.ridged_sign IN kernel TEXT [[2.0f * v * r * ij.m)]]
       BECOMES [[(MUTANT ? -2.0f : 2.0f) * v * r * ij.m)]] SEEN_BY bits)
mutant(shape.erosion_twice IN kernel TEXT [[vf_set(2.0f * erosion) * n->value]]
       BECOMES [[vf_set((MUTANT ? 1.0f : 2.0f) * erosion) * n->value]] SEEN_BY bits)

mutant(shape.crease IN kernel TEXT [[(vu)(absolute(value) != vf_set(1.0f))]]
       BECOMES [[MUTANT ? vu_set(~0u) : (vu)(absolute(value) != vf_set(1.0f))]] SEEN_BY bits)
mutant(shape.fold_slope IN kernel TEXT [[weight * (2.0f * plan->sharpness)]]
       BECOMES [[weight * ((MUTANT ? 1.0f : 2.0f) * plan->sharpness)]] SEEN_BY bits)
mutant(shape.hybrid_end IN kernel TEXT [[either(less, t, end)]]
       BECOMES [[either(MUTANT ? vu_set(~0u) : less, t, end)]] SEEN_BY bits)
mutant(shape.hybrid_cross IN kernel TEXT [[(i.w * j.m + j.w * i.m);]]
       BECOMES [[(MUTANT ? i.w * j.m : i.w * j.m + j.w * i.m);]] SEEN_BY bits)
mutant(shape.erosion_symmetric IN kernel TEXT [[y = {.x = xy, .y = yy}]]
       BECOMES [[y = {.x = MUTANT ? xx : xy, .y = yy}]] SEEN_BY bits)

# rows
mutant(rows.in_column IN kernel TEXT [[runs && first == last]]
       BECOMES [[runs && (MUTANT || first == last)]] SEEN_BY grid)
mutant(rows.reach IN kernel TEXT [[right - base > VF_TABLE - 2]]
       BECOMES [[right - base > VF_TABLE - (MUTANT ? 1 : 2)]]
       SEEN_BY grid SETS sse4.1 neon) # with wider vectors, it takes thousands of grids
mutant(rows.columns IN kernel TEXT [[(vf)hash_axis(column, o, 0, f.axes).h0]]
       BECOMES [[MUTANT ? (vf)hash_axis(column, o, 0, f.axes).h1
                        : (vf)hash_axis(column, o, 0, f.axes).h0]] SEEN_BY grid)
mutant(rows.dots2 IN kernel TEXT [[row.at.dots[1][0] = dots2(row.at.v.s);]]
       BECOMES [[row.at.dots[1][0] = dots2(MUTANT ? row.at.y : row.at.v.s);]]
       SEEN_BY grid SETS avx2 avx512)
mutant(rows.dots3 IN kernel TEXT [[dots3(row.at.v.s, row.at.z)]]
       BECOMES [[dots3(MUTANT ? row.at.y : row.at.v.s, row.at.z)]]
       SEEN_BY grid SETS avx2 avx512)
mutant(rows.pairs IN kernel TEXT [[vf_lookup_top(&gradient3_pair, index)]]
       BECOMES [[vf_lookup_top(MUTANT ? &gradient3_x : &gradient3_pair, index)]]
       SEEN_BY grid SETS avx2)
mutant(rows.slide IN kernel TEXT [[const size_t last = base + VF_TABLE - VEC_LANES;]]
       BECOMES [[const size_t last = base + (MUTANT ? 0 : VF_TABLE - VEC_LANES);]]
       SEEN_BY grid SETS avx512)

mutant(rows.turned_same IN kernel TEXT [[turned_at(&t->last[i], b, &row[i]).cell ^]]
       BECOMES [[turned_at(MUTANT && i > 0 ? &t->before[i] : &t->last[i], b, &row[i]).cell ^]]
       SEEN_BY grid)
mutant(rows.turned_carry IN kernel TEXT [[cell + (rest >> 24)]]
       BECOMES [[cell + (MUTANT ? vu_set(0) : rest >> 24)]] SEEN_BY grid)
mutant(rows.turned_row IN kernel TEXT [[parts->rest + at) + row->rest]]
       BECOMES [[parts->rest + at) + (MUTANT ? vu_set(0) : row->rest)]] SEEN_BY grid)
mutant(rows.turned_offset IN kernel TEXT [[far_sum(&a, zero, low), far_sum(&a, zero, high)]]
       BECOMES [[far_sum(MUTANT ? &t->axis[0] : &a, zero, low),
                  far_sum(MUTANT ? &t->axis[0] : &a, zero, high)]] SEEN_BY grid)
mutant(rows.turned_next IN kernel TEXT [[cell[i] = next[i];]]
       BECOMES [[cell[i] = MUTANT ? cell[i] : next[i];]] SEEN_BY grid)

# simplex noise
mutant(simplex.odd IN kernel/basis TEXT [[const vm odd = vm_bit(row, 0);]]
       BECOMES [[const vm odd = vm_bit(row, MUTANT);]] SEEN_BY bits)
mutant(simplex.nearest IN kernel/basis TEXT [[r.near_x = vm_and(r.not_near_z, xy);]]
       BECOMES [[r.near_x = vm_and(r.not_near_z, MUTANT ? yz : xy);]] SEEN_BY bits)
mutant(simplex.period IN kernel/basis TEXT [[(vu)(cell == last) & (last + 1)]]
       BECOMES [[(vu)(cell == last - (uint32_t)MUTANT) & (last + 1)]] SEEN_BY bits)
mutant(simplex.row_odd IN kernel/rows TEXT [[vf_set(row->odd ? 0.5f : 0.0f)]]
       BECOMES [[vf_set(!MUTANT && row->odd ? 0.5f : 0.0f)]] SEEN_BY grid)
mutant(simplex.before IN kernel TEXT [[at.before = vm_less(from, shift);]]
       BECOMES [[at.before = vm_less(from, MUTANT ? 0.0f * shift : shift);]] SEEN_BY bits)
mutant(simplex.third IN kernel TEXT [[vm_choose(lower, at, at - 1.5f)]]
       BECOMES [[vm_choose(lower, at, at - (MUTANT ? 1.25f : 1.5f))]] SEEN_BY bits)
mutant(simplex.centre IN kernel TEXT [[vu_set(i < 2 ? HASH_CENTRE : HASH_K)]]
       BECOMES [[vu_set(i < 2 && !MUTANT ? HASH_CENTRE : HASH_K)]] SEEN_BY bits)
mutant(simplex.hessian_order IN kernel TEXT [[s.dxy = bend * x * y -]]
       BECOMES [[s.dxy = (MUTANT ? bend * (x * y) : bend * x * y) -]] SEEN_BY bits)
mutant(simplex.stretch IN kernel TEXT [[p * vd_set(o->stretch)]]
       BECOMES [[p * vd_set(MUTANT ? (float)o->stretch : o->stretch)]] SEEN_BY bits)
mutant(simplex.row_first IN kernel TEXT [[(size_t)vm_any(at.before)]]
       BECOMES [[(size_t)(!MUTANT && vm_any(at.before))]] SEEN_BY grid)
mutant(simplex.row_beside IN kernel TEXT [[line->left > 0.25f]]
       BECOMES [[line->left > (MUTANT ? 0.375f : 0.25f)]] SEEN_BY grid
       SETS generic sse4.1 neon) # with more lanes, such rows are points

# cellular noise
mutant(cells.ring IN kernel TEXT [[return vm_any(vm_less(bound * bound, s * RING_MARGIN));]]
       BECOMES [[return !MUTANT && vm_any(vm_less(bound * bound, s * RING_MARGIN));]] SEEN_BY bits)
mutant(cells.period IN kernel TEXT [[before += (vu)(cell == 0) & period;]]
       BECOMES [[before += (vu)(cell == (vu_set(0) + (uint32_t)MUTANT)) & period;]] SEEN_BY bits)
mutant(cells.second IN kernel TEXT [[vf_lesser(vf_greater(f->s, to->s[0]), to->s[1])]]
       BECOMES [[vf_lesser(MUTANT ? f->s : vf_greater(f->s, to->s[0]), to->s[1])]] SEEN_BY bits)
mutant(cells.soft_hessian IN kernel TEXT [[14.0f * a6]]
       BECOMES [[(MUTANT ? 13.0f : 14.0f) * a6]] SEEN_BY bits)
mutant(cells.row_left_out IN kernel TEXT [[row->search.second ? second : first]]
       BECOMES [[row->search.second && !MUTANT ? second : first]] SEEN_BY grid)

# velocities
mutant(curl.sign IN kernel/curl.h TEXT [[v = -vf_load(minus + at);]]
       BECOMES [[v = MUTANT ? vf_load(minus + at) : -vf_load(minus + at);]] SEEN_BY curl)
mutant(curl.difference IN kernel/curl.h TEXT [[vf_load(plus + at) - vf_load(minus + at)]]
       BECOMES [[vf_load(plus + at) - (MUTANT ? vf_load(plus + at) : vf_load(minus + at))]]
       SEEN_BY curl)
mutant(curl.potentials IN kernel/curl.h TEXT [[curl_component(w, out, chunk, i,]]
       BECOMES [[curl_component(w, out, chunk, MUTANT ? (i + 1) % n : i,]] SEEN_BY curl)

# the components of vector noise
mutant(components.seeds IN plan/octaves.c TEXT [[SCARP_MAX_OCTAVES + 1 + component]]
       BECOMES [[SCARP_MAX_OCTAVES + 1 + (MUTANT ? component / 2 : component)]] SEEN_BY vector)
mutant(components.octaves IN plan/call.h TEXT [[found.octave += found.octaves * component;]]
       BECOMES [[found.octave += found.octaves * (MUTANT ? 0 : component);]] SEEN_BY vector)
mutant(components.number IN plan/call.h TEXT [[found.component = component;]]
       BECOMES [[found.component = MUTANT ? 0 : component;]] SEEN_BY vector)
mutant(components.gradients2 IN kernel TEXT [[h << (4 * component)]]
       BECOMES [[h << ((MUTANT ? 3 : 4) * component)]] SEEN_BY vector)
mutant(components.gradients3 IN kernel TEXT [[vu_upper_times(h, twelves[component])]]
       BECOMES [[vu_upper_times(h, twelves[MUTANT ? component / 2 : component])]] SEEN_BY vector)
mutant(components.values IN kernel TEXT [[vu_turn16(h) * vu_set(values[component])]]
       BECOMES [[(MUTANT ? h : vu_turn16(h)) * vu_set(values[component])]] SEEN_BY vector)
mutant(components.next IN kernel TEXT [[component_hash((vu)lattice[i], 1, v)]]
       BECOMES [[component_hash((vu)lattice[i], MUTANT ? 0 : 1, v)]] SEEN_BY vector)
mutant(components.rows IN kernel TEXT [[r->component > 0 ? component_corners]]
       BECOMES [[r->component > MUTANT ? component_corners]] SEEN_BY grid)
mutant(components.turned_rows IN kernel TEXT [[row.lattice += at->extent.blocks * size;]]
       BECOMES [[row.lattice += MUTANT ? 0 : at->extent.blocks * size;]] SEEN_BY grid)
mutant(components.state IN kernel/vector_points.h TEXT [[state + (size_t)i * vector->state]]
       BECOMES [[state + (MUTANT ? 0 : (size_t)i * vector->state)]] SEEN_BY vector)
mutant(components.dphase IN kernel/warp.h TEXT [[w.dphase + (size_t)i * w.chunked.most]]
       BECOMES [[w.dphase + (MUTANT ? 0 : (size_t)i * w.chunked.most)]] SEEN_BY vector)
mutant(components.reference IN formulas TEXT [[hash << (4u * component)]]
       BECOMES [[hash << ((MUTANT ? 3u : 4u) * component)]] SEEN_BY golden SETS scalar)

# outputs
mutant(outputs.lanes IN kernel TEXT [[put_block(float *to, vf term, enum put put)
{]]
       BECOMES [[put_block(float *to, vf term, enum put put)
{
    if (MUTANT && put != PUT_STREAM) {
        const float lane = term[0];
        term[0] = term[1];
        term[1] = lane;
    }]] SEEN_BY grid)
mutant(outputs.stream_lanes IN kernel TEXT [[vf_stream(to, term);]]
       BECOMES [[if (MUTANT) {
            const float lane = term[0];
            term[0] = term[1];
            term[1] = lane;
        }
        vf_stream(to, term);]] SEEN_BY large SETS sse4.1 avx2 avx512)
mutant(outputs.stream_slices IN kernel TEXT [[g->row_stride | (solid ? g->slice_stride : 0)]]
       BECOMES [[g->row_stride | (solid && !MUTANT ? g->slice_stride : 0)]]
       SEEN_BY crash SETS sse4.1 avx2 avx512)
mutant(outputs.normals IN kernel TEXT [[vf_from_vd(low.x, high.x)]]
       BECOMES [[MUTANT ? vf_from_vd(high.x, low.x) : vf_from_vd(low.x, high.x)]] SEEN_BY golden)

# functions of samples
mutant(chain.tail IN kernel/chain.h TEXT [[chain_copy(&filled.in[k][m], in[k][m], first, count);]]
       BECOMES [[chain_copy(&filled.in[k][m], in[k][m], MUTANT ? 0 : first, count);]] SEEN_BY golden)
mutant(chain.values IN kernel/chain.h TEXT [[case CHAIN_ADD: return a + b;]]
       BECOMES [[case CHAIN_ADD: return MUTANT ? a - b : a + b;]] SEEN_BY chain)
mutant(chain.part IN kernel/chain.h TEXT [[: chain_load_part(from, count);]]
       BECOMES [[: chain_load_part(from, MUTANT ? 1 : count);]] SEEN_BY chain)
mutant(chain.mixed IN kernel/chain.h TEXT [[vf_term(a.j, b.i));]]
       BECOMES [[(MUTANT ? vf_term(a.i, b.j) : vf_term(a.j, b.i)));]] SEEN_BY golden)
mutant(chain.zero IN kernel/chain.h TEXT [[return vf_term(a.value, b.value);]]
       BECOMES [[return MUTANT ? a.value * b.value : vf_term(a.value, b.value);]] SEEN_BY chain)
mutant(chain.zero_slope IN kernel/chain.h TEXT [[+ vf_term(a.value, b.member);]]
       BECOMES [[+ (MUTANT ? a.value * b.member : vf_term(a.value, b.member));]] SEEN_BY chain)
mutant(chain.nearer IN kernel/chain.h TEXT [[vm_less(vf_set(0.5f), share.value)]]
       BECOMES [[vm_less(vf_set(MUTANT ? 0.25f : 0.5f), share.value)]] SEEN_BY chain)
mutant(chain.nan IN kernel/chain_partials.h TEXT [[(vu)(greater ? a < b : b < a) | (vu)(b != b)]]
       BECOMES [[(vu)(greater ? a < b : b < a) | (MUTANT ? vu_set(0) : (vu)(b != b))]]
       SEEN_BY chain)
mutant(chain.smooth IN kernel/chain_partials.h TEXT [[.b = (vf)vu_choose(second, (vu)near, (vu)half)]]
       BECOMES [[.b = (vf)vu_choose(second, (vu)near, (vu)(MUTANT ? 1.0f - near : half))]]
       SEEN_BY chain)
mutant(chain.in_place IN kernel/chain.h TEXT [[count, room.result[m]);]]
       BECOMES [[count, MUTANT && count == keep ? call->out[m] + first : room.result[m]);
            if (MUTANT && count == keep) {
                memcpy(room.result[m], call->out[m] + first, keep * sizeof(float));
            }]] SEEN_BY chain)
mutant(chain.order IN calls/chain.c TEXT [[= k / 6.0f;]] BECOMES [[= MUTANT ? k * (1.0f / 6.0f) : k / 6.0f;]]
       SEEN_BY golden SETS scalar)

# plan, which all kernel sets share
mutant(plan.of_octaves IN plan/octaves.c TEXT [[sum += k == of - 1 ?]]
       BECOMES [[sum += k == of - 1 && !MUTANT ?]] SEEN_BY golden)
mutant(plan.hybrid IN plan/hybrid.c TEXT [[weight.highest = least(t.highest, 1.0);]]
       BECOMES [[weight.highest = MUTANT ? t.highest : least(t.highest, 1.0);]] SEEN_BY golden)
mutant(plan.hybrid_reach IN plan/octaves.c TEXT [[fractal == SCARP_HYBRID ? HEADROOM]]
       BECOMES [[fractal == SCARP_HYBRID && !MUTANT ? HEADROOM]] SEEN_BY golden)
mutant(plan.offset IN plan/octaves.c TEXT [[(int32_t)(c & 0xffffff)]]
       BECOMES [[(int32_t)(MUTANT ? b >> 40 : c & 0xffffff)]]
       SEEN_BY golden SETS scalar)
mutant(plan.offset_first IN plan/octaves.c TEXT [[k > 0 || offset_first != 0]]
       BECOMES [[k > 0 || (offset_first != 0 && !MUTANT)]] SEEN_BY golden SETS scalar)
mutant(plan.stale IN plan/kept.h TEXT [[same_noise(noise, &kept->noise)]]
       BECOMES [[(MUTANT || same_noise(noise, &kept->noise))]] SEEN_BY plan SETS scalar avx2)
mutant(plan.stale_seed IN plan/kept.h TEXT [[differences(a, b, 0, warp)]]
       BECOMES [[differences(a, b, MUTANT ? 32 : 0, warp)]] SEEN_BY plan SETS scalar)
mutant(plan.stale_spare IN plan/kept.h TEXT [[differences(a, b, warp + 2 * sizeof(uintptr_t), sizeof *a)]]
       BECOMES [[differences(a, b, warp + 2 * sizeof(uintptr_t), sizeof *a - (MUTANT ? sizeof(uintptr_t) : 0))]]
       SEEN_BY plan SETS scalar)
mutant(plan.dimensions IN plan/kept.h TEXT [[kept->mark == mark_of(dimensions, is_vector)]]
       BECOMES [[(kept->mark ^ mark_of(dimensions, is_vector)) <= (uint64_t)MUTANT]] SEEN_BY plan SETS scalar)
mutant(plan.kind IN plan/kept.h TEXT [[| (is_vector ? 16u : 0u)]]
       BECOMES [[| (!MUTANT && is_vector ? 16u : 0u)]] SEEN_BY plan SETS scalar)
mutant(plan.fetched IN plan/call.h TEXT [[levels->fetch != NULL && found.octave == levels->octave]]
       BECOMES [[levels->fetch != NULL && (MUTANT || found.octave == levels->octave)]] SEEN_BY plan SETS scalar)
mutant(plan.kept_dphase IN plan/kept.h TEXT [[plan_ask(plan, request);]]
       BECOMES [[plan_ask(plan, request), plan->flows &= !MUTANT;]]
       SEEN_BY plan SETS scalar avx2)

# warps
mutant(warp.diagonal IN kernel TEXT [[vf_load(slope + at) + 1.0f]]
       BECOMES [[vf_load(slope + at) + (MUTANT ? 0.0f : 1.0f)]] SEEN_BY bits)
mutant(warp.hessian IN kernel TEXT [[r.dyy = ALONG(dy, hy) + ALONG(dyy, g);]]
       BECOMES [[r.dyy = MUTANT ? ALONG(dy, hy) : ALONG(dy, hy) + ALONG(dyy, g);]] SEEN_BY bits)
mutant(warp.grid_chunk IN kernel TEXT [[grid->first[axis] += (int64_t)chunk->at[axis];]]
       BECOMES [[grid->first[axis] += MUTANT ? 0 : (int64_t)chunk->at[axis];]] SEEN_BY grid)
mutant(warp.reference IN formulas TEXT [[add3(r.diagonal, diagonal)]]
       BECOMES [[MUTANT ? r.diagonal : add3(r.diagonal, diagonal)]] SEEN_BY golden SETS scalar)
mutant(warp.seeds IN plan/plan.c TEXT [[scarpi_component_seed(noise.seed, own)]]
       BECOMES [[scarpi_component_seed(noise.seed, own - (MUTANT ? SCARP_MAX_OCTAVES : 0))]]
       SEEN_BY golden SETS avx2)

# displaced doubles
mutant(moved.carry IN kernel/positions.h TEXT [[vf_subtract_where(carry, t, vf_set(1.0f))]]
       BECOMES [[vf_subtract_where(carry, t, vf_set(MUTANT ? 0.0f : 1.0f))]] SEEN_BY bits)
mutant(moved.period IN kernel/moved.h TEXT [[(vu)(s.cell > last) & (last + 1)]]
       BECOMES [[(vu)(s.cell > last) & (MUTANT ? vu_set(0) : last + 1)]] SEEN_BY vector)
mutant(moved.row IN kernel/moved.h TEXT [[lane_of(from[0], i == 1 ? row % VEC_LANES : 0)]]
       BECOMES [[lane_of(from[0], i == 1 && !MUTANT ? row % VEC_LANES : 0)]] SEEN_BY grid)
mutant(moved.slice IN kernel/moved.h TEXT [[split_along(split.slice, &m->octave, 2]]
       BECOMES [[split_along(split.slice, &m->octave, 2 - MUTANT]] SEEN_BY grid)
mutant(moved.reference IN scalar TEXT [[carry ? sum - 1.0f : sum]]
       BECOMES [[carry && !MUTANT ? sum - 1.0f : sum]] SEEN_BY golden SETS scalar)

# fractals that bend
mutant(bend.left_by IN kernel
       TEXT [[l->x = left_along(less, sum, b->sum.dx, u, l->x, inverse_weight);]]
       BECOMES [[l->x = MUTANT ? l->x : left_along(less, sum, b->sum.dx, u, l->x, inverse_weight);]]
       SEEN_BY bits)
mutant(bend.damping IN kernel TEXT [[at->is_first ? vf_set(0.0f)]]
       BECOMES [[at->is_first || MUTANT ? vf_set(0.0f)]] SEEN_BY bits)
mutant(bend.jacobian IN kernel TEXT [[return vj + reach * dot(*column, v, dimensions);]]
       BECOMES [[return MUTANT ? vj : vj + reach * dot(*column, v, dimensions);]] SEEN_BY bits)

# grids as points
mutant(flat.row IN kernel/flat.h TEXT [[first = first + 1 < row ? first + 1 : 0;]]
       BECOMES [[first = first + 1 < row || MUTANT ? first + 1 : 0;]] SEEN_BY grid)
mutant(flat.gaps IN kernel/flat.h TEXT [[r % grid->count[1] * grid->row_stride]]
       BECOMES [[r % grid->count[1] * (MUTANT ? grid->count[0] : grid->row_stride)]] SEEN_BY grid)
mutant(flat.slices IN kernel/flat.h TEXT [[index = index + 1 < grid->count[axis] ? index + 1 : 0;]]
       BECOMES [[index = index + 1 < grid->count[axis] || MUTANT ? index + 1 : 0;]] SEEN_BY grid)
mutant(flat.chunk IN kernel/flat.h TEXT [[p->repeats[1] ? first % slice : 0]]
       BECOMES [[p->repeats[1] && !MUTANT ? first % slice : 0]] SEEN_BY grid)
mutant(crossing.rows IN kernel/crossing.h TEXT [[crossing_switch(&y, mask, &a.table[1], j, form);]]
       BECOMES [[crossing_switch(&y, mask, &a.table[MUTANT ? 0 : 1], j, form);]] SEEN_BY grid)
mutant(crossing.slices IN kernel/crossing.h TEXT [[crossing_switch(&z, mask, &a.table[2], ++k, form);]]
       BECOMES [[crossing_switch(&z, mask, &a.table[2], MUTANT ? k++ : ++k, form);]] SEEN_BY grid)
mutant(crossing.continued IN kernel/crossing.h TEXT [[i < count + VEC_LANES; i += count]]
       BECOMES [[i < count + VEC_LANES && (!MUTANT || i == count); i += count]] SEEN_BY grid
       SETS avx2 avx512) # blocks of 4 never begin where a second copy would be read
mutant(crossing.parts IN kernel/crossing.h TEXT [[some.first[axis] += (int64_t)at;]]
       BECOMES [[some.first[axis] += MUTANT ? 0 : (int64_t)at;]] SEEN_BY grid)
mutant(crossing.rest IN kernel/crossing.h TEXT [[copy_out(out, whole, &stored, 0, count - whole);]]
       BECOMES [[copy_out(out, whole, &stored, 0, MUTANT ? 0 : count - whole);]] SEEN_BY grid)

# gullies
mutant(gullies.step IN kernel/gullies/gully.h TEXT [=[by * base[BASE_DX], by * base[BASE_DY]]=]
       BECOMES [=[(MUTANT ? 0.0f : 1.0f) * by * base[BASE_DX], by * base[BASE_DY]]=] SEEN_BY gullies)
mutant(gullies.hessian IN kernel/gullies/gully.h TEXT [[0.5f * unit * (g->slope2 - g->slope2_low)]]
       BECOMES [[(MUTANT ? 0.0f : 0.5f) * unit * (g->slope2 - g->slope2_low)]] SEEN_BY gullies)
mutant(gullies.steep IN kernel/gullies/gully.h TEXT [[2.0f * dot2(s, sy)]]
       BECOMES [[(MUTANT ? 1.0f : 2.0f) * dot2(s, sy)]] SEEN_BY gullies)
mutant(gullies.sine IN kernel/gullies/gully.h TEXT [[+ 81.6010040f]]
       BECOMES [[+ (MUTANT ? 81.6010132f : 81.6010040f)]] SEEN_BY gullies)
mutant(gullies.fold IN kernel/gullies/gully.h TEXT [[vf_lesser(a, 0.5f - a)]]
       BECOMES [[(MUTANT ? a : vf_lesser(a, 0.5f - a))]] SEEN_BY gullies)
mutant(gullies.soft IN kernel/gullies/gully.h TEXT [[dot2(s->value, s->value) + GULLY_TAU2]]
       BECOMES [[dot2(s->value, s->value) + (MUTANT ? 0.00250001f : GULLY_TAU2)]] SEEN_BY gullies)
mutant(gullies.across IN kernel/gullies/gully.h TEXT [[ey.x - t.y * by]]
       BECOMES [[ey.x - t.y * (MUTANT ? bx : by)]] SEEN_BY gullies)
mutant(gullies.corner IN kernel/gullies/gully.h TEXT [[corner_wave(lattice[5], waves_y - q.x)]]
       BECOMES [[corner_wave(lattice[MUTANT ? 3 : 5], waves_y - q.x)]] SEEN_BY gullies)
mutant(gullies.moment IN kernel/gullies/gully.h TEXT [[difference2(scaled2(y, z), scaled2(fy.u, top))]]
       BECOMES [[difference2(scaled2(y, z), scaled2(MUTANT ? fx.u : fy.u, top))]] SEEN_BY gullies)
mutant(gullies.turned IN kernel/gullies/gully.h TEXT [[combined2(ax, m->moment_y, less_ay, m->moment_x)]]
       BECOMES [[combined2(ax, m->moment_y, MUTANT ? ay : less_ay, m->moment_x)]] SEEN_BY gullies)
mutant(gullies.stretch IN kernel/gullies/gully.h TEXT [[o->stretch * t->value.y]]
       BECOMES [[(o->stretch * (MUTANT ? 0.0f : 1.0f)) * t->value.y]] SEEN_BY gullies)
mutant(gullies.length IN kernel/gullies/gully.h TEXT [[scaled2(dot2(w, e), w)]]
       BECOMES [[scaled2(MUTANT ? vf_set(0.0f) : dot2(w, e), w)]] SEEN_BY gullies)
mutant(gullies.profile IN kernel/gullies/gully.h TEXT [[0.25f * g->fall * inverse(r)]]
       BECOMES [[(MUTANT ? 0.5f : 0.25f) * g->fall * inverse(r)]] SEEN_BY gullies)
mutant(gullies.keep IN kernel/gullies/gully.h TEXT [[1.0f - kept * v.value]]
       BECOMES [[1.0f - (MUTANT ? 0.0f : 1.0f) * kept * v.value]] SEEN_BY gullies)
mutant(gullies.keep_slope IN kernel/gullies/gully.h TEXT [[2.0f * state->steep.value * kept]]
       BECOMES [[(MUTANT ? 1.0f : 2.0f) * state->steep.value * kept]] SEEN_BY gullies)
mutant(gullies.branch IN kernel/gullies/gully.h TEXT [[0.0f - g->branch * m * w.value.y]]
       BECOMES [[(MUTANT ? 1.0f : 0.0f) - g->branch * m * w.value.y]] SEEN_BY gullies)
mutant(gullies.tail IN kernel/gullies.h TEXT [[load_up_to(c.base[i] + at, here)]]
       BECOMES [[load_up_to(c.base[i] + (MUTANT ? 0 : at), here)]] SEEN_BY gullies)
mutant(gullies.rows IN kernel/gullies.h TEXT [[chunk.base[i] = w->copy + (size_t)i * w->most;]]
       BECOMES [[chunk.base[i] = w->copy + (size_t)(MUTANT && i == BASE_DXX ? BASE_DYY : i) * w->most;]]
       SEEN_BY gullies)
mutant(gullies.weights IN plan/gully.c TEXT [[to->weight = plan->octave[k].weight;]]
       BECOMES [[to->weight = plan->octave[MUTANT ? 0 : k].weight;]] SEEN_BY golden SETS scalar)
mutant(gullies.first_keep IN plan/gully.c TEXT [[k == 0 ? 0.0f : (float)p->keep]]
       BECOMES [[k == 0 && !MUTANT ? 0.0f : (float)p->keep]] SEEN_BY golden SETS scalar)
mutant(gullies.reference IN formulas/gullies.h TEXT [[scaled2(fx.u, right)]]
       BECOMES [[scaled2(MUTANT ? fy.u : fx.u, right)]] SEEN_BY golden SETS scalar)

# recipes
mutant(recipe.seed IN recipe TEXT [[64 + whole]] BECOMES [[(MUTANT ? UINT64_C(65) : UINT64_C(64)) + whole]]
       SEEN_BY recipe_bits SETS scalar)
mutant(recipe.displacement IN recipe TEXT [[u[i] += (type)rest[i];]]
       BECOMES [[u[i] += (type)(MUTANT ? 0.0f : rest[i]);]] SEEN_BY recipe_bits SETS scalar)
mutant(recipe.jacobian IN recipe TEXT [[rest != NULL ? m + rest[at + n] : m]]
       BECOMES [[rest != NULL && !MUTANT ? m + rest[at + n] : m]] SEEN_BY recipe_bits SETS scalar)
mutant(recipe.curvature IN recipe TEXT [[sum[n] += g[k][n] * rest[at + n];]]
       BECOMES [[sum[n] += MUTANT ? 0.0f : g[k][n] * rest[at + n];]] SEEN_BY recipe_bits SETS scalar)
mutant(recipe.frame IN recipe TEXT [[if (p < 0 || is_frame(c->recipe, p)) {]]
       BECOMES [[if (MUTANT || p < 0 || is_frame(c->recipe, p)) {]] SEEN_BY recipe_bits SETS scalar)
mutant(recipe.left_out IN recipe TEXT [[copy(count, &in[!operand], out);]]
       BECOMES [[copy(count, &in[MUTANT ? operand : !operand], out);]] SEEN_BY recipe_bits SETS scalar)
mutant(recipe.columns IN recipe TEXT [[start[1] + ((axes & 2) != 0 ? row : 0)]]
       BECOMES [[start[1] + ((axes & 2) != 0 && !MUTANT ? row : 0)]] SEEN_BY recipe_bits SETS scalar)
mutant(recipe.registers IN recipe TEXT [=[(has(&s->kept, reads[i]) ? steps : k)]=]
       BECOMES [=[(has(&s->kept, reads[i]) && !MUTANT ? steps : k)]=] SEEN_BY recipe_grids SETS scalar)
mutant(recipe.guard IN recipe TEXT [[if (has(&below, n) && !has(&outside, n)]]
       BECOMES [[if (has(&below, n) && (MUTANT || !has(&outside, n))]] SEEN_BY recipe_bits SETS scalar)
mutant(recipe.piece IN recipe TEXT [[part.first[i] += (int64_t)box->from[i];]]
       BECOMES [[part.first[i] += MUTANT ? 0 : (int64_t)box->from[i];]] SEEN_BY recipe_grids SETS scalar)
mutant(recipe.copies IN recipe TEXT [[before->from[axis] == box->from[axis])]]
       BECOMES [[(MUTANT || before->from[axis] == box->from[axis]))]] SEEN_BY recipe_grids SETS scalar)
mutant(recipe.homes IN recipe TEXT [[read_twice.word[i] |= read.word[i] & by.word[i];]]
       BECOMES [[read_twice.word[i] |= MUTANT ? 0 : read.word[i] & by.word[i];]] SEEN_BY recipe_grids SETS scalar)
mutant(recipe.shared IN recipe TEXT [[a->index == b->index]]
       BECOMES [[(MUTANT || a->index == b->index)]] SEEN_BY recipe_bits SETS scalar)
mutant(recipe.skips_strict IN recipe TEXT [[operand.highest < kept.lowest ?]]
       BECOMES [[(MUTANT ? operand.highest <= kept.lowest : operand.highest < kept.lowest) ?]]
       SEEN_BY recipe_skips SETS scalar)
mutant(recipe.skips_clamp IN recipe TEXT [[operand.highest < n->k[0]  ? GUARD_BELOW]]
       BECOMES [[operand.highest < n->k[MUTANT ? 1 : 0] ? GUARD_BELOW]] SEEN_BY recipe_skips SETS scalar)
mutant(recipe.skips_width IN recipe TEXT [[return 1.0f - (greater - lesser) * (1.0f / k) <= 0.0f;]]
       BECOMES [[return MUTANT ? lesser < greater : 1.0f - (greater - lesser) * (1.0f / k) <= 0.0f;]]
       SEEN_BY recipe_skips SETS scalar)
mutant(recipe.skips_near IN recipe TEXT [[m->state[0] = is_near(m) ?]]
       BECOMES [[m->state[0] = MUTANT || is_near(m) ?]] SEEN_BY recipe_skips SETS scalar)
mutant(recipe.skips_safe IN recipe TEXT [[is_safe = is_safe && has(safe, reads[i]);]]
       BECOMES [[is_safe = is_safe && (MUTANT || has(safe, reads[i]));]] SEEN_BY recipe_skips SETS scalar)
mutant(recipe.skips_slopes IN recipe TEXT [[(m->order_of[g->gate] > 0 && !keeps_slopes)]]
       BECOMES [[(m->order_of[g->gate] > 0 && !keeps_slopes && !MUTANT)]]
       SEEN_BY recipe_skips SETS scalar)
mutant(recipe.skips_all IN recipe TEXT [[of[node] = all ? seen(count, value) : glanced(count, value);]]
       BECOMES [[of[node] = all && !MUTANT ? seen(count, value) : glanced(count, value);]]
       SEEN_BY recipe_skips SETS scalar)
mutant(recipe.skips_one IN recipe TEXT [[m->schedule->guard[i].gate == g->gate && m->state[i] > GUARD_OPEN]]
       BECOMES [[m->schedule->guard[i].gate == g->gate && m->state[i] > GUARD_OPEN && !MUTANT]]
       SEEN_BY recipe_skips SETS scalar)
mutant(partials.curve IN calls TEXT [[2.0f * (s / (s + t)) * t]]
       BECOMES [[(MUTANT ? 0.5f * (s + t) : 2.0f * (s / (s + t)) * t)]] SEEN_BY recipe_bits SETS scalar)
