#pragma once

#include "host/art/geometry/affine.hpp"
#include "host/art/geometry/drawing.hpp"
#include "host/svg/parts/part.hpp"

#include <optional>
#include <span>
#include <vector>

namespace kfast::svg {

/// What an affine does as the scene's items do: grow along their own axes, turn, and move.
struct Move {
    double scale_x = 1;
    double scale_y = 1;
    double rotate = 0; ///< degrees
    scene::Vec2 to;    ///< where (0, 0) goes
};

/// Nothing where it leans, or flattens all to a line.
std::optional<Move> move_of(const art::Affine& affine);

/// What something that lies in `box` at first turns and grows about, as it moves by `affines`: the point that
/// stays where it is, if there is one not far from the box, else the middle of the box.
scene::Vec2 pivot_of(std::span<const art::Affine> affines, const Box& box);

/// Turning, growing evenly and moving that takes one drawing to another, to within `tolerance`. Nothing where
/// none does, or they have not the same form.
std::optional<art::Affine> similarity(const art::Drawing& from, const art::Drawing& to, double tolerance);

/// Whether it grows evenly in all directions, up to one part in a hundred.
bool is_even(const art::Affine& affine);

bool is_near(const art::Affine& left, const art::Affine& right);

}
