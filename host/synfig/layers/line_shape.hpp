#pragma once

#include "host/art/geometry/drawing.hpp"
#include "host/synfig/evaluation/spline_list.hpp"
#include "host/synfig/values/value.hpp"

#include <vector>

namespace kfast::synfig {

enum class Corner { sharp, round, bevel };

/// Half of the width of a line at a distance along it.
struct WidthStop {
    double distance = 0;
    double half_width = 0;
};

/// A line whose width changes along it, all in pixels.
struct VaryingLine {
    std::vector<SplinePiece> pieces; ///< each begins where the one before ends
    bool loop = false;
    std::vector<WidthStop> stops; ///< at least one; rising
    double smoothness = 0;        ///< 0: straight from stop to stop; 1: smoothly
    /// Before a last stop that ends the line Synfig 1.5.1 lets the width dip, by this fraction of the width
    /// there.
    double dip = 0;
    double from = 0; ///< along the line; not for loops
    double to = 0;
    Side begin = Side::flat;
    Side end = Side::flat;
    Corner corner = Corner::sharp;

    double half_width(double distance) const;
};

/// What the line covers, to be filled by the rule nonzero. Always of the same form for the same number of
/// pieces, ends and corner. Within about 1/100 of the width.
art::Drawing shape_of(const VaryingLine& line);

}
