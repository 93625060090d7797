#pragma once

#include "host/art/document/document.hpp"
#include "host/art/geometry/affine.hpp"

namespace kfast::art {

/// Degrees: what leans by a quarter turn has no width, so nothing leans by more.
inline constexpr double steepest_skew = 89.9;

/// What the transform does to its content at a time, along its path if it has one; its depth and turns in
/// space aside.
Affine matrix_at(const Transform& transform, double time);

/// As matrix_at() without the place and the path: how it turns, grows and leans.
Affine shape_at(const Transform& transform, double time);

}
