#pragma once

#include "host/lottie/shapes/shapes.hpp"

#include <string_view>

namespace kfast::lottie {

/// Whether a type "ty" is one of those that read_style_item() reads.
bool is_style(std::string_view type);

/// A fill ("fl"), a stroke ("st"), or one by a gradient ("gf", "gs"), which gets its mean colour.
StyleItem read_style_item(const Json& item, const Reading& reading);

}
