#pragma once

#include "core/pose/item_state.hpp"
#include "tests/core/array_drawing.hpp"
#include "tests/core/moved_scene.hpp"
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

/// The pairs with these numbers.
inline Bytes triangle_laws()
{
    return bytes({0x21,                                        //
                  0x66, 0, 0, 0x00, 0xC0, 0, 0x20, 0x00, 0x60, // y from -2 to 3
                  0, 0, 0x00, 0xC0, 0, 0x20, 0x00, 0x60,       //
                  0x04});
}

/// 40 px to the right from (10, 20), then 30 px down.
inline scene::Drawing bow() { return {{polyline_of({{160, 320}, {800, 320}, {800, 800}})}}; }

/// An item's state and what it borrows.
class OwnedState {
public:
    OwnedState(Bytes file, Time time)
        : file_{std::move(file)},
          scene_{*SceneView::parse(file_)},
          moved_{scene_},
          state_{scene_, moved_.at(time), moved_.at(time).nodes()[1]}
    {
    }

    std::uint32_t opacity() const { return state_.opacity(); }
    Space placement() const { return state_.placement(); }
    Colour fill() const { return state_.fill(); }
    Colour stroke() const { return state_.stroke(); }
    Fixed width() const { return state_.width(); }

private:
    Bytes file_;
    SceneView scene_;
    MovedScene moved_;
    ItemState state_;
};

/// Black, white, half transparent red; a filled and stroked triangle, 2 px wide, red on white.
inline OwnedState state_of(std::initializer_list<Bytes> tracks, Time time = {}, const Bytes& path = {})
{
    RawScene scene;
    scene.drawings = joined({scene.drawings, packed(bow())});
    scene.law_count = 3;
    scene.laws = triangle_laws();
    const auto count = static_cast<int>(tracks.size());
    scene.items = joined({count == 0 ? bytes({0x18}) : bytes({0x1C, count}), joined(tracks), path,
                          bytes({1, 2, 32, 8}), one_key()});
    const Bytes file = scene.file();
    REQUIRE(SceneView::parse(file));
    return {file, time};
}

inline Point shift_of(const OwnedState& state) { return state.placement().plane(pixels(0, 0)); }

}
