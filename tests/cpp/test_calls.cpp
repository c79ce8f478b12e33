/* SPDX-License-Identifier: MIT
 *
 * scarp.hpp at points, on grids, and with the chain rule: the bits of C, and each span of another
 * size is refused by its name before anything is written.
 */
#include "check.hpp"
#include "members.hpp"

namespace
{

constexpr std::size_t COUNT = 37;
constexpr scarp_noise NOISE{
    .rotate = 1, .seed = 7, .frequency = 0.37, .octaves = 3, .phase = 0.25f};
constexpr scarp_noise CELLS{.basis = SCARP_CELL_F1, .seed = 7, .frequency = 0.37};

using floats = std::span<float>;

/* Spans, and the members of C that they stand for. The first `flat` of a structure are of the
 * plane. */
template <class Spans, class C> struct member {
    const char *name;
    floats Spans::*span;
    float *C::*c;
    bool is_flat;
};

#define MEMBER(name, is_flat) {#name, &spans::name, &c::name, is_flat},
#define TABLE(NAME, of_spans, of_c)                                                                \
    constexpr auto NAME = [] {                                                                     \
        using spans = of_spans;                                                                    \
        using c = of_c;                                                                            \
        return std::to_array<member<spans, c>>({NAME##_MEMBERS(MEMBER)});                          \
    }();
TABLE(SAMPLES, scarp::samples, scarp_samples)
TABLE(FEATURES, scarp::features, scarp_cells)
TABLE(FLOW, scarp::flow, scarp_flow)
TABLE(ERODED, scarp::eroded, scarp_eroded)

/* Compares a call with that of C, then gives it each of the spans with other sizes. */
template <class Spans, class C, std::size_t N, class Call, class CallC>
void compare(const std::array<member<Spans, C>, N> &members, std::size_t size, bool is_flat,
             bool is_grid, Call call, CallC call_c)
{
    arrays found(N, size), expected(N, size);
    Spans out;
    C out_c;
    for (std::size_t i = 0; i < N; i++) {
        if (members[i].is_flat || !is_flat) {
            out.*members[i].span = found[i];
            out_c.*members[i].c = expected[i].data();
        }
    }
    CHECK(call_c(&out_c) == SCARP_OK);
    CHECK(!expected.are_untouched());
    call(out);
    CHECK(found == expected);
    for (std::size_t i = 0; i < N; i++) {
        for (const int more : {-1, 1}) {
            if ((!members[i].is_flat && is_flat) || (is_grid && more > 0)) {
                continue;
            }
            arrays other(N, size);
            other[i].resize(size + static_cast<std::size_t>(more), arrays::mark);
            Spans wrong;
            for (std::size_t j = 0; j < N; j++) {
                if (members[j].is_flat || !is_flat) {
                    wrong.*members[j].span = other[j];
                }
            }
            CHECK(fails([&] { call(wrong); }, SCARP_ERROR_SIZE, members[i].name));
            CHECK(other.are_untouched());
        }
    }
}

/* A call for points of either type, in the plane and in space */
template <class T, class Spans, class C, std::size_t N, class Call, class Two, class Three>
void check_points(const scarp_noise &noise, const std::array<member<Spans, C>, N> &members,
                  Call call, Two two, Three three)
{
    const auto x = coordinates<T>(COUNT, 0.71), y = coordinates<T>(COUNT, -0.37),
               z = coordinates<T>(COUNT, 0.53), shorter = coordinates<T>(COUNT - 1, 1);
    compare(
        members, COUNT, true, false,
        [&](const Spans &out) {
            call(noise, {x, y}, out);
        },
        [&](const C *out) { return two(&noise, COUNT, x.data(), y.data(), out); });
    compare(
        members, COUNT, false, false,
        [&](const Spans &out) {
            call(noise, {x, y, z}, out);
        },
        [&](const C *out) { return three(&noise, COUNT, x.data(), y.data(), z.data(), out); });
    arrays untouched(1, COUNT);
    Spans out;
    out.*members[0].span = untouched[0];
    CHECK(fails([&] { call(noise, {x, shorter}, out); }, SCARP_ERROR_SIZE, "y"));
    CHECK(fails([&] { call(noise, {x, y, shorter}, out); }, SCARP_ERROR_SIZE, "z"));
    scarp_noise bad = noise;
    bad.octaves = 99;
    CHECK(fails([&] { call(bad, {x, y}, out); }, SCARP_ERROR_PARAMETER, "octaves"));
    CHECK(untouched.are_untouched());
    const std::vector<T> none;
    call(noise, {none, none}, {});
    call(noise, {none, none, none}, {});
}

/* One that was moved from still holds the plan that it names. */
void check_moved_from()
{
    scarp_plan plan{};
    CHECK(scarp_plan_make(&NOISE, 2, &plan) == SCARP_OK);
    scarp::kept_noise from(NOISE, 2), other(NOISE, 3);
    {
        const scarp::kept_noise moved = std::move(from);
        other = std::move(from);
    }
    const scarp::kept_noise third({.seed = 8}, 2), fourth(third, 3); /* these take free memory */
    for (const scarp_noise &one : {from, other})
        CHECK(std::memcmp(one.plan, &plan, sizeof plan) == 0);
}

void check_noise()
{
    const auto sample = [](const auto &...all) { scarp::sample(all...); };
    check_points<float>(NOISE, SAMPLES, scarp::sample, scarp_sample2, scarp_sample3);
    check_points<double>(NOISE, SAMPLES, scarp::sample, scarp_sample2_f64, scarp_sample3_f64);
    check_points<float>(CELLS, FEATURES, scarp::cells, scarp_cells2, scarp_cells3);
    check_points<double>(CELLS, FEATURES, scarp::cells, scarp_cells2_f64, scarp_cells3_f64);
    check_points<float>(NOISE, FLOW, scarp::curl, scarp_curl2, scarp_curl3);
    check_points<double>(NOISE, FLOW, scarp::curl, scarp_curl2_f64, scarp_curl3_f64);
    const scarp::kept_noise kept(NOISE, 2);
    const scarp::kept_noise copy = kept;
    CHECK(static_cast<const scarp_noise &>(copy).plan != nullptr);
    const auto x = coordinates<float>(COUNT, 0.71), y = coordinates<float>(COUNT, -0.37);
    compare(
        SAMPLES, COUNT, true, false,
        [&](const scarp::samples &out) {
            sample(copy, scarp::points{x, y}, out);
        },
        [&](const scarp_samples *out) {
            return scarp_sample2(&NOISE, COUNT, x.data(), y.data(), out);
        });
    CHECK(fails([] { scarp::kept_noise({.gain = 99}, 2); }, SCARP_ERROR_PARAMETER, "gain"));

    std::vector<std::uint32_t> id(COUNT), id_c(COUNT), id_wrong(COUNT + 1);
    const scarp_cells c{.id = id_c.data()};
    CHECK(scarp_cells2(&CELLS, COUNT, x.data(), y.data(), &c) == SCARP_OK);
    scarp::cells(CELLS, {x, y}, {.id = id});
    CHECK(id == id_c);
    CHECK(fails([&] { scarp::cells(CELLS, {x, y}, {.id = id_wrong}); }, SCARP_ERROR_SIZE, "id"));
    arrays other(2, COUNT + 1); /* the first one is told */
    CHECK(fails(
        [&] {
            scarp::sample(NOISE, {x, y}, {.dx = other[0], .dxx = other[1]});
        },
        SCARP_ERROR_SIZE, "dx"));
    /* no member of the noise is at fault if it is the output that does not exist */
    std::vector<float> dz(COUNT);
    CHECK(fails(
        [&] {
            scarp::sample(NOISE, {x, y}, {.dz = dz});
        },
        SCARP_ERROR_UNSUPPORTED, nullptr));
}

void check_vectors()
{
    const auto x = coordinates<float>(COUNT, 0.71), y = coordinates<float>(COUNT, -0.37),
               z = coordinates<float>(COUNT, 0.53);
    arrays found(3, COUNT), expected(3, COUNT), other(3, COUNT);
    const scarp::samples out[3] = {{.value = found[0]}, {.dx = found[1]}, {.dyy = found[2]}};
    scarp_samples c[3];
    c[0].value = expected[0].data();
    c[1].dx = expected[1].data();
    c[2].dyy = expected[2].data();
    CHECK(scarp_vector3(&NOISE, COUNT, x.data(), y.data(), z.data(), c) == SCARP_OK);
    scarp::vector(NOISE, {x, y, z}, out);
    CHECK(found == expected && !found.are_untouched());
    const scarp::samples wrong[3] = {
        {.value = other[0]}, {.dx = std::span(other[1]).first(COUNT - 1)}, {.dyy = other[2]}};
    CHECK(fails([&] { scarp::vector(NOISE, {x, y, z}, wrong); }, SCARP_ERROR_SIZE, "dx"));
    CHECK(fails([&] { scarp::vector(NOISE, {x, y}, wrong); }, SCARP_ERROR_SIZE, "out"));
    CHECK(fails([&] { scarp::vector(NOISE, {x, y}, {}); }, SCARP_ERROR_SIZE, "out"));
    CHECK(other.are_untouched());
}

void check_grids()
{
    scarp_grid grid{.origin = {-3, 2, 1}, .step = {0.5, 0.25, 0.75}, .count = {7, 5, 3}};
    const auto check_both = [&](std::size_t plane, std::size_t space) {
        compare(
            SAMPLES, plane, true, true,
            [&](const scarp::samples &out) { scarp::grid2(NOISE, grid, out); },
            [&](const scarp_samples *out) { return scarp_grid2(&NOISE, &grid, out); });
        compare(
            SAMPLES, space, false, true,
            [&](const scarp::samples &out) { scarp::grid3(NOISE, grid, out); },
            [&](const scarp_samples *out) { return scarp_grid3(&NOISE, &grid, out); });
    };
    check_both(7 * 5, 7 * 5 * 3);
    grid.row_stride = 9;
    check_both(9 * 4 + 7, 9 * 5 * 2 + 9 * 4 + 7);
    grid.slice_stride = 50;
    check_both(9 * 4 + 7, 50 * 2 + 9 * 4 + 7);

    /* More samples than there are bytes, and none */
    arrays other(1, 64);
    const auto refuses = [&](std::size_t a, std::size_t b, std::size_t c) {
        const scarp_grid large{.count = {a, b, c}};
        return fails([&] { scarp::grid3(NOISE, large, {.value = other[0]}); }, SCARP_ERROR_SIZE,
                     "value");
    };
    constexpr std::size_t half = std::numeric_limits<std::size_t>::max() / 2 + 1;
    CHECK(refuses(half, 2, 1) && refuses(8, half, 1) && refuses(8, 1, half) && refuses(2, 2, half));
    CHECK(refuses(half, half, half) && refuses(half, 1, 3) && other.are_untouched());
    scarp::grid3(NOISE, {.count = {4, 4, 0}}, {.value = other[0]});
    scarp::grid2(NOISE, {.step = {1, 1}, .count = {4, 4, 0}}, {.value = other[0]});
    CHECK(!other.are_untouched());
    CHECK(fails([&] { scarp::grid2({.jitter = 2}, grid, {.value = other[0]}); },
                SCARP_ERROR_PARAMETER, "jitter"));
}

void check_gullies()
{
    const scarp_grid grid{.step = {0.5, 0.25}, .count = {7, 5}};
    const scarp_gullies how{.seed = 3, .frequency = 0.37};
    arrays base(6, 7 * 5);
    const scarp::samples b{.value = base[0],
                           .dx = base[1],
                           .dy = base[2],
                           .dxx = base[3],
                           .dxy = base[4],
                           .dyy = base[5]};
    const scarp_samples c{.value = base[0].data(),
                          .dx = base[1].data(),
                          .dy = base[2].data(),
                          .dxx = base[3].data(),
                          .dxy = base[4].data(),
                          .dyy = base[5].data()};
    scarp::grid2({.seed = 3, .frequency = 0.37}, grid, b);
    compare(
        ERODED, 7 * 5, true, true,
        [&](const scarp::eroded &out) { scarp::gullies(how, grid, b, out); },
        [&](const scarp_eroded *out) { return scarp_gullies_grid2(&how, &grid, &c, out); });
    arrays other(1, 7 * 5);
    scarp::samples shorter = b;
    shorter.dxy = shorter.dxy.first(34);
    CHECK(fails([&] { scarp::gullies(how, grid, shorter, {.dx = other[0]}); }, SCARP_ERROR_SIZE,
                "dxy"));
    CHECK(fails([&] { scarp::gullies({.depth = -1}, grid, b, {.value = other[0]}); },
                SCARP_ERROR_PARAMETER, "depth"));
    CHECK(other.are_untouched());
}

void check_chain()
{
    const auto x = coordinates<float>(COUNT, 0.71), y = coordinates<float>(COUNT, -0.37);
    arrays a(2, COUNT), b(2, COUNT);
    const scarp::samples sa{.value = a[0], .dx = a[1]}, sb{.value = b[0], .dx = b[1]};
    scarp::sample(NOISE, {x, y}, sa);
    scarp::sample({.seed = 1, .frequency = 0.2}, {x, y}, sb);
    const scarp_samples ca{.value = a[0].data(), .dx = a[1].data()};
    const scarp_samples cb{.value = b[0].data(), .dx = b[1].data()};
    arrays found(2, COUNT), expected(2, COUNT), other(2, COUNT);
    const scarp::samples out{.value = found[0], .dx = found[1]};
    const scarp_samples c{.value = expected[0].data(), .dx = expected[1].data()};
    CHECK(scarp_smooth_max(COUNT, &ca, &cb, 0.1f, &c) == SCARP_OK);
    scarp::chain(scarp_smooth_max, sa, sb, 0.1f, out);
    CHECK(found == expected && !found.are_untouched());
    CHECK(scarp_terrace(COUNT, &ca, 4, 0.25f, 1, &c) == SCARP_OK);
    scarp::chain(scarp_terrace, sa, 4, 0.25f, 1, {.value = found[0], .dx = found[1]});
    CHECK(found == expected);
    CHECK(scarp_mix(COUNT, &ca, &cb, &ca, &c) == SCARP_OK);
    scarp::chain(scarp_mix, sa, sb, sa, out);
    CHECK(found == expected);

    /* slopes need no value */
    const scarp_samples slopes{.dx = a[1].data(), .dy = b[1].data()},
        slope{.value = expected[0].data()};
    CHECK(scarp_slope(COUNT, &slopes, &slope) == SCARP_OK);
    scarp::chain(scarp_slope, {.dx = a[1], .dy = b[1]}, {.value = found[0]});
    CHECK(found == expected);

    const scarp::samples shorter{.value = other[0], .dx = std::span(other[1]).first(COUNT - 1)};
    CHECK(fails([&] { scarp::chain(scarp_add, sa, sb, shorter); }, SCARP_ERROR_SIZE, "dx"));
    CHECK(fails([&] { scarp::chain(scarp_add, shorter, sb, out); }, SCARP_ERROR_SIZE, "dx"));
    CHECK(fails([&] { scarp::chain(scarp_terrace, sa, 4, 99, 1, out); }, SCARP_ERROR_PARAMETER,
                nullptr));
    CHECK(fails([&] { scarp::chain(scarp_slope, {.dx = b[1]}, shorter); }, SCARP_ERROR_SIZE, "dx"));
    CHECK(other.are_untouched() && found == expected);
}

bool says(const scarp::result &all, const char *text)
{
    const bool same = !std::strcmp(scarp::error(all).what(), text);
    if (!same) {
        std::printf("%s, not %s\n", scarp::error(all).what(), text);
    }
    return same;
}

/* Errors say which member is at fault, also in a warp, and why. */
void check_reasons()
{
    const auto x = coordinates<float>(COUNT, 0.71), y = coordinates<float>(COUNT, -0.37);
    arrays value(3, COUNT);
    const scarp::samples out{.value = value[0]}, second{.value = value[0], .dxy = value[1]};
    const scarp::samples phase{.dphase = value[1]}, depth{.dz = value[1]}, both[] = {out, second};
    const scarp_noise turned{.rotate = 1, .octaves = 2, .period = {4, 0, 0}};
    const scarp_noise above{.warp = &turned}, swiss{.fractal = SCARP_SWISS}, bent{.warp = &swiss};
    constexpr double endless = std::numeric_limits<double>::infinity();
    const scarp::flow velocity{.vx = value[0]}, jacobian{.vx = value[0], .vxy = value[1]};
    CHECK(says(scarp::try_sample(turned, {x, y}, out), "rotate: turned axes cannot repeat"));
    CHECK(says(scarp::try_sample(above, {x, y}, out), "warp.rotate: turned axes cannot repeat"));
    CHECK(
        says(scarp::try_sample(bent, {x, y}, second), "warp.fractal: this fractal has no Hessian"));
    CHECK(says(scarp::try_vector(swiss, {x, y}, both), "fractal: this fractal has no Hessian"));
    CHECK(says(scarp::try_curl(swiss, {x, y}, jacobian), "fractal: this fractal has no Hessian"));
    CHECK(scarp::try_curl(swiss, {x, y}, velocity));
    CHECK(says(scarp::try_sample({.basis = SCARP_SIMPLEX}, {x, y}, phase),
               "basis: only gradient noise has dphase"));
    CHECK(
        says(scarp::try_sample(NOISE, {x, y}, depth), scarp_status_text(SCARP_ERROR_UNSUPPORTED)));
    CHECK(says(scarp::try_grid2(swiss, {.count = {2, 2, 0}}, second),
               "fractal: this fractal has no Hessian"));
    CHECK(says(scarp::try_grid2({.gain = 99}, {.step = {endless, 1, 1}, .count = {2, 2, 0}}, out),
               "step[0]: not finite"));
    CHECK(says(scarp::try_gullies({.floor = 2}, {.count = {2, 2, 0}},
                                  {.value = value[0], .dx = value[1], .dy = value[2]}, {}),
               "floor: outside [-1, 1]"));
}

/* The calls that return a result throw nothing, and say what the others throw. */
void check_results()
{
    const auto x = coordinates<float>(COUNT, 0.71), y = coordinates<float>(COUNT, -0.37);
    arrays value(1, COUNT);
    const scarp::samples out{.value = value[0]};
    static_assert(
        noexcept(scarp::try_sample(NOISE, scarp::points(x, y), out)) &&noexcept(
            scarp::try_vector(NOISE, scarp::points(x, y),
                              {})) &&noexcept(scarp::try_cells(NOISE, scarp::points(x, y), {}))
            &&noexcept(scarp::try_curl(NOISE, scarp::points(x, y), {})) &&noexcept(scarp::try_grid2(
                NOISE, scarp_grid{}, {})) &&noexcept(scarp::try_grid3(NOISE, scarp_grid{}, {}))
                &&noexcept(scarp::try_gullies({}, {}, {}, {})) &&noexcept(
                    scarp::try_chain(scarp_add, out, out, out)));
    const scarp::result bad = scarp::try_sample({.gain = 99}, {x, y}, out);
    CHECK(!bad && bad.status == SCARP_ERROR_PARAMETER && !std::strcmp(bad.member, "gain"));
    CHECK(value.are_untouched());
    CHECK(!std::strcmp(scarp::error(bad).what(), "gain: outside [1/16, 16]"));
    CHECK(scarp::try_sample(NOISE, {x, y}, out) && !value.are_untouched());
}

} // namespace

int main()
{
    check_noise();
    check_moved_from();
    check_vectors();
    check_grids();
    check_gullies();
    check_chain();
    check_reasons();
    check_results();
    return failures == 0 ? 0 : 1;
}
