#pragma once

#include "host/picture/picture.hpp"

#include <cstdint>
#include <optional>

namespace kfast {

/// What pictures in files have at most.
inline constexpr std::int64_t longest_picture_side = 16384;
inline constexpr std::int64_t max_picture_pixels = std::int64_t{1} << 26;

/// The smallest area outside of which both pictures, of one size, are the same; none if they are all over.
std::optional<Rect> changed_part(const Picture& before, const Picture& after);

/// `area` lies within the picture.
Picture part(const Picture& picture, const Rect& area);

/// All of one colour. Throws Failure, in the name of `what` ("the sheet"), if that were more than
/// pictures have.
Picture plain_picture(std::int64_t width, std::int64_t height, Colour colour, const char* what);

/// Lays `picture` on `sheet`, with room for it, at `x` and `y`.
void put(const Picture& picture, Picture& sheet, int x, int y);

/// Each pixel as a square of `factor` pixels a side, at least 1. Throws Failure like plain_picture().
Picture scaled(const Picture& picture, int factor);

}
