#pragma once

#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"

#include <functional>
#include <vector>

namespace kfast::synfig {

/// What is traced, and how well.
struct Tracing {
    double from = 0; ///< frames of the scene
    double to = 1;
    std::vector<double> bends;   ///< frames at which values begin another way, or jump; in any order
    double tolerance = 1.0 / 64; ///< of keys; ways between them may be off by twice as much
    art::Budget* budget = nullptr;
};

/// Keys, and eases between them, of what is known at any time. Between two bends the way is one ease where it
/// is a cubic in time (all waypoints of Synfig lead along such) and the same for all numbers; otherwise it is
/// divided until the way between two keys is one, within the tolerance, or an eighth of a frame long.
/// Throws Failure when the budget does not allow so many keys.
art::Channel traced(const std::function<double(double)>& value_at, const Tracing& tracing);
art::Animated<art::Rgb> traced(const std::function<art::Rgb(double)>& colour_at, const Tracing& tracing);
/// The form may change at bends.
art::Animated<art::Drawing> traced(const std::function<art::Drawing(double)>& drawing_at,
                                   const Tracing& tracing);

}
