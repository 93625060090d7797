#pragma once

#include "host/art/animation/animated.hpp"
#include "host/art/document/document.hpp"
#include "host/art/prepare/tween_turn.hpp"

#include <vector>

namespace kfast::art {

/// The eases that simplification adds to a document: few, for the scene's table of them is limited.
class NewEases {
public:
    static constexpr std::size_t max = 64;
    static constexpr std::size_t max_fits = 20'000; ///< each takes about a tenth of a millisecond

    /// Whether another fit may be tried.
    bool take_fit() { return fits_ < max_fits && ++fits_ > 0; }
    bool add(const Ease& ease);

private:
    std::vector<Ease> list_;
    std::size_t fits_ = 0;
};

/// Leaves out keys, and gives transitions between others a new ease, as long as the value is never further
/// than `tolerance` from what it was, by distance(). Keys that stay keep time and value.
void leave_out_keys(Channel& channel, double tolerance, NewEases& eases);
void leave_out_keys(Animated<Rgb>& colour, double tolerance, NewEases& eases);
/// The same for drawings; keys next to those of another form stay.
void leave_out_keys(Animated<Drawing>& drawing, double tolerance, NewEases& eases);

/// How a line along a drawing makes its directions visible.
struct LineEdge {
    std::vector<CornerArm> arms; ///< of the drawing's keys
    double half_width = 0;
    double tolerance = 0; ///< how far it may move, on top of points
};

/// The same, and corners and ends of a line move by no more than its edge allows.
void leave_out_keys(Animated<Drawing>& drawing, double tolerance, const LineEdge& edge, NewEases& eases);

}
