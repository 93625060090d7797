#pragma once

#include "core/beam/beam_lines.hpp"
#include "core/beam/beam_profile.hpp"
#include "core/beam/beam_route.hpp"
#include "core/beam/point_sequencer.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// What a picture takes. Lengths are in units of the field.
struct BeamAmount {
    std::uint32_t points = 0;
    std::uint32_t lit_points = 0;
    std::uint64_t lit_length = 0;
    std::uint64_t blanked_length = 0;
};

/// How a route is drawn with no more points than there is time for.
struct BeamTiming {
    int speed_level = 0;  ///< no more than is needed
    std::size_t legs = 0; ///< so many of the first ones can be drawn, however much the beam hurries
    /// Points for which a laser rests, blanked, so that a picture takes 1/max_refresh s: else what is small
    /// would be drawn over and over, and dangerously bright.
    std::uint32_t pause = 0;
    BeamAmount amount;

    static constexpr std::uint32_t max_refresh = 100; ///< pictures of a laser in a second
};

/// `budget` is at least 1. The timing does not depend on `guess`, a speed level that is tried first.
BeamTiming find_timing(const BeamLines& lines, std::span<const BeamLeg> legs, const BeamProfile& profile,
                       std::uint32_t budget, int guess);

}
