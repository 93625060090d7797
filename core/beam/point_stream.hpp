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
    std::size_t legs = 0; ///< how many of the first ones can be drawn, at the highest speed
    /// The points for which a laser rests, blanked, so that a picture takes 1/max_refresh s: otherwise what
    /// is small would be drawn over and over, and dangerously bright.
    std::uint32_t pause = 0;
    BeamAmount amount;

    static constexpr std::uint32_t max_refresh = 100; ///< pictures of a laser in a second
};

/// `budget` is at least 1. The timing does not depend on `guess`, a speed level that is tried first.
BeamTiming find_timing(const BeamLines& lines, std::span<const BeamLeg> legs, const BeamProfile& profile,
                       std::uint32_t budget, int guess);

/// The points of a picture, one after another. It needs no memory that grows with them.
///
/// Where the light comes later than the position, all points are: the positions of the first ones come at the
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
    PointSequencer places_; ///< where the light is late, that many points ahead
    StandingLight standing_;
    bool is_late_;
    bool is_laser_;
    BeamBrightness brightness_;
};

}
