#pragma once

#include "host/lottie/shapes/shapes.hpp"

#include <string_view>

namespace kfast::lottie {

/// Whether a type "ty" is one of those that read_path_item() reads.
bool is_path(std::string_view type);

/// A path ("sh"), a rectangle ("rc"), an ellipse ("el") or a star ("sr"): "ty" says which.
PathItem read_path_item(const Json& item, const Reading& reading);

}
