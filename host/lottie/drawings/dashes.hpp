#pragma once

#include "host/art/animation/animated.hpp"
#include "host/art/document/document.hpp"
#include "host/geometry/outline.hpp"
#include "host/lottie/drawings/moving_drawing.hpp"

#include <cstddef>
#include <vector>

namespace kfast::lottie {

/// A range of lengths; `from` is the smaller.
struct Stretch {
    double from = 0;
    double to = 0;
};

/// The cost of measuring and cutting a curve, relative to computing its points.
inline constexpr double measuring_cost = 32;

/// An outline along which lengths are known, with the line that closes it if it needs one.
class MeasuredOutline {
public:
    explicit MeasuredOutline(const scene::Outline& outline);

    double length() const { return ends_.empty() ? 0 : ends_.back(); }
    bool is_closed() const { return closed_; }

    /// The piece between two lengths, open; what is beyond the ends is cut off. Where it would begin or end
    /// with a piece of a curve that rounding to 1/16 px may reduce to a point, it begins or ends beside it.
    /// Without curves if nothing is left.
    scene::Outline piece(Stretch stretch) const;

private:
    struct Segment {
        scene::Vec2 from;
        scene::Curve curve;
    };
    double begin_of(std::size_t index) const { return index == 0 ? 0 : ends_[index - 1]; }
    /// The parameter within a segment at a length along the whole outline.
    double parameter(std::size_t index, double length) const;

    std::vector<Segment> segments_;
    std::vector<double> ends_; ///< length from the beginning of all to the end of each segment
    bool closed_ = false;
};

/// Continues an open outline with another one that begins where it ends.
void append(scene::Outline& outline, scene::Outline next);

using art::Dashes;

/// Whether a scene has such dashes along what `drawing` is, so that they need not be cut.
bool are_of_scenes(const Dashes& dashes, const MovingDrawing& drawing);

/// The maximum number of dashes that are cut of a drawing, and of one that changes or whose dashes move.
inline constexpr int max_dashes = 1000;
inline constexpr int max_moving_dashes = 120;

/// How dashes were applied.
enum class Dashing {
    all,         ///< there they are
    stand_still, ///< too many to move: they stay where they were at first
    none,        ///< too many: the line is whole
};

struct DashedDrawing {
    MovingDrawing drawing;
    Dashing dashing = Dashing::all;
};

/// Pieces of the outlines, each of which begins the pattern anew.
DashedDrawing dashed(MovingDrawing drawing, const Dashes& dashes);

}
