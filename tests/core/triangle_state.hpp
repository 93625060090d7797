#pragma once

#include "core/item_state.hpp"
#include "tests/core/array_drawing.hpp"
#include "tests/core/raw_drawing.hpp"
#include "tests/core/raw_scene.hpp"

#include <doctest/doctest.h>
#include <initializer_list>

/// Of a triangle with tracks, at a moment.
namespace kfast::test {

// The numbers of its pairs of laws.
inline constexpr int accelerate_decelerate = 1; ///< accelerate for x, decelerate for y
inline constexpr int wild = 2;                  ///< both swing far beyond their ends
inline constexpr int hold_constant = 3;         ///< hold for x, constant for y

/// 40 px to the right from (10, 20), then 30 px down.
inline scene::Drawing bow() { return {{polyline_of({{160, 320}, {800, 320}, {800, 800}})}}; }

/// Black, white, half transparent red; a filled and stroked triangle, 2 px wide, red on white.
inline ItemState state_of(std::initializer_list<Bytes> tracks, Time time = {}, const Bytes& path = {})
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

inline Point shift_of(const ItemState& state) { return state.placement().plane(pixels(0, 0)); }

}
