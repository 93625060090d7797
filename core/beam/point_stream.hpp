#pragma once

#include "core/beam/beam_lines.hpp"
#include "core/beam/beam_point.hpp"
#include "core/beam/beam_profile.hpp"
#include "core/beam/beam_route.hpp"
#include "core/beam/beam_timing.hpp"
#include "core/beam/point_sequencer.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// The points of a picture, one after another. It needs no memory that grows with them.
///
/// Where the light comes later than the place, all points are: the places of the first ones come at the
/// end of the picture before.
class PointStream {
public:
    /// All but `timing` must outlive it.
    PointStream(const BeamLines& lines, std::span<const BeamLeg> legs, const BeamProfile& profile,
                const BeamTiming& timing);

    /// Fills the beginning of `points` with the next ones, and returns how many: fewer than fit only at the
    /// end.
    std::size_t next(std::span<BeamPoint> points);

private:
    void plot_run(std::span<BeamPoint> points);
    FieldPoint next_place();
    Colour light() const;

    PointSequencer sequencer_;
    PointSequencer places_; ///< where the light is late, as many points ahead
    StandingLight standing_;
    bool is_late_;
    bool is_laser_;
    BeamBrightness brightness_;
};

}
