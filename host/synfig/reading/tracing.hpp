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
    std::vector<double> bends;   ///< frames at which values change differently, or jump; in any order
    double tolerance = 1.0 / 64; ///< of keys; between them, values may be off by twice as much
    art::Budget* budget = nullptr;
};

/// Keys, and eases between them, of what is known at any time. Between two bends there is one ease if the
/// value is a cubic in time (as between all waypoints of Synfig), the same for all numbers; otherwise it is
/// divided until each part between two keys is one, within the tolerance, or an eighth of a frame long.
/// Throws Failure when the budget does not allow that many keys.
art::Channel traced(const std::function<double(double)>& value_at, const Tracing& tracing);
art::Animated<art::Rgb> traced(const std::function<art::Rgb(double)>& colour_at, const Tracing& tracing);
/// The form may change at bends.
art::Animated<art::Drawing> traced(const std::function<art::Drawing(double)>& drawing_at,
                                   const Tracing& tracing);

}
