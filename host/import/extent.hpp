#pragma once

#include "core/math/point.hpp"
#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/scene_text/values/reach.hpp"

#include <cstddef>
#include <optional>

namespace kfast::importing {

/// How much an animation has of what makes a scene large.
struct Extent {
    std::size_t figures = 0;
    std::size_t groups = 0;
    std::size_t keys = 0;   ///< of all that changes
    std::size_t points = 0; ///< in all keys of drawings, as the scene language counts them
};

Extent extent_of(const art::Document& document);

/// Of a side of a scene's canvas, in pixels.
inline constexpr int longest_side = 2047;

/// Of the longer side of a canvas, in pixels: it is not made smaller than this for what lies beyond it.
inline constexpr double min_longer_side = 480;

/// Scales the art so that its canvas just lies within `wanted`, or, where that is not given and a side is too
/// long for a scene, within the largest canvas there is; and then by `share`. Rounds the sides to whole
/// pixels. Without `wanted`, a canvas that becomes smaller is added to `losses`.
void fit_canvas(art::Document& document, std::optional<Size> wanted, double share, art::Losses& losses);

/// By what the art has to become smaller for all its coordinates to be ones that a scene has: where it
/// `is_smaller` already, without groups for that, and otherwise where not even groups make them so. 1 if it
/// need not, or if too little would be left of the canvas.
double share_within_reach(const art::Document& fitted, const scene_text::Reach& reach, bool is_smaller);

}
