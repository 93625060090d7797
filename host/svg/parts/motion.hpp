#pragma once

#include "host/art/geometry/affine.hpp"
#include "host/art/geometry/drawing.hpp"
#include "host/svg/parts/part.hpp"

#include <optional>
#include <span>
#include <vector>

namespace kfast::svg {

/// An affine as the transform of a scene's item: scales along its own axes, rotates, and moves.
struct Move {
    double scale_x = 1;
    double scale_y = 1;
    double rotate = 0; ///< degrees
    scene::Vec2 to;    ///< where (0, 0) goes
};

/// Nothing if it has skew, or is singular.
std::optional<Move> move_of(const art::Affine& affine);

/// The pivot of something that is in `box` at first and moves by `affines`: the point that stays where it is,
/// if there is one not far from the box, else the middle of the box.
scene::Vec2 pivot_of(std::span<const art::Affine> affines, const Box& box);

/// The similarity (rotation, even scale and move) that maps one drawing to another, to within `tolerance`.
/// Nothing if there is none, or if they do not have the same form.
std::optional<art::Affine> similarity(const art::Drawing& from, const art::Drawing& to, double tolerance);

/// Whether it scales evenly in all directions, up to one part in a hundred.
bool is_even(const art::Affine& affine);

bool is_near(const art::Affine& left, const art::Affine& right);

}
