#include "core/pose/item_state.hpp"

#include "tests/core/spot.hpp"
#include "tests/core/time/exact_hermite.hpp"
#include "tests/core/triangle_state.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace kfast::test {

TEST_CASE("without tracks an item is as it was drawn")
{
    const OwnedState state = state_of({});
    CHECK(state.placement().plane == Affine{});
    CHECK(state.opacity() == 255);
    CHECK(state.fill() == Colour{255, 255, 255});
    CHECK(state.stroke() == Colour{255, 0, 0, 128});
    CHECK(state.width() == Fixed::pixels(2));
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
    const OwnedState moved = state_of({between(Property::x, 16, 161), between(Property::y, -32, 133)}, half);
    CHECK(apart(shift_of(moved), {1 + 145 / 16.0 * accelerated, -2 + 165 / 16.0 * decelerated}) < 0.001);
    const OwnedState grown =
        state_of({between(Property::scale_x, 4096, -4096), between(Property::scale_y, 0, 40'960)}, half);
    CHECK(apart(grown.placement().plane(pixels(10, 10)), {10 - 20 * accelerated, 100 * decelerated}) < 0.001);
    const OwnedState turned = state_of({between(Property::rotation, 0, 131'072)}, half);
    const double angle = 4 * std::numbers::pi * accelerated;
    CHECK(apart(turned.placement().plane(pixels(10, 0)), {10 * std::cos(angle), 10 * std::sin(angle)}) <
          0.001);
    const OwnedState swung =
        state_of({fixed_track(Property::scale_x, 0), fixed_track(Property::scale_y, 0),
                  between(Property::pivot_x, 0, 160), between(Property::pivot_y, 0, 160)},
                 half);
    CHECK(apart(shift_of(swung), {10 * accelerated, 10 * accelerated}) < 0.001);
    const OwnedState faded = state_of({between(Property::opacity, 255, 0)}, half);
    CHECK(faded.opacity() == std::lround(255 * (1 - accelerated)));
    const OwnedState thinned = state_of({between(Property::width, 16, 161)}, half);
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

TEST_CASE("visible holds until the next key, whatever the law")
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
    std::vector<KeySample> times;
    times.reserve(keys.size());
    for (const RawTrackKey& key : keys)
        times.push_back({key.time, key.value});
    const ExactHermite exact{times};
    for (int ticks = 0; ticks < 10 * 1024; ticks += 100) {
        const Time time{ticks};
        const double value = exact.at(time);
        const OwnedState state =
            state_of({smooth_track(Property::x, keys), smooth_track(Property::y, keys)}, time);
        CHECK(apart(shift_of(state), {value / 16, value / 16}) < 0.005);
        const OwnedState turned = state_of({smooth_track(Property::rotation, keys)}, time);
        const double turns = value / 65536 * 2 * std::numbers::pi;
        CHECK(apart(turned.placement().plane(pixels(100, 0)),
                    {100 * std::cos(turns), 100 * std::sin(turns)}) < 0.005);
        const OwnedState thick = state_of({smooth_track(Property::width, keys)}, time);
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

}
