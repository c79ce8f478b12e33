/* SPDX-License-Identifier: MIT
 *
 * Recipes of scarp.hpp: the bits of C in the plane and in space, sizes, scratch memory, errors at
 * their place, threads, and what becomes of a recipe that is moved or copied.
 */
#include <thread>

#include <scarp.h>

/* The plan that a call of scarp.hpp brought last */
static thread_local const void *brought;

static scarp_status bring(const scarp_scratch *scratch, scarp_status status)
{
    brought = scratch != nullptr ? scratch->plan : nullptr;
    return status;
}
#define scarp_recipe_sample(r, n, x, y, z, out, scratch)                                           \
    bring(scratch, (scarp_recipe_sample)(r, n, x, y, z, out, scratch))
#define scarp_recipe_sample_f64(r, n, x, y, z, out, scratch)                                       \
    bring(scratch, (scarp_recipe_sample_f64)(r, n, x, y, z, out, scratch))
#define scarp_recipe_grid(r, grid, out, scratch)                                                   \
    bring(scratch, (scarp_recipe_grid)(r, grid, out, scratch))

#include "check.hpp"

namespace
{

constexpr std::size_t COUNT = 3000; /* some chunks */

constexpr const char *FLAT = "recipe 1\n"
                             "param height = 110 [0, 10000]\n"
                             "ridges = noise(ridged, rotate, size=200, octaves=4)\n"
                             "out alps = height * ridges\n"
                             "out mask = smoothstep(noise(size=625), -0.5, 0.25)\n";
constexpr const char *SPACE = "recipe 1\nspace 3\nout a = noise(size=20, octaves=3)\n";

struct c_recipe {
    explicit c_recipe(const char *text) : recipe(std::make_unique<scarp_recipe>())
    {
        CHECK(scarp_recipe_parse(text, std::strlen(text), recipe.get(), nullptr, 0, nullptr) ==
              SCARP_OK);
    }
    std::unique_ptr<scarp_recipe> recipe;
};

void check_points()
{
    const auto x = coordinates<float>(COUNT, 7.1), y = coordinates<float>(COUNT, -3.7),
               z = coordinates<float>(COUNT, 5.3);
    const auto u = coordinates<double>(COUNT, 7.1), v = coordinates<double>(COUNT, -3.7),
               w = coordinates<double>(COUNT, 5.3);
    const c_recipe flat(FLAT), space(SPACE);
    scarp::recipe r(FLAT), s(SPACE);
    arrays found(4, COUNT), expected(4, COUNT), other(3, COUNT);
    const scarp_samples c[2] = {
        {.value = expected[0].data(), .dx = expected[1].data(), .dyy = expected[2].data()},
        {.value = expected[3].data()}};
    const scarp::samples out[2] = {{.value = found[0], .dx = found[1], .dyy = found[2]},
                                   {.value = found[3]}};
    const scarp_recipe_outputs both{.out = c, .count = 2}, one{.out = c, .count = 1};

    CHECK(scarp_recipe_sample(flat.recipe.get(), COUNT, x.data(), y.data(), nullptr, &both,
                              nullptr) == SCARP_OK);
    CHECK(r.try_sample({x, y}, out));
    CHECK(found == expected && !found.are_untouched());
    CHECK(scarp_recipe_sample_f64(flat.recipe.get(), COUNT, u.data(), v.data(), nullptr, &one,
                                  nullptr) == SCARP_OK);
    r.sample({u, v}, out[0]);
    CHECK(found == expected);
    CHECK(scarp_recipe_sample(space.recipe.get(), COUNT, x.data(), y.data(), z.data(), &one,
                              nullptr) == SCARP_OK);
    s.sample({x, y, z}, out[0]);
    CHECK(found == expected);
    CHECK(scarp_recipe_sample_f64(space.recipe.get(), COUNT, u.data(), v.data(), w.data(), &one,
                                  nullptr) == SCARP_OK);
    s.sample({u, v, w}, out[0]);
    CHECK(found == expected);

    const std::span last = std::span(other[1]).first(COUNT - 1);
    CHECK(fails(
        [&] {
            r.sample({x, y}, {.value = other[0], .dx = last});
        },
        SCARP_ERROR_SIZE, "dx"));
    CHECK(fails(
        [&] {
            r.sample({x, std::span(y).first(9)}, {.value = other[0]});
        },
        SCARP_ERROR_SIZE, "y"));
    CHECK(fails([&] { s.sample({x, y}, {.value = other[0]}); }, SCARP_ERROR_NULL, nullptr));
    CHECK(fails([&] { r.sample({x, y}, {.dphase = other[0]}); }, SCARP_ERROR_UNSUPPORTED, nullptr));
    const std::vector<scarp::samples> many(17, {.value = other[0]}), none;
    CHECK(r.try_sample({x, y}, many).status == SCARP_ERROR_PARAMETER);
    CHECK(r.try_sample({x, y}, std::span(many).first(3)).status == SCARP_ERROR_PARAMETER);
    CHECK(r.try_sample({x, y}, none).status == SCARP_ERROR_PARAMETER);
    CHECK(other.are_untouched());
}

void check_grids()
{
    const c_recipe flat(FLAT), space(SPACE);
    scarp::recipe r(FLAT), s(SPACE);
    const scarp_grid grid{.step = {3, 4, 5}, .count = {70, 50, 3}, .row_stride = 80};
    constexpr std::size_t plane = 80 * 49 + 70, volume = 80 * 50 * 2 + plane;
    for (const bool is_flat : {true, false}) {
        const std::size_t size = is_flat ? plane : volume;
        arrays found(2, size), expected(2, size), other(2, size - 1);
        const scarp_samples c{.value = expected[0].data(), .dy = expected[1].data()};
        const scarp_recipe_outputs one{.out = &c, .count = 1};
        const scarp_recipe *const of = (is_flat ? flat : space).recipe.get();
        CHECK(scarp_recipe_grid(of, &grid, &one, nullptr) == SCARP_OK);
        scarp::recipe &recipe = is_flat ? r : s;
        recipe.grid(grid, {.value = found[0], .dy = found[1]});
        CHECK(found == expected && !found.are_untouched());
        CHECK(fails([&] { recipe.grid(grid, {.value = found[0], .dy = other[1]}); },
                    SCARP_ERROR_SIZE, "dy"));
        CHECK(found == expected && other.are_untouched());
    }
}

/* Grids of few samples, and of long rows and columns, have scratch memory enough. */
void check_shapes()
{
    constexpr std::size_t SHAPES[][3] = {{1, 1, 1},    {3, 1, 1},    {1, 3, 1},  {1, 1, 3},
                                         {1, 1, 5000}, {5000, 1, 1}, {2, 3, 700}};
    for (const char *const text : {FLAT, SPACE}) {
        const c_recipe c(text);
        for (const auto &shape : SHAPES) {
            scarp::recipe fresh(text);
            const scarp_grid grid{.step = {3, 4, 5}, .count = {shape[0], shape[1], shape[2]}};
            const std::size_t size = shape[0] * shape[1] * shape[2];
            arrays found(2, size), expected(2, size);
            const scarp_samples s{.value = expected[0].data(), .dxx = expected[1].data()};
            const scarp_recipe_outputs one{.out = &s, .count = 1};
            CHECK(scarp_recipe_grid(c.recipe.get(), &grid, &one, nullptr) == SCARP_OK);
            fresh.grid(grid, {.value = found[0], .dxx = found[1]});
            CHECK(found == expected && !found.are_untouched());
        }
    }
}

/* As many outputs as there may be, and one more */
void check_outputs()
{
    std::string text = "recipe 1\n";
    for (char name = 'a'; name < 'a' + 16; name++) {
        text += std::string("out o") + name + " = noise(size=20)\n";
    }
    scarp::recipe r(text);
    const std::vector<float> x{33}, y{44};
    arrays found(17, 1);
    std::vector<scarp::samples> out(17);
    for (std::size_t i = 0; i < 17; i++) {
        out[i].value = found[i];
    }
    CHECK(r.try_sample({x, y}, out).status == SCARP_ERROR_PARAMETER && found.are_untouched());
    CHECK(r.try_sample({x, y}, std::span(out).first(16)));
    CHECK(found[15] == found[0] && found[0][0] != arrays::mark && found[16][0] == arrays::mark);
}

void check_parameters()
{
    const c_recipe c(FLAT);
    scarp::recipe r(FLAT);
    std::vector<float> value(1), expected(1);
    const std::vector<float> x{33}, y{44};
    const scarp_samples sample{.value = expected.data()};
    const scarp_recipe_outputs one{.out = &sample, .count = 1};
    CHECK(scarp_recipe_seed(c.recipe.get(), 9) == SCARP_OK);
    CHECK(scarp_recipe_set(c.recipe.get(), "height", 70, nullptr) == SCARP_OK);
    CHECK(scarp_recipe_sample(c.recipe.get(), 1, x.data(), y.data(), nullptr, &one, nullptr) ==
          SCARP_OK);
    r.sample({x, y}, {.value = value});
    CHECK(value != expected);
    r.seed(9);
    r.set("height", 70);
    r.sample({x, y}, {.value = value});
    CHECK(value == expected);
    CHECK(fails([&] { r.set("height", 99999); }, SCARP_ERROR_PARAMETER, nullptr));
    CHECK(fails([&] { r.set("depth", 1); }, SCARP_ERROR_PARAMETER, nullptr));
    CHECK(!std::strcmp(r.try_set("depth", 1).text,
                       "there is no such parameter, or its interval has no such value"));
    r.sample({x, y}, {.value = value});
    CHECK(value == expected);

    CHECK(scarp_recipe_scale(c.recipe.get(), 3, 2, nullptr) == SCARP_OK);
    CHECK(scarp_recipe_sample(c.recipe.get(), 1, x.data(), y.data(), nullptr, &one, nullptr) ==
          SCARP_OK);
    r.scale(3, 2);
    r.sample({x, y}, {.value = value});
    CHECK(value == expected);
    CHECK(fails([&] { r.scale(0); }, SCARP_ERROR_PARAMETER, nullptr));
    CHECK(fails([&] { r.tile(-1, 1); }, SCARP_ERROR_PARAMETER, nullptr));
    scarp_recipe_error unfit;
    CHECK(scarp_recipe_tile(c.recipe.get(), 7, 5, 0, &unfit) == SCARP_ERROR_PARAMETER);
    CHECK(r.try_tile(7, 5).text == unfit.text && r.try_tile(7, 5).line == unfit.line);
    scarp::recipe squares("recipe 1\nout a = noise(size=4)\n");
    squares.tile(8, 12);
    squares.sample({std::vector<double>{33}, std::vector<double>{44}}, {.value = expected});
    squares.sample({std::vector<double>{33 + 8 * 5}, std::vector<double>{44 + 12 * 3}},
                   {.value = value});
    CHECK(value == expected);

    float low = 0, high = 0;
    CHECK(scarp_recipe_range(c.recipe.get(), SCARP_RECIPE_OUTPUT, nullptr, &low, &high) ==
          SCARP_OK);
    CHECK(r.range().lowest == low && r.range().highest == high && low < high);
    const scarp_box box{.lowest = {1, 1}, .highest = {2, 2}}, bad{.lowest = {1}};
    CHECK(scarp_recipe_range(c.recipe.get(), 1, &box, &low, &high) == SCARP_OK);
    CHECK(r.range(1, &box).lowest == low && r.range(1, &box).highest == high);
    CHECK(fails([&] { static_cast<void>(r.range(1, &bad)); }, SCARP_ERROR_PARAMETER, nullptr));
}

void check_errors()
{
    const char *const wrong = "recipe 1\nout a = noise(gain=99)\n";
    scarp_recipe_error e;
    const auto c = std::make_unique<scarp_recipe>();
    const scarp_status status =
        scarp_recipe_parse(wrong, std::strlen(wrong), c.get(), &e, 1, nullptr);
    CHECK(status != SCARP_OK && e.line == 2);
    try {
        scarp::recipe r(wrong);
        CHECK(false);
    } catch (const scarp::error &error) {
        CHECK(error.why.status == status && error.why.line == 2 && error.why.column == e.column);
        CHECK(error.why.text == e.text && error.why.member == e.member);
        const std::string place = "2:" + std::to_string(e.column) + ": ";
        CHECK(std::string(error.what()).starts_with(place));
        CHECK(std::string(error.what()).ends_with(e.text));
    }
    /* A recipe stays what it was, to the bit. */
    scarp::recipe r(FLAT);
    const scarp_recipe before = *r.get();
    CHECK(r.load(wrong).line == 2);
    CHECK(std::memcmp(&before, r.get(), sizeof before) == 0);
    CHECK(!std::strcmp(r.load(std::string(20000, ' ')).what(), "a recipe has at most 16384 bytes"));
    CHECK(!r.load({}) && r.get() != nullptr);
    CHECK(r.load(SPACE) && std::memcmp(&before, r.get(), sizeof before) != 0);
}

void check_moves()
{
    const std::vector<float> x{33}, y{44};
    std::vector<float> value(1), same(1);
    scarp::recipe r(FLAT);
    r.sample({x, y}, {.value = value});
    scarp::recipe other = std::move(r);
    other.sample({x, y}, {.value = same});
    CHECK(value == same);
    scarp::recipe blank;
    for (scarp::recipe *const empty : {&r, &blank}) {
        CHECK(fails([&] { empty->sample({x, y}, {.value = value}); }, SCARP_ERROR_NULL, nullptr));
        CHECK(fails(
            [&] {
                empty->grid({.count = {1, 1}}, {.value = value});
            },
            SCARP_ERROR_NULL, nullptr));
        CHECK(fails([&] { empty->seed(1); }, SCARP_ERROR_NULL, nullptr));
        CHECK(fails([&] { empty->set("a", 1); }, SCARP_ERROR_NULL, nullptr));
        CHECK(empty->load(FLAT));
        empty->sample({x, y}, {.value = same});
        CHECK(value == same);
    }
    static_assert(std::is_nothrow_move_constructible_v<scarp::recipe> &&
                  std::is_nothrow_move_assignable_v<scarp::recipe>);
    static_assert(noexcept(r.load({})) &&noexcept(r.try_set("", 0)) &&noexcept(
        r.try_sample(scarp::points(x, y), {})) &&noexcept(r.try_grid({}, {})));
}

/* A copy is a recipe of its own: what is changed in one is not in the other. */
void check_copies()
{
    const auto x = coordinates<float>(COUNT, 7.1), y = coordinates<float>(COUNT, -3.7);
    scarp::recipe r(FLAT);
    r.seed(9);
    arrays before(1, COUNT), higher(1, COUNT), found(1, COUNT);
    r.sample({x, y}, {.value = before[0]});
    scarp::recipe copy = r, assigned(SPACE);
    assigned = copy;
    copy.set("height", 700);
    copy.sample({x, y}, {.value = higher[0]});
    CHECK(!(higher == before));
    r.sample({x, y}, {.value = found[0]});
    CHECK(found == before);
    r = scarp::recipe();
    assigned.sample({x, y}, {.value = found[0]});
    CHECK(found == before);
    const scarp::recipe &itself = copy;
    copy = itself;
    copy.sample({x, y}, {.value = found[0]});
    CHECK(found == higher);
    const scarp::recipe none = r;
    CHECK(none.get() == nullptr);
    copy = none;
    CHECK(copy.get() == nullptr);
}

/* Calls have as much scratch memory as they need, of the thread or of an object. */
void check_scratch()
{
    const scarp::recipe r(FLAT);
    scarp::scratch own;
    for (const int order : {1, 2, 0}) {
        const std::size_t best = scarp_recipe_scratch_size(r.get(), order, 0);
        CHECK(own.of(r.get(), order, 100).size == scarp_recipe_scratch_size(r.get(), order, 100));
        CHECK(own.of(r.get(), order, 1000000).size == best);
        CHECK(own.of(r.get(), order, std::numeric_limits<std::size_t>::max()).size == best);
        CHECK(own.of(r.get(), order, 0).size == scarp_recipe_scratch_size(r.get(), order, 1));
    }
    const void *const memory = own.of(r.get(), 2, 1000000).memory;
    CHECK(own.of(r.get(), 0, 1).memory == memory);
    const auto x = coordinates<float>(COUNT, 7.1), y = coordinates<float>(COUNT, -3.7);
    const scarp_grid grid{.step = {3, 4}, .count = {70, 50}};
    arrays found(2, COUNT), expected(2, COUNT), on_grid(1, 3500), grid_expected(1, 3500);
    const scarp::samples out{.value = found[0], .dyy = found[1]};
    r.sample({x, y}, {.value = expected[0], .dyy = expected[1]});
    r.sample({x, y}, out, own);
    CHECK(found == expected && own.of(r.get(), 0, 1).memory == memory);
    r.grid(grid, {.value = grid_expected[0]});
    r.grid(grid, {.value = on_grid[0]}, own);
    CHECK(on_grid == grid_expected);
    scarp::scratch moved = std::move(own);
    CHECK(moved.of(r.get(), 2, 1000000).memory == memory);
    r.sample({x, y}, out, own);
    CHECK(found == expected && own.of(r.get(), 0, 1).memory != memory);
}

/* Whether a recipe has the plan that C makes of it, and brings it to calls */
bool has_plan(const scarp::recipe &r)
{
    const std::size_t size = scarp_recipe_plan_size(r.get());
    std::vector<std::uint64_t> plan(size / 8 + 1);
    if (size == 0 || scarp_recipe_plan_make(r.get(), plan.data(), size) != SCARP_OK ||
        std::memcmp(r.plan(), plan.data(), size) != 0) {
        return false;
    }
    const std::vector<float> x{33}, y{44};
    const std::vector<double> u{33}, v{44};
    std::vector<float> value(1);
    bool all = true;
    const auto brings = [&] { all = all && std::exchange(brought, nullptr) == r.plan(); };
    r.sample({x, y}, {.value = value});
    brings();
    r.sample({u, v}, {.value = value});
    brings();
    r.grid({.count = {1, 1, 1}}, {.value = value});
    brings();
    return all;
}

/* A recipe has a plan, whatever becomes of it. */
void check_plans()
{
    scarp::recipe r(FLAT);
    CHECK(has_plan(r));
    r.seed(9);
    CHECK(has_plan(r));
    r.set("finest", 40);
    CHECK(has_plan(r));
    CHECK(!r.try_set("height", -1) && !r.load("recipe 2") && has_plan(r));
    r.scale(3, 2);
    CHECK(has_plan(r));
    const scarp::recipe copy = r;
    CHECK(copy.plan() != r.plan() && has_plan(copy) && has_plan(r));
    CHECK(r.load("recipe 1\nout a = noise(size=8)\n") && has_plan(r) && has_plan(copy));
    r.tile(32, 48);
    CHECK(has_plan(r));
    scarp::recipe moved = std::move(r);
    CHECK(has_plan(moved) && r.plan() == nullptr);
    r = copy;
    CHECK(has_plan(r) && scarp::recipe().plan() == nullptr);
}

/* Threads share one recipe, with no other memory than their own. */
void check_threads()
{
    constexpr std::size_t THREADS = 4;
    const auto x = coordinates<float>(COUNT, 7.1), y = coordinates<float>(COUNT, -3.7);
    const scarp::recipe r(FLAT);
    arrays expected(2, COUNT);
    r.sample({x, y}, {.value = expected[0], .dx = expected[1]});
    std::vector<arrays> found(THREADS, arrays(2, COUNT));
    std::vector<std::thread> threads;
    for (arrays &each : found) {
        threads.emplace_back([&] {
            for (std::size_t i = 0; i < 2000; i++) { /* all at once, then point by point */
                r.sample({x, y}, {.value = each[0], .dx = each[1]});
                each[0][i] = each[1][i] = arrays::mark;
                const auto one = [i](auto &all) { return std::span(all).subspan(i, 1); };
                r.sample({one(x), one(y)}, {.value = one(each[0]), .dx = one(each[1])});
            }
        });
    }
    for (std::size_t i = 0; i < THREADS; i++) {
        threads[i].join();
        CHECK(found[i] == expected);
    }
}

} // namespace

int main()
{
    check_points();
    check_grids();
    check_shapes();
    check_outputs();
    check_parameters();
    check_errors();
    check_moves();
    check_copies();
    check_scratch();
    check_plans();
    check_threads();
    return failures == 0 ? 0 : 1;
}
