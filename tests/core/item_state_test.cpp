#include "core/item_state.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/raw_scene.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <initializer_list>
#include <numbers>
#include <random>

namespace kfast::test {
namespace {

constexpr int accelerate_decelerate = 1; ///< accelerate for x, decelerate for y
constexpr int wild = 2;                  ///< both swing far beyond their ends
constexpr int hold_constant = 3;         ///< hold for x, constant for y

/// Black, white, half transparent red; a filled and stroked triangle, 2 px wide, red on white.
ItemState state_of(std::initializer_list<Bytes> tracks, Time time = {})
{
    RawScene scene;
    scene.law_count = 3;
    scene.laws = bytes({0x21,                                        //
                        0x66, 0, 0, 0x00, 0xC0, 0, 0x20, 0x00, 0x60, // y from -2 to 3
                        0, 0, 0x00, 0xC0, 0, 0x20, 0x00, 0x60,       //
                        0x04});
    const auto count = static_cast<int>(tracks.size());
    scene.items = joined({count == 0 ? bytes({0x18}) : bytes({0x1C, count}), joined(tracks),
                          bytes({1, 2, 32, 8, 8}), varint(900), bytes({4, 0, 0, 1, 0})});
    const Bytes file = scene.file();
    const auto view = SceneView::parse(file);
    REQUIRE(view);
    return {*view, view->items().next(), time};
}

struct Spot {
    double x;
    double y;
};

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

double apart(Point placed, Spot exact)
{
    return std::hypot(placed.x.raw() / 65536.0 - exact.x, placed.y.raw() / 65536.0 - exact.y);
}

Point shift_of(const ItemState& state) { return state.placement()(pixels(0, 0)); }

}

TEST_CASE("without tracks an item is as it was drawn")
{
    const ItemState state = state_of({});
    CHECK(state.placement() == Affine{});
    CHECK(state.opacity() == 255);
    CHECK(state.fill() == Colour{255, 255, 255});
    CHECK(state.stroke() == Colour{255, 0, 0, 128});
    CHECK(state.width() == Fixed::pixels(2));
}

TEST_CASE("a position moves, down with y")
{
    const ItemState state = state_of({fixed_track(Property::x, -24), fixed_track(Property::y, 16 * 5)});
    CHECK(state.placement()(pixels(3, 4)) == pixels(1.5, 9));
}

TEST_CASE("a quarter turn is clockwise, about the pivot")
{
    const ItemState about_origin = state_of({fixed_track(Property::rotation, 16384)});
    CHECK(about_origin.placement()(pixels(10, 0)) == pixels(0, 10));
    CHECK(about_origin.placement()(pixels(0, 10)) == pixels(-10, 0));
    const ItemState about_pivot =
        state_of({fixed_track(Property::rotation, 16384), fixed_track(Property::pivot_x, 16 * 8),
                  fixed_track(Property::pivot_y, 16 * 3)});
    CHECK(about_pivot.placement()(pixels(8, 3)) == pixels(8, 3));
    CHECK(about_pivot.placement()(pixels(10, 3)) == pixels(8, 5));
    CHECK(state_of({fixed_track(Property::rotation, 16 * 65536)}).placement() == Affine{});
}

TEST_CASE("scales apply before the rotation and mirror where they are negative")
{
    const ItemState state =
        state_of({fixed_track(Property::x, 16), fixed_track(Property::rotation, 16384),
                  fixed_track(Property::scale_x, 8192), fixed_track(Property::scale_y, -4096)});
    CHECK(state.placement()(pixels(3, 0)) == pixels(1, 6));
    CHECK(state.placement()(pixels(0, 3)) == pixels(4, 0));
}

TEST_CASE("any placement is within 1/1000 px, at 30 px from the pivot")
{
    std::mt19937 random{51};
    const auto within = [&random](std::int32_t least, std::int32_t most) {
        return std::uniform_int_distribution<std::int32_t>{least, most}(random);
    };
    double furthest = 0;
    for (int round = 0; round < 5000; ++round) {
        const std::int32_t x = within(-16 * 500, 16 * 500);
        const std::int32_t y = within(-16 * 500, 16 * 500);
        const std::int32_t rotation = within(-1'048'576, 1'048'576);
        const std::int32_t scale_x = within(-262'144, 262'144);
        const std::int32_t scale_y = within(-262'144, 262'144);
        const std::int32_t pivot_x = within(-16 * 500, 16 * 500);
        const std::int32_t pivot_y = within(-16 * 500, 16 * 500);
        const ItemState state =
            state_of({fixed_track(Property::x, x), fixed_track(Property::y, y),
                      fixed_track(Property::rotation, rotation), fixed_track(Property::scale_x, scale_x),
                      fixed_track(Property::scale_y, scale_y), fixed_track(Property::pivot_x, pivot_x),
                      fixed_track(Property::pivot_y, pivot_y)});
        const Values values{.position = {x / 16.0, y / 16.0},
                            .pivot = {pivot_x / 16.0, pivot_y / 16.0},
                            .scale = {scale_x / 4096.0, scale_y / 4096.0},
                            .turns = rotation / 65536.0};
        const Spot at{values.pivot.x + within(-20, 20), values.pivot.y + within(-20, 20)};
        furthest = std::max(furthest, apart(state.placement()(pixels(at.x, at.y)), values.place(at)));
    }
    CHECK(furthest < 0.001);
}

TEST_CASE(
    "between keys, x and scale-x go by the law for x, y and scale-y by that for y, the rest by that for x")
{
    const auto between = [](Property property, std::int32_t from, std::int32_t to) {
        return moving_track(property,
                            {{Time::frame(2), accelerate_decelerate, from}, {Time::frame(6), 0, to}});
    };
    constexpr double accelerated = 1 - std::numbers::sqrt2 / 2;
    constexpr double decelerated = std::numbers::sqrt2 / 2;
    const Time half = Time::frame(4);
    const ItemState moved = state_of({between(Property::x, 16, 161), between(Property::y, -32, 133)}, half);
    CHECK(apart(shift_of(moved), {1 + 145 / 16.0 * accelerated, -2 + 165 / 16.0 * decelerated}) < 0.001);
    const ItemState grown =
        state_of({between(Property::scale_x, 4096, -4096), between(Property::scale_y, 0, 40'960)}, half);
    CHECK(apart(grown.placement()(pixels(10, 10)), {10 - 20 * accelerated, 100 * decelerated}) < 0.001);
    const ItemState turned = state_of({between(Property::rotation, 0, 131'072)}, half);
    const double angle = 4 * std::numbers::pi * accelerated;
    CHECK(apart(turned.placement()(pixels(10, 0)), {10 * std::cos(angle), 10 * std::sin(angle)}) < 0.001);
    const ItemState swung = state_of({fixed_track(Property::scale_x, 0), fixed_track(Property::scale_y, 0),
                                      between(Property::pivot_x, 0, 160), between(Property::pivot_y, 0, 160)},
                                     half);
    CHECK(apart(shift_of(swung), {10 * accelerated, 10 * accelerated}) < 0.001);
    const ItemState faded = state_of({between(Property::opacity, 255, 0)}, half);
    CHECK(faded.opacity() == std::lround(255 * (1 - accelerated)));
    const ItemState thinned = state_of({between(Property::width, 16, 161)}, half);
    CHECK(std::abs(thinned.width().raw() / 65536.0 - (1 + 145 / 16.0 * accelerated)) < 0.001);
}

TEST_CASE("before the first key and behind the last one a track holds their values")
{
    const auto x_at = [](Time time) {
        return shift_of(state_of({moving_track(Property::x, {{Time::frame(2), 0, 16},
                                                             {Time::frame(4), 0, 48},
                                                             {Time::frame(8), 0, 16 * 11}})},
                                 time))
            .x;
    };
    CHECK(x_at({}) == Fixed::pixels(1));
    CHECK(x_at(Time::frame(2)) == Fixed::pixels(1));
    CHECK(x_at(Time::frame(3)) == Fixed::pixels(2));
    CHECK(x_at(Time::frame(4)) == Fixed::pixels(3));
    CHECK(x_at(Time::frame(5)) == Fixed::pixels(5));
    CHECK(x_at(Time::frame(8)) == Fixed::pixels(11));
    CHECK(x_at(Time::frame(9)) == Fixed::pixels(11));
}

TEST_CASE("what swings beyond its end is held at it: opacity, channels of colours, width")
{
    const auto swinging = [](Property property, std::int32_t from, std::int32_t to, int frame) {
        return state_of({moving_track(property, {{{}, wild, from}, {Time::frame(10), 0, to}})},
                        Time::frame(frame));
    };
    // at frame 1 the way is below 0, at frame 9 above 1
    CHECK(swinging(Property::x, 0, 160, 1).placement().x0 < 0);
    CHECK(swinging(Property::x, 0, 160, 9).placement().x0 > 10 * Fixed::one);
    CHECK(swinging(Property::opacity, 0, 255, 1).opacity() == 0);
    CHECK(swinging(Property::opacity, 0, 255, 9).opacity() == 255);
    CHECK(swinging(Property::opacity, 255, 0, 1).opacity() == 255);
    CHECK(swinging(Property::opacity, 255, 0, 9).opacity() == 0);
    CHECK(swinging(Property::width, 0, 160, 1).width() == Fixed{});
    CHECK(swinging(Property::width, 0, 160, 9).width() > Fixed::pixels(10));
    CHECK(swinging(Property::width, 160, 0, 9).width() == Fixed{});
    CHECK(swinging(Property::fill, 0, 1, 1).fill() == Colour{0, 0, 0});
    CHECK(swinging(Property::fill, 0, 1, 9).fill() == Colour{255, 255, 255});
    CHECK(swinging(Property::stroke, 2, 1, 1).stroke() ==
          Colour{255, 0, 0, swinging(Property::stroke, 2, 1, 1).stroke().opacity});
    CHECK(swinging(Property::stroke, 2, 1, 9).stroke() == Colour{255, 255, 255, 255});
    CHECK(swinging(Property::stroke, 2, 1, 1).stroke().opacity < 128);
}

TEST_CASE("the largest values and the wildest laws stay within the range of placements")
{
    for (const int frame : {1, 2, 8, 9})
        for (const int sign : {-1, 1}) {
            const auto swinging = [sign](Property property, std::int32_t most) {
                return moving_track(property, {{{}, wild, sign * most}, {Time::frame(10), 0, -sign * most}});
            };
            const ItemState state =
                state_of({swinging(Property::x, 32767), swinging(Property::y, 32767),
                          swinging(Property::rotation, 1'048'576), swinging(Property::scale_x, 262'144),
                          swinging(Property::scale_y, 262'144), swinging(Property::pivot_x, 32767),
                          swinging(Property::pivot_y, 32767)},
                         Time::frame(frame));
            constexpr std::int64_t furthest = std::int64_t{65536} << 16;
            const Affine placement = state.placement();
            CHECK(std::abs(placement.x0) <= furthest);
            CHECK(std::abs(placement.y0) <= furthest);
            CHECK(std::max(std::abs(placement.x0), std::abs(placement.y0)) == furthest);
            CHECK(std::hypot(placement.xx, placement.yx) <= 4.0 * 64 * 65536 + 1);
        }
}

TEST_CASE("colours tween in each channel, opacity of the colour included")
{
    const auto mixed = [](Property property, int from, int to) {
        return state_of({moving_track(property, {{{}, 0, from}, {Time::frame(10), 0, to}})}, Time::frame(2));
    };
    // a fifth of the way
    CHECK(mixed(Property::fill, 0, 2).fill() == Colour{51, 0, 0, 230});
    CHECK(mixed(Property::stroke, 2, 1).stroke() == Colour{255, 51, 51, 153});
    CHECK(state_of({fixed_track(Property::fill, 2)}).fill() == Colour{255, 0, 0, 128});
    CHECK(mixed(Property::fill, 0, 2).stroke() == Colour{255, 0, 0, 128});
}

TEST_CASE("visible and order hold until the next key, whatever the law")
{
    const auto visible = moving_track(
        Property::visible, {{Time::frame(2), 0, 1}, {Time::frame(4), wild, 0}, {Time::frame(6), 0, 1}});
    const auto opacity_at = [&visible](int ticks) { return state_of({visible}, {ticks}).opacity(); };
    CHECK(opacity_at(0) == 255);
    CHECK(opacity_at(4 * 1024 - 1) == 255);
    CHECK(opacity_at(4 * 1024) == 0);
    CHECK(opacity_at(6 * 1024 - 1) == 0);
    CHECK(opacity_at(6 * 1024) == 255);
    CHECK(opacity_at(9 * 1024) == 255);
    CHECK(state_of({fixed_track(Property::visible, 0)}).opacity() == 0);
    CHECK(state_of({fixed_track(Property::opacity, 77), fixed_track(Property::visible, 1)}).opacity() == 77);
    CHECK(state_of({fixed_track(Property::opacity, 77), fixed_track(Property::visible, 0)}).opacity() == 0);
}

TEST_CASE("the order is that of the key before, 0 without a track")
{
    const auto order_of = [](const Bytes& tracks, int count, int ticks) {
        const Bytes item = tracked(count, tracks);
        return order_at(ItemCursor{ByteReader{item}}.next(), {ticks});
    };
    const auto moving =
        moving_track(Property::order,
                     {{Time::frame(2), 0, -32768}, {Time::frame(4), wild, 32767}, {Time::frame(6), 0, 5}});
    CHECK(order_of(moving, 1, 0) == -32768);
    CHECK(order_of(moving, 1, 4 * 1024 - 1) == -32768);
    CHECK(order_of(moving, 1, 4 * 1024) == 32767);
    CHECK(order_of(moving, 1, 6 * 1024) == 5);
    CHECK(order_of(moving, 1, 100 * 1024) == 5);
    CHECK(order_of(fixed_track(Property::order, -3), 1, 0) == -3);
    CHECK(order_of(fixed_track(Property::x, -3), 1, 0) == 0);
    CHECK(order_of(joined({fixed_track(Property::x, 9), fixed_track(Property::order, 4)}), 2, 0) == 4);
}

TEST_CASE("a hold ends exactly on the next key")
{
    const auto shift_at = [](int ticks) {
        return shift_of(
            state_of({moving_track(Property::x, {{{}, hold_constant, 0}, {Time::frame(2), 0, 32}}),
                      moving_track(Property::y, {{{}, hold_constant, 0}, {Time::frame(2), 0, 32}})},
                     {ticks}));
    };
    CHECK(shift_at(1024) == pixels(0, 1));
    CHECK(shift_at(2047).x == Fixed{});
    CHECK(shift_at(2048) == pixels(2, 2));
}

}
