#include "core/edge_budget.hpp"

#include <algorithm>

namespace kfast {

/// This holds for any curve, so also where a velocity law takes the control points beyond those of both keys.
/// The curve turns no more than its control polygon, one whole turn: that is 2 arc pieces. Rounding adds to
/// that. A point is off by up to 1.5/65536 px (three nested roundings), so the heading of the shortest piece,
/// 1/256 px, by 3/256 rad, and a join by twice that, less than 0.0038 turns: that is e = 0.0076 arc pieces.
/// It counts only where a join has two pieces or more, and so at least 1 - e of its own: there are at most 2
/// arc / (1 - e) of these. No join has more than arc pieces, which is all that is left to say where e
/// nears 1.
///
/// In perspective it does not hold for any curve: what rounding adds is enlarged, and a curve may turn where
/// it comes nearer than is seen. There StrokeOutline keeps to it.
std::uint32_t arcs_within_curve(std::uint32_t arc, std::uint32_t joins)
{
    const std::uint32_t most = joins * (arc - 1);
    const std::uint32_t e = 76 * arc; // in 1/10000
    return e > 5000 ? most : std::min(most, 2 * arc + 2 * arc * e / (10000 - e) + 1);
}

}
