#pragma once

#include "core/beam/beam_lines.hpp"

#include <cstdint>

namespace kfast {

/// One line of a route, and how it is followed.
struct BeamLeg {
    std::uint16_t line = 0;   ///< its number
    std::uint16_t start = 0;  ///< of a closed line: the number of its point where it begins and ends
    bool is_reversed = false; ///< from its last point to its first; never of a closed line

    friend constexpr bool operator==(const BeamLeg&, const BeamLeg&) = default;
};

/// Where the beam arrives on `leg`.
inline FieldPoint begin_of(const BeamLines& lines, const BeamLeg& leg)
{
    const std::span<const FieldPoint> points = lines.points(lines.line(leg.line));
    return leg.is_reversed ? points.back() : points[leg.start];
}

/// Where the beam leaves it.
inline FieldPoint end_of(const BeamLines& lines, const BeamLeg& leg)
{
    const std::span<const FieldPoint> points = lines.points(lines.line(leg.line));
    if (leg.is_reversed)
        return points.front();
    return leg.start == 0 ? points.back() : points[leg.start];
}

/// The other way round.
inline BeamLeg reversed(const BeamLines& lines, const BeamLeg& leg)
{
    const bool is_closed = lines.is_closed(lines.line(leg.line));
    return {leg.line, leg.start, !is_closed && !leg.is_reversed};
}

}
