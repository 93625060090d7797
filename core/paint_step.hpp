#pragma once

#include "core/edge_list.hpp"

#include <cstdint>

namespace kfast {

/// One of the steps in which every row of a picture is painted.
struct PaintStep {
    enum class Kind : std::uint8_t {
        layer,       ///< paint a layer
        begin_blend, ///< keep the row as it is
        end_blend,   ///< make what was painted since then transparent
    };

    Kind kind = Kind::layer;
    std::uint8_t opacity = 255; ///< only of end_blend
    Layer layer;                ///< only of layer
};

}
