#pragma once

#include "host/geometry/outline.hpp"

#include <cstddef>
#include <vector>

namespace kfast::lottie {

/// From `from` to `to` of a length, `from` the smaller.
struct Stretch {
    double from = 0;
    double to = 0;
};

/// What measuring a curve and cutting it costs, compared with computing its points.
inline constexpr double measuring_cost = 8;

/// An outline along which lengths are known, with the line that closes it if it needs one.
class MeasuredOutline {
public:
    explicit MeasuredOutline(const scene::Outline& outline);

    double length() const { return ends_.empty() ? 0 : ends_.back(); }
    bool is_closed() const { return closed_; }

    /// The piece between two lengths, open; what reaches beyond the ends is cut off. Where it would begin or
    /// end with a piece of a curve that rounding to 1/16 px may make a point of, it begins or ends beside it.
    /// Without curves if nothing is left.
    scene::Outline piece(Stretch stretch) const;

private:
    struct Segment {
        scene::Vec2 from;
        scene::Curve curve;
    };
    double begin_of(std::size_t index) const { return index == 0 ? 0 : ends_[index - 1]; }
    /// The share of the parameter of a segment at a length along the whole outline.
    double parameter(std::size_t index, double length) const;

    std::vector<Segment> segments_;
    std::vector<double> ends_; ///< length from the beginning of all to the end of each segment
    bool closed_ = false;
};

/// Continues an open outline with another one that begins where it ends.
void append(scene::Outline& outline, scene::Outline next);

}
