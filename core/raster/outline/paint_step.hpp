#pragma once

#include "core/pixel/colour.hpp"
#include "core/pixel/fill_rule.hpp"
#include "core/raster/outline/layer_outlines.hpp"

#include <cstdint>

namespace kfast::raster {

/// One of the steps in which a picture is painted, the lowest layer first.
struct PaintStep {
    enum class Kind : std::uint8_t {
        layer,       ///< paint what its outlines enclose
        begin_group, ///< what follows is blended as a whole ...
        end_group,   ///< ... with what is below, by `opacity`
    };

    static constexpr std::uint16_t no_partner = 0xFFFF;
    static constexpr std::uint8_t no_slot = 0xFF;

    Kind kind = Kind::layer;
    std::uint8_t opacity = 255; ///< only of end_group
    FillRule rule = FillRule::nonzero;
    Colour colour = {};     ///< only of layers
    std::uint32_t item = 0; ///< tells the items of a scene apart, wherever symbols are used
    Fingerprint outlines = {};
    RowRange rows = {}; ///< that a layer may reach

    // What comparing pictures has found.
    std::uint16_t partner = no_partner; ///< number of the same step of the other picture
    std::uint8_t slot = no_slot;        ///< of a layer, see Slots
    bool is_in_group = false;
};

}
