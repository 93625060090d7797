#pragma once

#include "host/picture/picture.hpp"

#include <string_view>

namespace kfast {

/// Pixels from one character to the next, and from the top to the bottom of one.
inline constexpr Size digit_cell{6, 7};

/// Digits, points, spaces and "s" (for seconds), the rest as spaces, in plain pixels; one character at least.
Picture digit_picture(std::string_view text, Colour colour, Colour behind);

}
