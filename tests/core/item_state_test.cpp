#include "core/item_state.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/exact_hermite.hpp"
#include "tests/core/raw_drawing.hpp"
#include "tests/core/raw_placement.hpp"
#include "tests/core/raw_scene.hpp"
#include "tests/core/spot.hpp"

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

/// 40 px to the right from (10, 20), then 30 px down.
scene::Drawing bow() { return {{polyline_of({{160, 320}, {800, 320}, {800, 800}})}}; }

/// Along the bow, whose drawing lies behind the others.
Bytes along_bow(bool turns) { return path_bytes(turns, 11, {640, 480}); }

/// Black, white, half transparent red; a filled and stroked triangle, 2 px wide, red on white.
ItemState state_of(std::initializer_list<Bytes> tracks, Time time = {}, const Bytes& path = {})
{
    RawScene scene;
    scene.drawings = joined({scene.drawings, packed(bow())});
    scene.law_count = 3;
    scene.laws = bytes({0x21,                                        //
                        0x66, 0, 0, 0x00, 0xC0, 0, 0x20, 0x00, 0x60, // y from -2 to 3
                        0, 0, 0x00, 0xC0, 0, 0x20, 0x00, 0x60,       //
                        0x04});
    const auto count = static_cast<int>(tracks.size());
    scene.items = joined({count == 0 ? bytes({0x18}) : bytes({0x1C, count}), joined(tracks), path,
                          bytes({1, 2, 32, 8}), one_key()});
    const Bytes file = scene.file();
    const auto view = SceneView::parse(file);
    REQUIRE(view);
    return {*view, view->items().next(), time};
}

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

Point shift_of(const ItemState& state) { return state.placement().plane(pixels(0, 0)); }

}

TEST_CASE("without tracks an item is as it was drawn")
{
    const ItemState state = state_of({});
    CHECK(state.placement().plane == Affine{});
    CHECK(state.opacity() == 255);
    CHECK(state.fill() == Colour{255, 255, 255});
    CHECK(state.stroke() == Colour{255, 0, 0, 128});
    CHECK(state.width() == Fixed::pixels(2));
}

TEST_CASE("a position moves, down with y")
{
    const ItemState state = state_of({fixed_track(Property::x, -24), fixed_track(Property::y, 16 * 5)});
    CHECK(state.placement().plane(pixels(3, 4)) == pixels(1.5, 9));
}

TEST_CASE("a quarter turn is clockwise, about the pivot")
{
    const ItemState about_origin = state_of({fixed_track(Property::rotation, 16384)});
    CHECK(about_origin.placement().plane(pixels(10, 0)) == pixels(0, 10));
    CHECK(about_origin.placement().plane(pixels(0, 10)) == pixels(-10, 0));
    const ItemState about_pivot =
        state_of({fixed_track(Property::rotation, 16384), fixed_track(Property::pivot_x, 16 * 8),
                  fixed_track(Property::pivot_y, 16 * 3)});
    CHECK(about_pivot.placement().plane(pixels(8, 3)) == pixels(8, 3));
    CHECK(about_pivot.placement().plane(pixels(10, 3)) == pixels(8, 5));
    CHECK(state_of({fixed_track(Property::rotation, 16 * 65536)}).placement().plane == Affine{});
}

TEST_CASE("scales apply before the rotation and mirror where they are negative")
{
    const ItemState state =
        state_of({fixed_track(Property::x, 16), fixed_track(Property::rotation, 16384),
                  fixed_track(Property::scale_x, 8192), fixed_track(Property::scale_y, -4096)});
    CHECK(state.placement().plane(pixels(3, 0)) == pixels(1, 6));
    CHECK(state.placement().plane(pixels(0, 3)) == pixels(4, 0));
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
        furthest = std::max(furthest, apart(state.placement().plane(pixels(at.x, at.y)), values.place(at)));
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
    CHECK(apart(grown.placement().plane(pixels(10, 10)), {10 - 20 * accelerated, 100 * decelerated}) < 0.001);
    const ItemState turned = state_of({between(Property::rotation, 0, 131'072)}, half);
    const double angle = 4 * std::numbers::pi * accelerated;
    CHECK(apart(turned.placement().plane(pixels(10, 0)), {10 * std::cos(angle), 10 * std::sin(angle)}) <
          0.001);
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
    CHECK(swinging(Property::x, 0, 160, 1).placement().plane.x0 < 0);
    CHECK(swinging(Property::x, 0, 160, 9).placement().plane.x0 > 10 * Fixed::one);
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
            const Affine placement = state.placement().plane;
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
        return order_at(ItemCursor{ByteReader{item}}.next(), Time{ticks});
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

TEST_CASE("a smooth track goes by the curve through its keys")
{
    const std::vector<RawTrackKey> keys{{Time::frame(1), 0, 0},
                                        {Time::frame(2), 0, 1600},
                                        {Time::frame(5), 0, 400},
                                        {Time::frame(9), 0, 2000}};
    std::vector<KeyTime> times;
    for (const RawTrackKey& key : keys)
        times.push_back({key.time, key.value});
    const ExactHermite exact{times};
    for (int ticks = 0; ticks < 10 * 1024; ticks += 100) {
        const Time time{ticks};
        const double value = exact.at(time);
        const ItemState state =
            state_of({smooth_track(Property::x, keys), smooth_track(Property::y, keys)}, time);
        CHECK(apart(shift_of(state), {value / 16, value / 16}) < 0.005);
        const ItemState turned = state_of({smooth_track(Property::rotation, keys)}, time);
        const double turns = value / 65536 * 2 * std::numbers::pi;
        CHECK(apart(turned.placement().plane(pixels(100, 0)),
                    {100 * std::cos(turns), 100 * std::sin(turns)}) < 0.005);
        const ItemState thick = state_of({smooth_track(Property::width, keys)}, time);
        CHECK(std::abs(thick.width().raw() / 65536.0 - value / 16) < 0.005);
    }
}

TEST_CASE("a smooth track that swings beyond its range is held at it")
{
    const auto opacity_at = [](int tenths) {
        return state_of({smooth_track(Property::opacity, {{{}, 0, 0},
                                                          {Time::frame(5), 0, 255},
                                                          {{5 * 1024 + 1}, 0, 255},
                                                          {Time::frame(9), 0, 0}})},
                        {tenths * 1024 / 10})
            .opacity();
    };
    for (int tenths = 0; tenths < 100; ++tenths)
        CHECK(opacity_at(tenths) <= 255);
    CHECK(opacity_at(50) == 255);
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
    for (int round = 0; round < 5000; ++round) {
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
