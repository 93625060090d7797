#pragma once

#include "core/pixel/paint_style.hpp"
#include "core/raster/outline/grid.hpp"
#include "core/time/time.hpp"

#include <cstdint>

namespace kfast::raster {

/// Rows of a panel, from `begin` up to but not including `end`.
struct RowRange {
    std::int16_t begin = 0;
    std::int16_t end = 0;
};

/// Identifies a layer of a scene, wherever symbols are used.
struct LayerName {
    std::uint32_t item = 0;
    std::uint8_t part = 0; ///< of the item: its fill, or its stroke
};

/// What is kept of a layer, above its chains: from one picture to the next, if these stay as they are.
struct LayerOutlines {
    static constexpr std::uint16_t no_step = 0xFFFF;

    Dependence dependence; ///< the layer has these outlines as long as nothing of this moves
    Fingerprint fingerprint;
    std::uint32_t item = 0;       ///< of its name
    std::uint32_t bytes = 0;      ///< of its chains
    std::uint32_t peak_bytes = 0; ///< the maximum of them, and of corners that came in, at a time
    RowRange rows;                ///< that it may reach
    std::uint16_t step = no_step; ///< of the picture, that paints it; none if it is not in the picture
    std::uint8_t part = 0;        ///< of its name

    bool has_name(LayerName name) const { return item == name.item && part == name.part; }
    /// Takes in rows of the panel.
    void reach(int first, int end)
    {
        const bool is_first = rows.begin == rows.end;
        rows.begin = static_cast<std::int16_t>(is_first || first < rows.begin ? first : rows.begin);
        rows.end = static_cast<std::int16_t>(is_first || end > rows.end ? end : rows.end);
    }
};

static_assert(sizeof(LayerOutlines) == 36);

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
    std::uint32_t item = 0; ///< identifies an item of the scene, wherever symbols are used
    Fingerprint outlines = {};
    RowRange rows = {}; ///< that a layer may reach

    // Set when pictures are compared.
    std::uint16_t partner = no_partner; ///< number of the same step of the other picture
    std::uint8_t slot = no_slot;        ///< of a layer, see Slots
    bool is_in_group = false;
};

}
