#pragma once

#include "core/math/angle.hpp"

#include <cstdint>

namespace kfast {

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
