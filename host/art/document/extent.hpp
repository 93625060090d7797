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

/// A box that contains something at all times, in pixels: never too small.
struct Extent {
    Range x;
    Range y;
    Range z;

    bool empty() const { return x.empty(); }
    void take(const Extent& other);
};

/// The range of the channel's values, overshoots included.
Range range_of(const Channel& channel);
/// The greatest absolute value of it.
double greatest(const Channel& channel);

/// The extent of what a shape draws, its line included, in its own coordinates.
Extent extent_of(const Shape& shape, std::span<const Rig> rigs);

/// The extent of content after the transform.
Extent placed(const Extent& content, const Transform& transform);

/// The extent of all copies of content.
Extent copied(const Extent& content, const Copies& copies);

/// The factor by which the largest copy is larger than the symbol; at least 1.
double scale_factor_of(const Copies& copies);

/// The farthest that content is from the anchor of the transform, before scaling.
double reach_of(const Extent& content, const Transform& transform);

/// The factor by which the transform enlarges distances at most; above 0.
double scale_factor_of(const Transform& transform);

/// The same factor for its skew alone; at least 1.
double skew_scale_factor(const Transform& transform);

/// The factor by which the bones of the rig enlarge distances at most; at least 1.
double scale_factor_of(const Rig& rig);

/// Whether anything is in front of the canvas or behind it, or rotates out of it.
bool has_depth(const Document& document);

/// The factor by which perspective enlarges motions at most, those towards the viewer included; at least 1.
/// `all` is what the document has before its perspective.
double perspective_scale_factor(const Document& document, const Extent& all);

}
