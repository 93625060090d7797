#include "core/math/projection.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/raw_placement.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::int64_t px(double count) { return static_cast<std::int64_t>(count * 65536); }

/// In front of the middle of a panel of 512 px.
Camera camera_at(int distance) { return {px(256), px(256), px(distance)}; }

/// Items in each other, the outermost first.
struct Nest {
    std::vector<RawPlacement> levels;

    Space space() const
    {
        Space all;
        for (const RawPlacement& level : levels)
            all = product(all, level.placement(), every_feature);
        return all;
    }

    Place exact(Spot at) const
    {
        Place place{at.x, at.y, 0};
        for (auto level = levels.rbegin(); level != levels.rend(); ++level)
            place = level->exact()(place);
        return place;
    }
};

Nest random_nest(std::mt19937& random)
{
    Nest nest;
    nest.levels.resize(1 + random() % 4);
    for (RawPlacement& level : nest.levels)
        level = random_placement(random);
    return nest;
}

Spot random_spot(std::mt19937& random)
{
    return {static_cast<double>(random() % 513), static_cast<double>(random() % 513)};
}

bool is_on_canvas(Spot at) { return at.x >= 0 && at.x <= 512 && at.y >= 0 && at.y <= 512; }

/// How much larger than its own area a tiny square around `at` is seen: the square root of that.
double exact_growth(const Nest& nest, Spot at, double distance)
{
    constexpr double step = 1.0 / 1024;
    const auto seen_at = [&](double x, double y) {
        return seen(nest.exact({at.x + x, at.y + y}), {256, 256}, distance);
    };
    const Spot along = (0.5 / step) * (seen_at(step, 0) - seen_at(-step, 0));
    const Spot across = (0.5 / step) * (seen_at(0, step) - seen_at(0, -step));
    return std::sqrt(std::abs(along.x * across.y - along.y * across.x));
}

Projection turned_about_y(double degrees, int distance)
{
    RawPlacement placement{.pivot_x = 256 * 16, .pivot_y = 256 * 16};
    placement.rotation_y = static_cast<std::int32_t>(std::lround(degrees / 360 * 65536));
    return {placement.placement(), camera_at(distance)};
}

}

TEST_CASE("on the canvas itself everything is seen where it is")
{
    const Projection projection{{}, camera_at(600)};
    std::mt19937 random{101};
    for (int round = 0; round < 1000; ++round) {
        const Spot at = random_spot(random);
        CHECK(projection(pixels(at.x, at.y)) == pixels(at.x, at.y));
    }
    CHECK(projection.scale_factor_at(pixels(100, 7)) == Fixed::one);
}

TEST_CASE("what is nearer is larger, about the middle of the canvas")
{
    const auto at_depth = [](double z) { return Projection{{.plane = {}, .z0 = px(z)}, camera_at(600)}; };
    CHECK(at_depth(300)(pixels(256, 256)) == pixels(256, 256));
    CHECK(at_depth(300)(pixels(266, 236)) == pixels(276, 216));
    CHECK(at_depth(-600)(pixels(266, 236)) == pixels(261, 246));
    CHECK(at_depth(300).scale_factor_at(pixels(266, 236)) == 2 * Fixed::one);
    CHECK(at_depth(-600).scale_factor_at(pixels(266, 236)) == Fixed::one / 2);
}

TEST_CASE("a rotation about y takes the right edge away, one about x the upper edge, as in CSS")
{
    const Projection about_y = turned_about_y(60, 600);
    CHECK(std::abs(about_y(pixels(356, 256)).x.raw() / 65536.0 - (256 + 50 * 600 / (600 + 86.6025))) < 0.01);
    CHECK(about_y(pixels(356, 300)).y < Fixed::pixels(300));
    CHECK(about_y(pixels(156, 300)).y > Fixed::pixels(300));
    const RawPlacement tilted{.rotation_x = 8192, .pivot_x = 256 * 16, .pivot_y = 256 * 16};
    const Projection about_x{tilted.placement(), camera_at(600)};
    CHECK(about_x(pixels(356, 200)).x < Fixed::pixels(356));
    CHECK(about_x(pixels(356, 300)).x > Fixed::pixels(356));
}

TEST_CASE(
    "items up to four deep are seen within 1/16 px up to twice as large, within 1/8 px up to four times")
{
    std::mt19937 random{102};
    double worst = 0;
    double worst_near = 0;
    int seen_points = 0;
    for (int round = 0; round < rounds(6000); ++round) {
        const Nest nest = random_nest(random);
        const int distance = std::uniform_int_distribution<int>{512, 2000}(random);
        const Projection projection{nest.space(), camera_at(distance)};
        for (int point = 0; point < 8; ++point) {
            const Spot at = random_spot(random);
            const Place place = nest.exact(at);
            const double left = distance - place.z;
            const Spot exact = seen(place, {256, 256}, distance);
            if (left < distance / 4.0 || !is_on_canvas(exact))
                continue;
            ++seen_points;
            double& max = left < distance / 2.0 ? worst_near : worst;
            max = std::max(max, apart(projection(pixels(at.x, at.y)), exact));
        }
    }
    CHECK(seen_points > rounds(10'000));
    CHECK(worst < 1.0 / 16);
    CHECK(worst_near < 1.0 / 8);
}

TEST_CASE("what a space says is seen within 1/64 px, less than 512 px from the middle")
{
    std::mt19937 random{105};
    double worst = 0;
    for (int round = 0; round < rounds(3000); ++round) {
        const Space space = random_nest(random).space();
        const int distance = std::uniform_int_distribution<int>{16, 32767}(random);
        const Projection projection{space, camera_at(distance)};
        for (int point = 0; point < 8; ++point) {
            const Spot at = random_spot(random);
            const auto sum = [&at](std::int32_t x, std::int32_t y, std::int64_t shift) {
                return (x * at.x + y * at.y + static_cast<double>(shift)) / 65536;
            };
            const Place place{sum(space.plane.xx, space.plane.xy, space.plane.x0),
                              sum(space.plane.yx, space.plane.yy, space.plane.y0),
                              sum(space.zx, space.zy, space.z0)};
            if (distance - place.z < distance / 16.0)
                continue;
            const Spot exact = seen(place, {256, 256}, distance);
            if (std::hypot(exact.x - 256, exact.y - 256) < 512)
                worst = std::max(worst, apart(projection(pixels(at.x, at.y)), exact));
        }
    }
    CHECK(worst < 1.0 / 64);
}

TEST_CASE("growth is the square root of what a small area grows by")
{
    std::mt19937 random{103};
    double worst = 0;
    for (int round = 0; round < rounds(3000); ++round) {
        const Nest nest = random_nest(random);
        const int distance = std::uniform_int_distribution<int>{512, 2000}(random);
        const Projection projection{nest.space(), camera_at(distance)};
        const Spot at = random_spot(random);
        const Place place = nest.exact(at);
        if (distance - place.z < distance / 4.0 || !is_on_canvas(seen(place, {256, 256}, distance)))
            continue;
        const double exact = exact_growth(nest, at, distance);
        const double is = projection.scale_factor_at(pixels(at.x, at.y)) / 65536.0;
        if (exact > 0.05) // seen from the side, it is the root of next to nothing
            worst = std::max(worst, std::abs(is - exact) / exact);
    }
    CHECK(worst < 0.01);
}

TEST_CASE("what comes nearer than a sixteenth of the distance is held there, also behind the viewer")
{
    const auto at_depth = [](double z) { return Projection{{.plane = {}, .z0 = px(z)}, camera_at(640)}; };
    const Point nearest = at_depth(600)(pixels(257, 253));
    CHECK(nearest == pixels(272, 208));
    for (const double z : {601.0, 640.0, 641.0, 1e5, 1e9}) {
        CHECK(at_depth(z)(pixels(257, 253)) == nearest);
        CHECK(at_depth(z).scale_factor_at(pixels(257, 253)) == 16 * Fixed::one);
    }
}

TEST_CASE("a plane that is turned through the viewer is seen without a jump to the other side")
{
    for (int degrees = -360; degrees <= 360; degrees += 5) {
        const Projection projection = turned_about_y(degrees, 100);
        for (const int x : {-1500, 0, 255, 257, 1500}) {
            const double c = std::cos(degrees / 180.0 * std::numbers::pi);
            const Fixed at = projection(pixels(x, 256)).x - Fixed::pixels(256);
            if (std::abs(c * (x - 256)) > 0.1)
                CHECK((at.raw() > 0) == (c * (x - 256) > 0));
            CHECK(std::abs(at.raw()) <= Fixed::pixels(16383 + 256).raw());
        }
    }
}

TEST_CASE("any space and any camera give a point that is held within 16383 px, and a growth of at least 0")
{
    std::mt19937 random{104};
    const auto extreme = [&random](std::int64_t max) {
        const std::int64_t values[] = {-max, max, 0, 1, static_cast<std::int64_t>(random()) % max};
        return values[random() % 5];
    };
    const auto factor = [&] { return static_cast<std::int32_t>(extreme(Affine::max_factor)); };
    const auto shift = [&] { return extreme(std::int64_t{1} << 48); };
    for (int round = 0; round < 20'000; ++round) {
        const Space space{.plane = {.xx = factor(),
                                    .xy = factor(),
                                    .yx = factor(),
                                    .yy = factor(),
                                    .x0 = shift(),
                                    .y0 = shift()},
                          .xz = factor(),
                          .yz = factor(),
                          .zx = factor(),
                          .zy = factor(),
                          .zz = factor(),
                          .z0 = shift()};
        const std::int64_t distance = 1 + std::abs(extreme((std::int64_t{1} << 44) - 2));
        const Projection projection{space, {px(2048), px(2048), distance}};
        const auto raw = [&] { return Fixed::from_raw(static_cast<std::int32_t>(extreme(16383 << 16))); };
        const Point point{raw(), raw()};
        const Point at = projection(point);
        CHECK(std::abs(at.x.raw()) <= Fixed::pixels(16383).raw());
        CHECK(std::abs(at.y.raw()) <= Fixed::pixels(16383).raw());
        CHECK(projection.scale_factor_at(point) >= 0);
    }
}

}
