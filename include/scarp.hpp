/* SPDX-License-Identifier: MIT
 *
 * scarp.hpp: the calls of scarp.h with spans, for C++20. It is a header alone; link the C library.
 *
 *     std::vector<float> x(1000), y(1000), height(1000), dx(1000);
 *     scarp::sample({.frequency = 0.01, .octaves = 6}, {x, y}, {.value = height, .dx = dx});
 *
 * scarp.h has the contracts: units, ranges, errors, structures. Here are sample, vector, cells,
 * curl, grid2, grid3, gullies and chain, each also as try_sample and so on, and the classes
 * kept_noise, recipe and scratch. Other calls are used as they are in C. What is added here:
 *
 * - Sizes are checked before anything is written. A span of points has as many elements as there
 *   are points, a span of a grid at least as many as there are from its first sample to its last.
 *   Otherwise the status is SCARP_ERROR_SIZE, and the span is named. An output whose span is empty
 *   is not computed.
 * - A function throws a scarp::error, or aborts where exceptions are off. Functions with names that
 *   begin with try_ are noexcept, and return a scarp::result.
 * - A recipe owns its memory, and a kept_noise its plan. A scratch owns memory in which recipes are
 *   sampled; each thread has one. Nothing else allocates.
 *
 * Calls keep no span after they return. The noise that noise.warp points to stays the caller's. Any
 * thread may call any function at any time. Any number of threads may sample or copy one object, if
 * none changes it meanwhile.
 */
#ifndef SCARP_HPP
#define SCARP_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "scarp.h"

/* A minor version has functions of its own, though programs write scarp:: for all. Where two meet
   in one process, neither calls the other's. */
#if SCARP_VERSION_MAJOR != 0 || SCARP_VERSION_MINOR != 2
#error "the namespace in scarp.hpp has another version than scarp.h"
#endif

namespace scarp
{
inline namespace v0_2
{

/* How a call ended. The texts are static. */
struct [[nodiscard]] result {
    scarp_status status = SCARP_OK;
    const char *member = nullptr; /* the member, span or argument at fault; nullptr: unknown */
    const char *text = nullptr;   /* what is wrong; nullptr: what scarp_status_text says */
    int line = 0, column = 0;     /* where a recipe has the error, from 1, in bytes; 0: elsewhere */

    explicit operator bool() const noexcept { return status == SCARP_OK; }
    const char *what() const noexcept { return text ? text : scarp_status_text(status); }
    void check() const; /* throws an error if there is one */
};

/* A result that is an error. what() has the place in a recipe, if there is one, the member at fault
   and the text: "2:24: gain: outside [1/16, 16]". */
struct error : std::runtime_error {
    explicit error(const result &all)
        : std::runtime_error(
              (all.line == 0 ? ""
                             : std::to_string(all.line) + ":" + std::to_string(all.column) + ": ") +
              (all.member == nullptr ? "" : std::string(all.member) + ": ") + all.what()),
          why(all)
    {
    }
    result why;
};

inline void result::check() const
{
    if (status != SCARP_OK) {
#ifdef __cpp_exceptions
        throw error(*this);
#else
        std::abort();
#endif
    }
}

/* <spans> made by src/bindings/interface.py of include/scarp.h: do not change them by hand */
/* struct scarp_samples with spans: outputs, and inputs of the chain rule and of gullies */
struct samples {
    std::span<float> value{};
    std::span<float> dx{};
    std::span<float> dy{};
    std::span<float> dz{};
    std::span<float> dxx{};
    std::span<float> dxy{};
    std::span<float> dxz{};
    std::span<float> dyy{};
    std::span<float> dyz{};
    std::span<float> dzz{};
    std::span<float> dphase{};
};

/* struct scarp_cells with spans: the features near each point */
struct features {
    std::span<float> f1{};
    std::span<float> f2{};
    std::span<std::uint32_t> id{};
    std::span<float> x{};
    std::span<float> y{};
    std::span<float> z{};
    std::span<float> dx1{};
    std::span<float> dy1{};
    std::span<float> dz1{};
    std::span<float> dx2{};
    std::span<float> dy2{};
    std::span<float> dz2{};
};

/* struct scarp_flow with spans: velocities and their Jacobians */
struct flow {
    std::span<float> vx{};
    std::span<float> vy{};
    std::span<float> vz{};
    std::span<float> vxx{};
    std::span<float> vxy{};
    std::span<float> vxz{};
    std::span<float> vyx{};
    std::span<float> vyy{};
    std::span<float> vyz{};
    std::span<float> vzx{};
    std::span<float> vzy{};
    std::span<float> vzz{};
};

/* struct scarp_eroded with spans: the base with gullies, and the displacement */
struct eroded {
    std::span<float> value{};
    std::span<float> dx{};
    std::span<float> dy{};
    std::span<float> displacement{};
    std::span<float> displacement_dx{};
    std::span<float> displacement_dy{};
};
/* </spans> */

/* An interval that values never leave */
struct interval {
    float lowest = 0, highest = 0;
};

/* Coordinates in units of input: {x, y} in the plane, {x, y, z} in space. With doubles, the calls
   of C are those that end in _f64, for large worlds. */
struct points {
    template <class T> using axis = std::span<const T>;
    template <class T> using maybe = std::optional<axis<T>>;

    points(axis<float> x, axis<float> y, maybe<float> z = {}) noexcept : points(x, y, z, f) {}
    points(axis<double> x, axis<double> y, maybe<double> z = {}) noexcept : points(x, y, z, d) {}

    std::array<const float *, 3> f{};
    std::array<const double *, 3> d{};
    std::size_t count;
    int dimensions;
    const char *wrong; /* the axis whose size is not that of x, or nullptr */

  private:
    template <class T>
    points(axis<T> x, axis<T> y, maybe<T> z, std::array<const T *, 3> &at) noexcept
        : count(x.size()), dimensions(z ? 3 : 2), wrong(y.size() != count               ? "y"
                                                        : z.value_or(x).size() != count ? "z"
                                                                                        : nullptr)
    {
        at = {x.data(), y.data(), z ? z->data() : nullptr};
    }
};

namespace detail
{

/* Gives the pointers of spans, and remembers the first span whose size is wrong. */
struct sizes {
    std::size_t count;
    bool is_grid = false; /* spans may be longer */
    const char *wrong = nullptr;

    template <class T> T *operator()(std::span<T> span, const char *name) noexcept
    {
        const bool fits = is_grid ? span.size() >= count : span.size() == count;
        if (!span.empty() && !fits && wrong == nullptr) {
            wrong = name;
        }
        return span.empty() ? nullptr : span.data();
    }
};

inline sizes sizes_of(const points &at) noexcept { return {at.count, false, at.wrong}; }

/* How many elements there are from the first sample to the last; the largest size_t if more */
inline sizes sizes_of(const scarp_grid &grid, int dimensions) noexcept
{
    constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
    const auto sum = [](std::size_t first, std::size_t a, std::size_t b) {
        return b != 0 && a > (most - first) / b ? most : first + a * b;
    };
    const std::size_t *const n = grid.count;
    if (n[0] == 0 || n[1] == 0 || (dimensions == 3 && n[2] == 0)) {
        return {0, true};
    }
    const std::size_t row = grid.row_stride != 0 ? grid.row_stride : n[0];
    const std::size_t slice = grid.slice_stride != 0 ? grid.slice_stride : sum(0, n[1], row);
    const std::size_t plane = sum(n[0], n[1] - 1, row);
    return {dimensions == 3 ? sum(plane, n[2] - 1, slice) : plane, true};
}

/* The structures of C, made of those with spans. <of> made by src/bindings/interface.py of include/scarp.h: do not change them by hand */
inline scarp_samples c_of(const samples &s, sizes &of) noexcept
{
    scarp_samples c;
    c.value = of(s.value, "value");
    c.dx = of(s.dx, "dx");
    c.dy = of(s.dy, "dy");
    c.dz = of(s.dz, "dz");
    c.dxx = of(s.dxx, "dxx");
    c.dxy = of(s.dxy, "dxy");
    c.dxz = of(s.dxz, "dxz");
    c.dyy = of(s.dyy, "dyy");
    c.dyz = of(s.dyz, "dyz");
    c.dzz = of(s.dzz, "dzz");
    c.dphase = of(s.dphase, "dphase");
    return c;
}
inline scarp_cells c_of(const features &s, sizes &of) noexcept
{
    scarp_cells c;
    c.f1 = of(s.f1, "f1");
    c.f2 = of(s.f2, "f2");
    c.id = of(s.id, "id");
    c.x = of(s.x, "x");
    c.y = of(s.y, "y");
    c.z = of(s.z, "z");
    c.dx1 = of(s.dx1, "dx1");
    c.dy1 = of(s.dy1, "dy1");
    c.dz1 = of(s.dz1, "dz1");
    c.dx2 = of(s.dx2, "dx2");
    c.dy2 = of(s.dy2, "dy2");
    c.dz2 = of(s.dz2, "dz2");
    return c;
}
inline scarp_flow c_of(const flow &s, sizes &of) noexcept
{
    scarp_flow c;
    c.vx = of(s.vx, "vx");
    c.vy = of(s.vy, "vy");
    c.vz = of(s.vz, "vz");
    c.vxx = of(s.vxx, "vxx");
    c.vxy = of(s.vxy, "vxy");
    c.vxz = of(s.vxz, "vxz");
    c.vyx = of(s.vyx, "vyx");
    c.vyy = of(s.vyy, "vyy");
    c.vyz = of(s.vyz, "vyz");
    c.vzx = of(s.vzx, "vzx");
    c.vzy = of(s.vzy, "vzy");
    c.vzz = of(s.vzz, "vzz");
    return c;
}
inline scarp_eroded c_of(const eroded &s, sizes &of) noexcept
{
    scarp_eroded c;
    c.value = of(s.value, "value");
    c.dx = of(s.dx, "dx");
    c.dy = of(s.dy, "dy");
    c.displacement = of(s.displacement, "displacement");
    c.displacement_dx = of(s.displacement_dx, "displacement_dx");
    c.displacement_dy = of(s.displacement_dy, "displacement_dy");
    return c;
}
/* The structures of C, made of those with spans. </of> */
using sixteen = std::array<scarp_samples, 16>;
inline sixteen c_of(std::span<const samples> s, sizes &of) noexcept
{
    sixteen c;
    std::transform(s.begin(), s.begin() + std::min<std::ptrdiff_t>(std::ssize(s), 16), c.begin(),
                   [&](const samples &each) { return c_of(each, of); });
    return c;
}
inline float c_of(float number, sizes &) noexcept { return number; }

template <class T> const T *argument(const T &c) noexcept { return &c; }
inline const scarp_samples *argument(const sixteen &c) noexcept { return c.data(); }
inline float argument(float number) noexcept { return number; }

/* Calls with the structures of C in the place of those with spans, if the sizes are right. */
template <class Call, class... Arguments>
result run(sizes of, Call call, const Arguments &...arguments) noexcept
{
    const std::tuple c{c_of(arguments, of)...}; /* in this order */
    if (of.wrong != nullptr) {
        return {SCARP_ERROR_SIZE, of.wrong,
                of.is_grid ? "a span is shorter than the grid" : "spans have different sizes"};
    }
    return std::apply([&](const auto &...each) { return call(argument(each)...); }, c);
}

/* The derivatives that `count` structures ask for */
struct asked {
    int order = 0;
    bool dphase = false;
};
inline asked asked_of(const scarp_samples *c, int count) noexcept
{
    asked all;
    for (int i = 0; i < count; i++, c++) {
        const bool second = c->dxx || c->dxy || c->dxz || c->dyy || c->dyz || c->dzz;
        const int order = second ? 2 : c->dx || c->dy || c->dz ? 1 : 0;
        all = {std::max(order, all.order), c->dphase || all.dphase};
    }
    return all;
}
inline asked asked_of(const scarp_cells *, int) noexcept { return {}; }
inline asked asked_of(const scarp_flow *c, int) noexcept
{
    return {c->vxx || c->vxy || c->vxz || c->vyx || c->vyy || c->vyz || c->vzx || c->vzy || c->vzz
                ? 2
                : 0};
}

/* A status, with the member at fault, of the noise or of gullies, and the reason */
inline result blame(scarp_status status, const scarp_noise &noise, int dimensions,
                    asked of = {}) noexcept
{
    result all{status};
    if (status != SCARP_OK) {
        all.text = scarp_noise_fault(&noise, dimensions, of.order, of.dphase, &all.member);
    }
    return all;
}
inline result blame(scarp_status status, const scarp_gullies &gullies, int, asked = {}) noexcept
{
    result all{status};
    if (status != SCARP_OK) {
        all.text = scarp_gullies_fault(&gullies, &all.member);
    }
    return all;
}

/* Calls the one of four functions that the points are for. */
template <class Out, class F2, class F3, class D2, class D3>
result at_points(const scarp_noise &noise, const points &at, const Out &out, F2 f2, F3 f3, D2 d2,
                 D3 d3) noexcept
{
    const auto call = [&](auto *c) {
        const auto [x, y, z] = at.f;
        const auto [u, v, w] = at.d;
        const scarp_status status = u && !w ? d2(&noise, at.count, u, v, c)
                                    : u     ? d3(&noise, at.count, u, v, w, c)
                                    : !z    ? f2(&noise, at.count, x, y, c)
                                            : f3(&noise, at.count, x, y, z, c);
        constexpr bool is_vector = std::is_same_v<Out, std::span<const samples>>;
        return blame(status, noise, at.dimensions, asked_of(c, is_vector ? at.dimensions : 1));
    };
    return run(sizes_of(at), call, out);
}

template <class Function, class What, class... Spans>
result on_grid(int dimensions, Function function, const What &what, const scarp_grid &grid,
               const Spans &...spans) noexcept
{
    const auto call = [&](const auto *first, auto... rest) -> result {
        result all{function(&what, &grid, first, rest...)};
        if (all.status != SCARP_OK) {
            all.text = scarp_grid_fault(&grid, dimensions, &all.member);
        }
        return all.text != nullptr ? all : blame(all.status, what, dimensions, asked_of(first, 1));
    };
    return run(sizes_of(grid, dimensions), call, spans...);
}

/* The twin of a function that returns a result */
template <class... P> struct throwing {
    result (*function)(P...) noexcept;
    void operator()(P... parameters) const { function(parameters...).check(); }
};
template <class... P> throwing(result (*)(P...) noexcept) -> throwing<P...>;

/* The type that stands in the place of a parameter of C */
template <class T> struct in_place_of;
template <> struct in_place_of<const scarp_samples *> {
    using type = const samples &;
};
template <> struct in_place_of<float> {
    using type = float;
};

} // namespace detail

/* scarp_sample2 and its like */
inline result try_sample(const scarp_noise &noise, const points &at, const samples &out) noexcept
{
    return detail::at_points(noise, at, out, scarp_sample2, scarp_sample3, scarp_sample2_f64,
                             scarp_sample3_f64);
}
inline constexpr detail::throwing sample{try_sample};

/* scarp_vector2 and its like: `out` has an element for each axis */
inline result try_vector(const scarp_noise &noise, const points &at,
                         std::span<const samples> out) noexcept
{
    if (std::ssize(out) != at.dimensions) {
        return {SCARP_ERROR_SIZE, "out", "there must be an element for each axis"};
    }
    return detail::at_points(noise, at, out, scarp_vector2, scarp_vector3, scarp_vector2_f64,
                             scarp_vector3_f64);
}
inline constexpr detail::throwing vector{try_vector};

/* scarp_cells2 and its like */
inline result try_cells(const scarp_noise &noise, const points &at, const features &out) noexcept
{
    return detail::at_points(noise, at, out, scarp_cells2, scarp_cells3, scarp_cells2_f64,
                             scarp_cells3_f64);
}
inline constexpr detail::throwing cells{try_cells};

/* scarp_curl2 and its like */
inline result try_curl(const scarp_noise &noise, const points &at, const flow &out) noexcept
{
    return detail::at_points(noise, at, out, scarp_curl2, scarp_curl3, scarp_curl2_f64,
                             scarp_curl3_f64);
}
inline constexpr detail::throwing curl{try_curl};

/* scarp_grid2, scarp_grid3 */
inline result try_grid2(const scarp_noise &noise, const scarp_grid &at, const samples &out) noexcept
{
    return detail::on_grid(2, scarp_grid2, noise, at, out);
}
inline result try_grid3(const scarp_noise &noise, const scarp_grid &at, const samples &out) noexcept
{
    return detail::on_grid(3, scarp_grid3, noise, at, out);
}
inline constexpr detail::throwing grid2{try_grid2}, grid3{try_grid3};

/* scarp_gullies_grid2 */
inline result try_gullies(const scarp_gullies &how, const scarp_grid &at, const samples &base,
                          const eroded &out) noexcept
{
    return detail::on_grid(2, scarp_gullies_grid2, how, at, base, out);
}
inline constexpr detail::throwing gullies{try_gullies};

/* The chain rule: chain(scarp_smooth_max, a, b, 0.1f, out) calls a function of C that takes samples
   and floats. All spans have the size of a.value or, without it, of a.dx. */
template <class... P>
result try_chain(scarp_status (*function)(std::size_t, const scarp_samples *, P...),
                 const samples &a, typename detail::in_place_of<P>::type... others) noexcept
{
    const std::size_t count = std::max(a.value.size(), a.dx.size());
    const auto call = [&](auto... c) { return result{function(count, c...)}; };
    return detail::run({count}, call, a, others...);
}
template <class... P>
void chain(scarp_status (*function)(std::size_t, const scarp_samples *, P...), const samples &a,
           typename detail::in_place_of<P>::type... others)
{
    try_chain<P...>(function, a, others...).check();
}

/* A noise with its plan in 2 or 3 `dimensions`, for many calls with few points. Pass it in the
   place of a noise. Copies share the plan, which lives as long as one of them. A warp brings its own
   plan, if any: see scarp_vector_plan_make. */
class kept_noise
{
  public:
    kept_noise(const scarp_noise &noise, int dimensions)
        : plan_(std::make_shared<scarp_plan>()), noise_(noise)
    {
        const scarp_status status = scarp_plan_make(&noise, dimensions, plan_.get());
        detail::blame(status, noise, dimensions).check();
        noise_.plan = plan_.get();
    }
    kept_noise(const kept_noise &) = default; /* no moves: each object keeps a plan */
    kept_noise &operator=(const kept_noise &) = default;
    operator const scarp_noise &() const noexcept { return noise_; }

  private:
    std::shared_ptr<scarp_plan> plan_;
    scarp_noise noise_;
};

/* Memory that recipes are sampled in. It grows to the best size for the calls that it serves, of one
   thread at a time. Each thread has one already; make another to say how long its memory stays. */
class scratch
{
  public:
    scratch() noexcept = default;
    scratch(scratch &&) noexcept = default;
    scratch &operator=(scratch &&) noexcept = default;

    /* For a call for so many points. If there is no memory, the call works in small chunks. */
    scarp_scratch of(const scarp_recipe *recipe, int order, std::size_t points) noexcept
    {
        const std::size_t best = scarp_recipe_scratch_size(recipe, order, 0);
        const std::size_t few =
            scarp_recipe_scratch_size(recipe, order, std::max<std::size_t>(points, 1));
        const std::size_t size = few > 0 && few < best ? few : best;
        if (size > size_ || !memory_) {
            memory_.reset(new (std::nothrow) std::byte[size]);
            size_ = memory_ ? size : 0;
        }
        return {.memory = memory_.get(), .size = std::min(size, size_)};
    }

    static scratch &of_thread() noexcept
    {
        static thread_local scratch own;
        return own;
    }

  private:
    std::unique_ptr<std::byte[]> memory_;
    std::size_t size_ = 0;
};

/* A recipe, with its 64 KiB and its plan, which is made whenever the recipe changes. Copies are
   recipes of their own. Any number of threads may sample one. Calls for an empty recipe, or one that
   was moved from, give SCARP_ERROR_NULL. */
class recipe
{
  public:
    recipe() noexcept = default;
    explicit recipe(std::string_view text) { load(text).check(); }
    recipe(recipe &&) noexcept = default;
    recipe &operator=(recipe &&) noexcept = default;
    recipe(const recipe &other) : c_(other.c_ ? std::make_unique<scarp_recipe>(*other.c_) : nullptr)
    {
        make_plan();
    }
    recipe &operator=(const recipe &other) { return *this = recipe(other); }

    /* Reads a text. If it has errors, the recipe stays as it was; the result has the first one. */
    result load(std::string_view text) noexcept
    {
        std::unique_ptr<scarp_recipe> fresh(new (std::nothrow) scarp_recipe);
        scarp_recipe_error first;
        first.text = fresh ? "a recipe has at most 16384 bytes" : "there is not enough memory";
        const scarp_status status =
            scarp_recipe_parse(text.data(), text.size(), fresh.get(), &first, 1, nullptr);
        if (status == SCARP_OK) {
            c_ = std::move(fresh);
        }
        return changed(status, first);
    }

    result try_set(const char *name, double value) noexcept /* a parameter, or "finest" */
    {
        scarp_recipe_error error;
        const scarp_status status = scarp_recipe_set(c_.get(), name, value, &error);
        if (status == SCARP_ERROR_PARAMETER && error.text == nullptr) {
            error.text = "there is no such parameter, or its interval has no such value";
        }
        return changed(status, error);
    }
    void set(const char *name, double value) { try_set(name, value).check(); }
    /* All 64 bits count: -1 is 2^64 - 1. */
    void seed(std::uint64_t seed) { changed(scarp_recipe_seed(c_.get(), seed), {}).check(); }
    /* Makes it repeat, as the line `tile x, y` of a text does, or with 0 not at all. */
    result try_tile(double x, double y, double z = 0.0) noexcept
    {
        scarp_recipe_error error;
        const scarp_status status = scarp_recipe_tile(c_.get(), x, y, z, &error);
        return changed(status, error);
    }
    void tile(double x, double y, double z = 0.0) { try_tile(x, y, z).check(); }
    /* Makes it so many times larger, and the values of the first output. */
    result try_scale(double by, double heights = 1.0) noexcept
    {
        scarp_recipe_error error;
        const scarp_status status = scarp_recipe_scale(c_.get(), by, heights, &error);
        return changed(status, error);
    }
    void scale(double by, double heights = 1.0) { try_scale(by, heights).check(); }
    /* For other calls of scarp.h; the plan, for struct scarp_scratch, may be nullptr. */
    const scarp_recipe *get() const noexcept { return c_.get(); }
    const void *plan() const noexcept { return plan_.get(); }

    /* The interval that values never leave: of the first output, or of number `which`, a statement
       or part as in struct scarp_recipe_outputs; everywhere, or in a box */
    interval range(std::int32_t which = SCARP_RECIPE_OUTPUT, const scarp_box *box = nullptr) const
    {
        interval all;
        result{scarp_recipe_range(c_.get(), which, box, &all.lowest, &all.highest)}.check();
        return all;
    }

    /* Samples at points, or on a grid, which are in space if the recipe is. `out` has an element
       for each output of the text that is wanted, from the first one on. */
    result try_sample(const points &at, std::span<const samples> out,
                      scratch &memory = scratch::of_thread()) const noexcept
    {
        const auto call = [&](auto *outputs, auto *room) {
            const auto [x, y, z] = at.f;
            const auto [u, v, w] = at.d;
            return u ? scarp_recipe_sample_f64(c_.get(), at.count, u, v, w, outputs, room)
                     : scarp_recipe_sample(c_.get(), at.count, x, y, z, outputs, room);
        };
        return run(detail::sizes_of(at), call, out, memory);
    }
    result try_grid(const scarp_grid &grid, std::span<const samples> out,
                    scratch &memory = scratch::of_thread()) const noexcept
    {
        const auto call = [&](auto *outputs, auto *room) {
            return scarp_recipe_grid(c_.get(), &grid, outputs, room);
        };
        return run(detail::sizes_of(grid, is_flat() ? 2 : 3), call, out, memory);
    }
    void sample(const points &at, const samples &out, scratch &memory = scratch::of_thread()) const
    {
        try_sample(at, {&out, 1}, memory).check();
    }
    void grid(const scarp_grid &grid, const samples &out,
              scratch &memory = scratch::of_thread()) const
    {
        try_grid(grid, {&out, 1}, memory).check();
    }

  private:
    /* The result of a call that changes the recipe, and its plan if there is no error */
    result changed(scarp_status status, const scarp_recipe_error &e) noexcept
    {
        if (status != SCARP_OK) {
            return {status, e.member, e.text, e.line, e.column};
        }
        make_plan();
        return {};
    }
    void make_plan() noexcept /* Without one, for want of memory, few points take longer. */
    {
        const std::size_t size = scarp_recipe_plan_size(c_.get());
        plan_.reset(size > 0 ? new (std::nothrow) std::uint64_t[size / 8 + 1] : nullptr);
        if (plan_ && scarp_recipe_plan_make(c_.get(), plan_.get(), size) != SCARP_OK) {
            plan_.reset();
        }
    }
    bool is_flat() const noexcept /* Whether the recipe is of the plane */
    {
        scarp_recipe_entry entry;
        return scarp_recipe_entry_at(c_.get(), 0, &entry) == SCARP_OK && entry.dimensions == 2;
    }
    template <class Call>
    result run(detail::sizes of, Call call, std::span<const samples> out,
               scratch &memory) const noexcept
    {
        const int count =
            static_cast<int>(std::min<std::size_t>(out.size(), 17)); /* 16 are allowed */
        const auto with_memory = [&](const scarp_samples *c) {
            const int order = detail::asked_of(c, std::min(count, 16)).order;
            const scarp_recipe_outputs outputs{.out = c, .count = count};
            scarp_scratch room = memory.of(c_.get(), order, of.count);
            room.plan = plan_.get();
            return result{call(&outputs, &room)};
        };
        return detail::run(of, with_memory, out);
    }

    std::unique_ptr<scarp_recipe> c_;
    std::unique_ptr<std::uint64_t[]> plan_;
};

} // namespace v0_2
} // namespace scarp

#endif
