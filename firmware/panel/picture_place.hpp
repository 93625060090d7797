#pragma once

#include "firmware/settings/panel_settings.hpp"

namespace kfast {

/// Where in the addresses of a controller its picture begins.
struct PicturePlace {
    int column = 0; ///< of the picture's left edge
    int row = 0;    ///< of its upper edge
    friend constexpr bool operator==(PicturePlace, PicturePlace) = default;
};

/// The part of a memory that is scanned by a controller that can leave out what is below the glass, and
/// counts from the last row that it scans when it rotates the picture.
constexpr Size scanned(const PanelSettings& settings, Size memory)
{
    return {memory.width, settings.row + settings.glass.height};
}

/// The addresses that the controller uses when it rotates the picture itself: rotated too, and counted from
/// whichever corner of its `memory` has become the left upper one. A glass that is not in the middle of the
/// memory therefore begins elsewhere in every rotation.
constexpr PicturePlace picture_place(const PanelSettings& settings, Size memory)
{
    const int left = settings.column;
    const int right = memory.width - settings.glass.width - left;
    const int above = settings.row;
    const int below = memory.height - settings.glass.height - above;
    switch (settings.rotation) {
    case Rotation::none:
        return {left, above};
    case Rotation::quarter:
        return {above, right};
    case Rotation::half:
        return {right, below};
    case Rotation::three_quarters:
        return {below, left};
    }
    return {};
}

}
