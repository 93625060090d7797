#pragma once

#include "core/size.hpp"
#include "host/art/document.hpp"
#include "host/art/losses.hpp"

#include <optional>

namespace kfast::importing {

/// Of a side of a scene's canvas, in pixels.
inline constexpr int longest_side = 2047;

/// Scales the art so that its canvas just lies within `wanted`, or, where that is not given and a side is too
/// long for a scene, within the largest canvas there is, which is added to `losses`. Rounds the sides to
/// whole pixels.
void fit_canvas(art::Document& document, std::optional<Size> wanted, art::Losses& losses);

}
