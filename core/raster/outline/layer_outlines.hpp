#pragma once

#include "core/raster/outline/fingerprint.hpp"
#include "core/time/dependence.hpp"

#include <cstdint>

namespace kfast::raster {

/// Rows of a panel, from `begin` up to but not including `end`.
struct RowRange {
    std::int16_t begin = 0;
    std::int16_t end = 0;
};

/// Tells the layers of a scene apart, wherever symbols are used.
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
    std::uint32_t peak_bytes = 0; ///< the most of them, and of corners that came in, at a time
    RowRange rows;                ///< that it may reach
    std::uint16_t step = no_step; ///< which one of the picture paints it; none if it is not in the picture
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

}
