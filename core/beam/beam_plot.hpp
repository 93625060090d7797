#pragma once

#include "core/beam/beam_lines.hpp"
#include "core/beam/beam_point.hpp"
#include "core/beam/beam_profile.hpp"
#include "core/beam/beam_route.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// The points of a picture, one after another.
class BeamPlot {
public:
    /// `lines` and `legs` must outlive it. `haste` makes the beam go that often twice as fast, and wait half
    /// as long.
    BeamPlot(const BeamLines& lines, std::span<const BeamLeg> legs, const BeamProfile& profile, int haste)
        : lines_{&lines}, legs_{legs}, profile_{profile}, haste_{haste}
    {
    }

    /// Fills the beginning of `points` with the next ones, and returns how many: fewer than fit only at the
    /// end.
    std::size_t next(std::span<BeamPoint> points);

private:
    const BeamLines* lines_;
    std::span<const BeamLeg> legs_;
    BeamProfile profile_;
    int haste_;
    std::size_t leg_ = 0;
    std::size_t vertex_ = 0;
};

}
