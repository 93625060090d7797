#pragma once

#include "host/art/document/document.hpp"

#include <limits>
#include <span>

namespace kfast::art {

/// Numbers from low to high; none if low is above high.
struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    bool empty() const { return low > high; }
    void take(double value);
    void take(Range other);
};

/// Where something is at all times: never too small a box, in pixels.
struct Extent {
    Range x;
    Range y;
    Range z;

    bool empty() const { return x.empty(); }
    void take(const Extent& other);
};

/// What the channel comes to, swings beyond its keys included.
Range range_of(const Channel& channel);
/// The greatest amount of it.
double greatest(const Channel& channel);

/// Of what a shape draws, its line included, in its own coordinates.
Extent extent_of(const Shape& shape, std::span<const Rig> rigs);

/// Of content after the transform.
Extent placed(const Extent& content, const Transform& transform);

/// The farthest that content is from the anchor of the transform, before it grows.
double reach_of(const Extent& content, const Transform& transform);

/// By how much the transform makes distances larger at most; above 0.
double scale_factor_of(const Transform& transform);

/// Likewise of its skew alone; at least 1.
double skew_scale_factor(const Transform& transform);

/// By how much the bones of the rig make distances larger at most; at least 1.
double play_range_of(const Rig& rig);

/// Whether anything lies in front of the canvas or behind it, or turns out of it.
bool has_depth(const Document& document);

/// By how much the perspective makes motions larger at most, those towards the viewer included; at least 1.
/// `all` is what the document has before its perspective.
double perspective_scale_factor(const Document& document, const Extent& all);

}
