#pragma once

#include "core/layer.hpp"
#include "core/still.hpp"

#include <cstdint>

namespace kfast {

/// One of the steps in which every row of a picture is painted.
struct PaintStep {
    enum class Kind : std::uint8_t {
        layer,       ///< paint a layer
        begin_blend, ///< keep the row as it is
        end_blend,   ///< make what was painted since then transparent
    };

    /// How a layer differs from its partner in the picture before.
    enum class Change : std::uint8_t {
        none,     ///< it is the same
        outlines, ///< where their coverages differ
        all,      ///< wherever one of them covers something; perhaps there is no partner
    };

    static constexpr std::uint16_t no_partner = 0xFFFF;

    Kind kind = Kind::layer;
    std::uint8_t opacity = 255; ///< only of end_blend
    Change change = Change::all;
    std::uint16_t partner = no_partner; ///< number of the step in the other picture
    std::int16_t top = 0;               ///< the first row in which it or its partner has something
    std::int16_t bottom = 0;            ///< the row below the last one
    std::uint32_t item = 0;             ///< tells the items of a scene apart, wherever symbols are used
    Still still = {};                   ///< around the moment of the picture
    Layer layer = {};                   ///< only of layer

    /// Whether a row may differ from the picture before because of it.
    bool changes(int row) const { return change != Change::none && row >= top && row < bottom; }
};

}
