#pragma once

#include "core/math/angle.hpp"

#include <cstdint>

namespace kfast {

/// Which parts of the plane are inside of outlines that cross or enclose each other, as in SVG. The values
/// are those of the scene format.
enum class FillRule : std::uint8_t {
    nonzero,  ///< those that the outlines go around more often one way than the other
    even_odd, ///< those that the outlines go around an odd number of times
};

/// Whether what the outlines go around `winding` times is inside.
constexpr bool is_inside(FillRule rule, std::int32_t winding)
{
    return rule == FillRule::nonzero ? winding != 0 : (winding & 1) != 0;
}

/// How a stroke ends; the values are those of the scene format.
enum class Cap : std::uint8_t { butt, round, square };

/// How two segments of a stroke meet; the values are those of the scene format. A miter longer than its limit
/// becomes a bevel.
enum class Join : std::uint8_t { miter, round, bevel };

/// The longest miter, in 1/8 widths of the stroke: 4 widths, as in SVG.
inline constexpr int default_miter_limit = 4 * 8;

/// What the beam of a vector display draws of an object.
enum class BeamParts : std::uint8_t {
    none,
    outline, ///< its strokes; of an object without strokes the border of its fill
    hatch,   ///< parallel lines across its fill
    both,
};

/// Of an object, as beams draw it; panels know nothing of it.
struct BeamStyle {
    BeamParts parts = BeamParts::outline;
    int spacing = 64;        ///< from a line of the hatching to the next, in 1/16 px
    BinaryAngle direction{}; ///< of these lines

    constexpr bool has_outline() const { return parts == BeamParts::outline || parts == BeamParts::both; }
    constexpr bool has_hatching() const { return parts == BeamParts::hatch || parts == BeamParts::both; }
    friend constexpr bool operator==(const BeamStyle&, const BeamStyle&) = default;
};

}
