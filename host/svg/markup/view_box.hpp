#pragma once

#include "host/art/geometry/affine.hpp"

#include <optional>
#include <string_view>

namespace kfast::svg {

/// A part of a drawing's own coordinates.
struct ViewBox {
    double x = 0;
    double y = 0;
    double width = 0; ///< above 0
    double height = 0;
};

/// Nothing where there is none, or one without an extent.
std::optional<ViewBox> view_box(std::string_view text);

/// Takes the box into a rectangle from (0, 0) to (width, height), as "preserveAspectRatio" says.
art::Affine fitted(const ViewBox& box, double width, double height, std::string_view aspect_ratio);

}
