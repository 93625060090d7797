#pragma once

#include "host/synfig/values/colour.hpp"

#include <vector>

namespace kfast::synfig {

struct GradientStop {
    double position = 0; ///< 0 to 1
    Colour colour;
};

/// Between two stops colours go as Synfig mixes them: what is transparent has no say in the hue.
struct Gradient {
    std::vector<GradientStop> stops; ///< their positions rise; none: black

    Colour at(double position) const;
    /// From 0 to 1, all along; without opacity the hue of the stops.
    Colour mean() const;
};

/// A colour with its channels times its opacity.
Colour weighted(const Colour& colour);
/// The other way; black where there is no opacity.
Colour unweighted(const Colour& colour);
Colour mixed(const Colour& from, const Colour& to, double share);

}
