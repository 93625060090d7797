#include "core/pose/item_state.hpp"

#include "tests/core/raw_placement.hpp"
#include "tests/core/spot.hpp"
#include "tests/core/triangle_state.hpp"
#include "tests/rounds.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <initializer_list>
#include <numbers>
#include <random>

/// Where the tracks and the path of an item put it.
namespace kfast::test {
namespace {

/// Along the bow, whose drawing lies behind the others.
Bytes along_bow(bool turns) { return path_bytes(turns, 11, {640, 480}); }

/// What a triangle's tracks say, in pixels, turns and factors.
struct Values {
    Spot position;
    Spot pivot;
    Spot scale;
    double turns;

    /// Scales, then turns clockwise, both about the pivot, then moves.
    Spot place(Spot p) const
    {
        const Spot grown{(p.x - pivot.x) * scale.x, (p.y - pivot.y) * scale.y};
        const double angle = turns * 2 * std::numbers::pi;
        const double along = std::cos(angle);
        const double across = std::sin(angle);
        return {position.x + pivot.x + along * grown.x - across * grown.y,
                position.y + pivot.y + across * grown.x + along * grown.y};
    }
};

}

TEST_CASE("a position moves, down with y")
{
    const OwnedState state = state_of({fixed_track(Property::x, -24), fixed_track(Property::y, 16 * 5)});
    CHECK(state.placement().plane(pixels(3, 4)) == pixels(1.5, 9));
}

TEST_CASE("a quarter turn is clockwise, about the pivot")
{
    const OwnedState about_origin = state_of({fixed_track(Property::rotation, 16384)});
    CHECK(about_origin.placement().plane(pixels(10, 0)) == pixels(0, 10));
    CHECK(about_origin.placement().plane(pixels(0, 10)) == pixels(-10, 0));
    const OwnedState about_pivot =
        state_of({fixed_track(Property::rotation, 16384), fixed_track(Property::pivot_x, 16 * 8),
                  fixed_track(Property::pivot_y, 16 * 3)});
    CHECK(about_pivot.placement().plane(pixels(8, 3)) == pixels(8, 3));
    CHECK(about_pivot.placement().plane(pixels(10, 3)) == pixels(8, 5));
    CHECK(state_of({fixed_track(Property::rotation, 16 * 65536)}).placement().plane == Affine{});
}

TEST_CASE("scales apply before the rotation and mirror where they are negative")
{
    const OwnedState state =
        state_of({fixed_track(Property::x, 16), fixed_track(Property::rotation, 16384),
                  fixed_track(Property::scale_x, 8192), fixed_track(Property::scale_y, -4096)});
    CHECK(state.placement().plane(pixels(3, 0)) == pixels(1, 6));
    CHECK(state.placement().plane(pixels(0, 3)) == pixels(4, 0));
}

TEST_CASE("any placement is within 1/1000 px, at 30 px from the pivot")
{
    std::mt19937 random{51};
    const auto within = [&random](std::int32_t min, std::int32_t max) {
        return std::uniform_int_distribution<std::int32_t>{min, max}(random);
    };
    double furthest = 0;
    for (int round = 0; round < rounds(5000); ++round) {
        const std::int32_t x = within(-16 * 500, 16 * 500);
        const std::int32_t y = within(-16 * 500, 16 * 500);
        const std::int32_t rotation = within(-1'048'576, 1'048'576);
        const std::int32_t scale_x = within(-262'144, 262'144);
        const std::int32_t scale_y = within(-262'144, 262'144);
        const std::int32_t pivot_x = within(-16 * 500, 16 * 500);
        const std::int32_t pivot_y = within(-16 * 500, 16 * 500);
        const OwnedState state =
            state_of({fixed_track(Property::x, x), fixed_track(Property::y, y),
                      fixed_track(Property::rotation, rotation), fixed_track(Property::scale_x, scale_x),
                      fixed_track(Property::scale_y, scale_y), fixed_track(Property::pivot_x, pivot_x),
                      fixed_track(Property::pivot_y, pivot_y)});
        const Values values{.position = {x / 16.0, y / 16.0},
                            .pivot = {pivot_x / 16.0, pivot_y / 16.0},
                            .scale = {scale_x / 4096.0, scale_y / 4096.0},
                            .turns = rotation / 65536.0};
        const Spot at{values.pivot.x + within(-20, 20), values.pivot.y + within(-20, 20)};
        furthest = std::max(furthest, apart(state.placement().plane(pixels(at.x, at.y)), values.place(at)));
    }
    CHECK(furthest < 0.001);
}

TEST_CASE("the largest values and the wildest laws stay within the range of placements")
{
    for (const int frame : {1, 2, 8, 9})
        for (const int sign : {-1, 1}) {
            const auto swinging = [sign](Property property, std::int32_t max) {
                return moving_track(property, {{{}, wild, sign * max}, {Time::frame(10), 0, -sign * max}});
            };
            const OwnedState state =
                state_of({swinging(Property::x, 32767), swinging(Property::y, 32767),
                          swinging(Property::rotation, 1'048'576), swinging(Property::scale_x, 262'144),
                          swinging(Property::scale_y, 262'144), swinging(Property::pivot_x, 32767),
                          swinging(Property::pivot_y, 32767)},
                         Time::frame(frame));
            constexpr std::int64_t furthest = std::int64_t{65536} << 16;
            const Affine placement = state.placement().plane;
            CHECK(std::abs(placement.x0) <= furthest);
            CHECK(std::abs(placement.y0) <= furthest);
            CHECK(std::max(std::abs(placement.x0), std::abs(placement.y0)) == furthest);
            CHECK(std::hypot(placement.xx, placement.yx) <= 4.0 * 64 * 65536 + 1);
        }
}

TEST_CASE("an item's pivot lies on its path, and x and y are added")
{
    const auto along = [](std::int32_t share) { return fixed_track(Property::along, share); };
    const auto put = [](std::initializer_list<Bytes> tracks, Point point) {
        return state_of(tracks, {}, along_bow(false)).placement().plane(point);
    };
    CHECK(put({along(0)}, pixels(0, 0)) == pixels(10, 20));
    CHECK(put({along(65536)}, pixels(0, 0)) == pixels(50, 50));
    CHECK(apart(put({along(65536 * 2 / 7)}, pixels(1, 2)), {31, 22}) < 0.001);
    const Bytes pivot_x = fixed_track(Property::pivot_x, 160);
    const Bytes pivot_y = fixed_track(Property::pivot_y, 80);
    CHECK(put({pivot_x, pivot_y, along(0)}, pixels(10, 5)) == pixels(10, 20));
    CHECK(put({pivot_x, pivot_y, along(0)}, pixels(13, 5)) == pixels(13, 20));
    CHECK(put({fixed_track(Property::x, 16), fixed_track(Property::y, -32), along(0)}, pixels(0, 0)) ==
          pixels(11, 18));
}

TEST_CASE("an item that turns with its path adds the path's direction to its rotation")
{
    const auto turned = [](std::int32_t rotation, std::int32_t share, bool turns) {
        return state_of({fixed_track(Property::rotation, rotation), fixed_track(Property::along, share)}, {},
                        along_bow(turns))
            .placement()
            .plane(pixels(8, 0));
    };
    CHECK(turned(0, 0, true) == pixels(18, 20));
    CHECK(turned(0, 65536, true) == pixels(50, 58));
    CHECK(turned(0, 65536, false) == pixels(58, 50));
    CHECK(turned(16384, 65536, true) == pixels(42, 50));
    CHECK(turned(-16384, 65536, true) == pixels(58, 50));
}

TEST_CASE("an item follows its path by its laws, or smoothly")
{
    const auto at = [](const Bytes& track, int frame) {
        return shift_of(state_of({track}, Time::frame(frame), along_bow(false)));
    };
    const std::vector<RawTrackKey> keys{{{}, 0, 0}, {Time::frame(8), 0, 65536}};
    CHECK(apart(at(moving_track(Property::along, keys), 2), {10 + 17.5, 20}) < 0.001);
    CHECK(apart(at(smooth_track(Property::along, keys), 2), {10 + 70 * 0.15625, 20}) < 0.001);
    const std::vector<RawTrackKey> accelerated{{{}, accelerate_decelerate, 0}, {Time::frame(8), 0, 65536}};
    CHECK(apart(at(moving_track(Property::along, accelerated), 4),
                {10 + 70 * (1 - std::numbers::sqrt2 / 2), 20}) < 0.001);
    const std::vector<RawTrackKey> swinging{{{}, wild, 0}, {Time::frame(10), 0, 65536}};
    CHECK(at(moving_track(Property::along, swinging), 1) == pixels(10, 20));
    CHECK(at(moving_track(Property::along, swinging), 9) == pixels(50, 50));
}

TEST_CASE("any placement in space is within 1/64 px of the exact one, on a canvas of 512 px")
{
    std::mt19937 random{52};
    double worst = 0;
    for (int round = 0; round < rounds(5000); ++round) {
        const RawPlacement raw = random_placement(random);
        const Space space = raw.placement();
        const Spot at{static_cast<double>(random() % 513), static_cast<double>(random() % 513)};
        const Place exact = raw.exact()({at.x, at.y, 0});
        worst = std::max(worst, apart(space.plane(pixels(at.x, at.y)), {exact.x, exact.y}));
        const double z = (space.zx * at.x + space.zy * at.y + static_cast<double>(space.z0)) / 65536;
        worst = std::max(worst, std::abs(z - exact.z));
    }
    CHECK(worst < 1.0 / 64);
}

TEST_CASE("only what leaves the plane of the canvas is not flat")
{
    CHECK(state_of({fixed_track(Property::rotation, 1234)}).placement().is_flat());
    CHECK(state_of({fixed_track(Property::rotation_x, 65536)}).placement().is_flat());
    CHECK(state_of({fixed_track(Property::rotation_y, 32768)}).placement().plane ==
          Affine{.xx = -Fixed::one});
    CHECK_FALSE(state_of({fixed_track(Property::z, 1)}).placement().is_flat());
    CHECK_FALSE(state_of({fixed_track(Property::rotation_x, 9)}).placement().is_flat());
    CHECK_FALSE(state_of({fixed_track(Property::rotation_y, -9)}).placement().is_flat());
}

}
