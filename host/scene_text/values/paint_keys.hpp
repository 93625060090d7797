#pragma once

#include "core/pixel/paint_style.hpp"
#include "host/art/document/document.hpp"
#include "host/scene_text/values/colours.hpp"
#include "host/scene_text/values/stored_keys.hpp"

#include <vector>

namespace kfast::scene_text {

/// Of a fill or a line: the opacity is that of the colour, and stands still.
template <typename Paint>
std::vector<StoredKey<Colour>> paint_keys(const Paint& paint, std::int32_t length)
{
    const double opacity = paint.opacity.keys.front().value;
    return stored_keys(paint.colour, length,
                       [&](const art::Rgb& colour) { return stored_colour(colour, opacity); });
}

}
