#pragma once

#include "core/pose/item_state.hpp"
#include "tests/core/math/exact_space.hpp"
#include "tests/core/moved_scene.hpp"
#include "tests/core/raw_scene.hpp"

#include <cstdint>
#include <random>

namespace kfast::test {

/// Fixed tracks of an item, in the units of the scene format, and what they come to.
struct RawPlacement {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t z = 0;
    std::int32_t rotation_x = 0;
    std::int32_t rotation_y = 0;
    std::int32_t rotation = 0;
    std::int32_t scale_x = scale_one;
    std::int32_t scale_y = scale_one;
    std::int32_t pivot_x = 0;
    std::int32_t pivot_y = 0;

    static constexpr int count = 10;

    /// As a scene has them, without their number.
    Bytes tracks() const
    {
        return joined({fixed_track(Property::x, x), fixed_track(Property::y, y), fixed_track(Property::z, z),
                       fixed_track(Property::rotation_x, rotation_x),
                       fixed_track(Property::rotation_y, rotation_y),
                       fixed_track(Property::rotation, rotation), fixed_track(Property::scale_x, scale_x),
                       fixed_track(Property::scale_y, scale_y), fixed_track(Property::pivot_x, pivot_x),
                       fixed_track(Property::pivot_y, pivot_y)});
    }

    Space placement() const
    {
        RawScene raw;
        raw.items = tracked(count, tracks());
        const Bytes file = raw.file();
        const SceneView scene = *SceneView::parse(file);
        MovedScene moved{scene};
        const PreparedScene& prepared = moved.at({});
        return ItemState{scene, prepared, prepared.nodes()[1]}.placement();
    }

    ItemValues exact() const
    {
        return {.position = {x / 16.0, y / 16.0, z / 16.0},
                .pivot = {pivot_x / 16.0, pivot_y / 16.0},
                .scale = {scale_x / 4096.0, scale_y / 4096.0},
                .turns_x = rotation_x / 65536.0,
                .turns_y = rotation_y / 65536.0,
                .turns = rotation / 65536.0};
    }
};

/// Moves by up to 100 px, in any direction of space, turns any way about a pivot on a canvas of 512 px, and
/// changes sizes by up to a quarter.
inline RawPlacement random_placement(std::mt19937& random)
{
    const auto within = [&random](std::int32_t min, std::int32_t max) {
        return std::uniform_int_distribution<std::int32_t>{min, max}(random);
    };
    RawPlacement placement;
    for (const auto shift : {&RawPlacement::x, &RawPlacement::y, &RawPlacement::z})
        placement.*shift = within(-1600, 1600);
    for (const auto turn : {&RawPlacement::rotation_x, &RawPlacement::rotation_y, &RawPlacement::rotation})
        placement.*turn = random() % 3 == 0 ? 0 : within(-1'048'576, 1'048'576);
    for (const auto scale : {&RawPlacement::scale_x, &RawPlacement::scale_y})
        placement.*scale = within(3072, 5120) * (random() % 4 == 0 ? -1 : 1);
    for (const auto pivot : {&RawPlacement::pivot_x, &RawPlacement::pivot_y})
        placement.*pivot = within(0, 512 * 16);
    return placement;
}

}
