#pragma once

#include "core/beam/beam_profile.hpp"
#include "core/math/affine.hpp"
#include "core/math/point.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::test {

/// Where and how often a scene is played.
struct Way {
    Size panel{24, 17};
    Fit fit = Fit::contain;
    BeamProfile beam = scope_profile;
    std::uint32_t budget = 4000;   ///< points of a picture of the beam
    std::uint32_t first_round = 0; ///< what inputs are told at first, and the format of the first picture
    int moments = 50; ///< of a panel, from the beginning to the end of the scene; no more than two a frame
    int beam_moments = 5; ///< likewise
};

/// Every seed has its panel, its fit, its beam and what is told.
Way way_of(std::uint32_t seed);

/// What was played.
struct Played {
    std::uint64_t scenes = 0;
    std::uint64_t pictures = 0; ///< of panels
    std::uint64_t coarse = 0;   ///< of these
    std::uint64_t beam_pictures = 0;

    Played& operator+=(const Played& more);
};

/// Any scene that is not refused can be read, and shown at every frame and between them, within the memory it
/// asks for, on a panel and by a beam; what breaks that is a finding.
Played play(std::span<const std::byte> bytes, const Way& way = {});

}
