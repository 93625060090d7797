#pragma once

#include "core/beam/beam_point.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace kfast {

/// How a vector display shows that one line is brighter than another.
enum class BeamBrightness : std::uint8_t {
    none,     ///< not at all: all light is white
    by_level, ///< by its Z input, or the power of its laser
    by_speed, ///< the beam goes faster along dark lines, at most 8 times (StepProfile::darkest); light is
              ///< white
};

/// How the beam of a vector display is to be led. Lengths are in units of the field (beam_point.hpp), times
/// in points.
struct BeamProfile {
    std::uint32_t rate = 100'000;   ///< points in a second, 1000 … 1,000,000
    std::uint16_t lit_step = 256;   ///< how far the lit beam goes from point to point, at least 1
    std::uint16_t travel_step = 0;  ///< likewise the blanked one; 0: it jumps
    std::uint8_t corner_dwell = 0;  ///< how long it waits where it turns right round; less at blunter corners
    std::uint8_t lit_dwell = 0;     ///< how long it waits, lit, at both ends of a line
    std::uint8_t arrival_dwell = 0; ///< how long it waits, blanked, where it has travelled to
    std::uint8_t leave_dwell = 0;   ///< how long it waits, blanked, before it travels
    std::uint8_t light_delay =
        0; ///< how much later the light is put out than the place, for a beam that lags behind
    std::uint8_t min_refresh = 40; ///< pictures in a second: what takes longer is drawn faster and coarser
    std::uint16_t resolution =
        256; ///< a power of two, 64 … 4096: curves are drawn to 1/16 of the field's side / this
    BeamBrightness brightness = BeamBrightness::by_level;
    FieldPoint park = {};  ///< where the beam waits, blanked, when there is nothing to draw
    bool is_laser = false; ///< it is dangerous: it stays dark until somebody arms it

    friend constexpr bool operator==(const BeamProfile&, const BeamProfile&) = default;
};

/// Whether every number is one that its description allows.
constexpr bool is_within_limits(const BeamProfile& profile)
{
    const auto resolution = profile.resolution;
    const bool is_power_of_two = (resolution & (resolution - 1)) == 0;
    return profile.rate >= 1000 && profile.rate <= 1'000'000 && profile.lit_step >= 1 &&
           profile.min_refresh >= 1 && resolution >= 64 && resolution <= 4096 && is_power_of_two;
}

/// An oscilloscope: its plates take the beam anywhere at once, so that it jumps and waits nowhere. In 1/40 s,
/// below which phosphor flickers, it goes 14 times across the field. Curves keep to 1/2048 of its side, two
/// steps of a 12-bit converter. It rests in a corner, for not every one has a Z input.
inline constexpr BeamProfile scope_profile{
    .rate = 100'000, .lit_step = 384, .resolution = 128, .park = {field_min, field_min}};

/// A monitor with coils, which have to settle. Steps and waiting are those of v.st's settings for a Vectrex
/// (https://github.com/osresearch/vst): 4 and 32 of 4096 steps of the DAC a point, 10 points before it shines
/// again.
inline constexpr BeamProfile crt_profile{.rate = 100'000,
                                         .lit_step = 256,
                                         .travel_step = 2048,
                                         .corner_dwell = 2,
                                         .lit_dwell = 1,
                                         .arrival_dwell = 10,
                                         .resolution = 256};

/// A laser with mirrors: 30,000 points a second, as the ILDA test pattern wants them. That is how often they
/// are sent to a place, not how often they can leap: so a step is 1/100 of the width lit (as in lzr), 1/20
/// blanked. A sharp corner waits 8 points, an arrival 6, an end 2, a leaving 4, within what OpenLase uses (8;
/// 8 to 12; 2 to 3; 1 to 10). The light is 4 points late, of 0 to 16 that controllers allow, and the mirrors
/// leave when it is out. 1500 points are a picture: 20 of them a second are what eyes take for a picture of a
/// laser. No laser was measured.
inline constexpr BeamProfile galvo_profile{.rate = 30'000,
                                           .lit_step = 655,
                                           .travel_step = 3277,
                                           .corner_dwell = 8,
                                           .lit_dwell = 2,
                                           .arrival_dwell = 6,
                                           .leave_dwell = 4,
                                           .light_delay = 4,
                                           .min_refresh = 20,
                                           .resolution = 128,
                                           .is_laser = true};

/// Takes care that a laser does not stay lit at one place: it may for 1 ms, and for a tenth of a picture, as
/// long as it shines nowhere else in between. A place is what lies within 1/256 of the field's side.
class StandingLight {
public:
    static constexpr std::int32_t reach = field_side / 256;

    /// `picture` is the number of its points.
    StandingLight(const BeamProfile& profile, std::uint32_t picture)
        : max_{std::max<std::uint32_t>(std::min(profile.rate / 1000, picture / 10), 1)}
    {
    }

    /// Whether it may be lit for the next point that is to be.
    bool may_shine(FieldPoint at)
    {
        const FieldVector away = at - place_;
        if (points_ == 0 || std::abs(away.x) > reach || std::abs(away.y) > reach) {
            place_ = at;
            points_ = 0;
        }
        points_ = std::min(points_, max_) + 1;
        return points_ <= max_;
    }

private:
    std::uint32_t max_;
    std::uint32_t points_ = 0; ///< that have been lit around `place_`
    FieldPoint place_;
};

}
