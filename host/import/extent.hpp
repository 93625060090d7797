#pragma once

#include "core/math/point.hpp"
#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/scene_text/values/reach.hpp"

#include <cstddef>
#include <optional>

namespace kfast::importing {

/// The quantities of an animation that make a scene large.
struct Extent {
    std::size_t figures = 0;
    std::size_t groups = 0; ///< and uses of symbols
    std::size_t keys = 0;   ///< of all that changes
    std::size_t points = 0; ///< in all keys of drawings, as the scene language counts them
};

Extent extent_of(const art::Document& document);

/// Of a side of a scene's canvas, in pixels.
inline constexpr int longest_side = 2047;

/// Of the longer side of a canvas, in pixels: it is not made smaller than this for what is beyond it.
inline constexpr double min_longer_side = 480;

/// Scales the art so that its canvas just fits into `wanted`, or, where that is not given and a side is too
/// long for a scene, within the largest canvas there is; and then by `share`. Rounds the sides to whole
/// pixels. Without `wanted`, a canvas that becomes smaller is added to `losses`.
void fit_canvas(art::Document& document, std::optional<Size> wanted, double share, art::Losses& losses);

/// The factor by which the art has to be scaled down to bring all its coordinates into a scene's range: if it
/// `is_smaller` already, without groups for that, and otherwise if not even groups do so. 1 if it need not,
/// or if too little would be left of the canvas.
double share_within_reach(const art::Document& fitted, const scene_text::Reach& reach, bool is_smaller);

}
