#pragma once

#include "core/pixel/paint_style.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace kfast {

/// A point in the field, the square that the beam of a vector display can reach: 65536 units wide and high,
/// x to the right, y up, (0, 0) in the middle, as in ILDA's files. A DAC of n bits has 2^(16 - n) units a
/// step. Aligned so that small processors copy it as a word, not by a call.
struct alignas(4) FieldPoint {
    std::int16_t x = 0;
    std::int16_t y = 0;

    friend constexpr bool operator==(FieldPoint, FieldPoint) = default;
};

inline constexpr std::int32_t field_side = 65536;
inline constexpr std::int32_t field_min = -32768;
inline constexpr std::int32_t field_max = 32767;

/// How far a beam travels from `a` to `b`: the larger of the distances in x and y, as its mirrors, coils or
/// pairs of plates move at once.
constexpr std::int32_t beam_travel(FieldPoint a, FieldPoint b)
{
    const std::int32_t x = a.x - b.x;
    const std::int32_t y = a.y - b.y;
    return std::max(x < 0 ? -x : x, y < 0 ? -y : y);
}

/// A displacement within the field.
struct FieldVector {
    std::int32_t x = 0; ///< within ±65535, as y
    std::int32_t y = 0;

    /// The length in field units: not less than it is, and up to 1/200 and a unit more. Exact along the axes.
    ///
    /// A vector is as long as the longest of its projections in all directions. Of 32 directions all around,
    /// one is always within 5.625 degrees, so that the longest projection divided by the cosine of that is
    /// not too short. That takes a fifth of the time of a square root.
    std::uint32_t length() const
    {
        const auto width = static_cast<std::uint32_t>(std::abs(x));
        const auto height = static_cast<std::uint32_t>(std::abs(y));
        const std::uint32_t more = std::max(width, height);
        const std::uint32_t less = std::min(width, height);
        constexpr std::uint32_t whole = 1U << 14;
        std::uint32_t longest = whole * more + 1614 * less; // 5.625 degrees, and so on every 11.25
        longest = std::max(longest, 15755 * more + 4780 * less);
        longest = std::max(longest, 14520 * more + 7761 * less);
        longest = std::max(longest, 12727 * more + 10445 * less);
        return (longest + whole - 1) / whole;
    }
};

constexpr FieldVector operator-(FieldPoint to, FieldPoint from) { return {to.x - from.x, to.y - from.y}; }

/// Where the beam is for one tick of the point clock, and how it shines.
struct BeamPoint {
    FieldPoint at;
    Colour colour = {.opacity = 0}; ///< black with an opacity of 0 where the beam is blanked, else opaque

    constexpr bool is_lit() const { return colour.opacity != 0; }
    friend constexpr bool operator==(const BeamPoint&, const BeamPoint&) = default;
};

/// How a vector display shows that one line is brighter than another.
enum class BeamBrightness : std::uint8_t {
    none,     ///< not at all: all light is white
    by_level, ///< by its Z input, or the power of its laser
    by_speed, ///< the beam goes faster along dark lines, at most 8 times (StepProfile::darkest); light is
              ///< white
};

/// How the beam of a vector display is to be moved. Lengths are in units of the field (FieldPoint), times
/// in points.
struct BeamProfile {
    std::uint32_t rate = 100'000;   ///< points in a second, 1000 … 1,000,000
    std::uint16_t lit_step = 256;   ///< how far the lit beam goes from point to point, at least 1
    std::uint16_t travel_step = 0;  ///< how far the blanked beam goes; 0: it jumps
    std::uint8_t corner_dwell = 0;  ///< how long it waits where it reverses; less at blunter corners
    std::uint8_t lit_dwell = 0;     ///< how long it waits, lit, at both ends of a line
    std::uint8_t arrival_dwell = 0; ///< how long it waits, blanked, where it has travelled to
    std::uint8_t leave_dwell = 0;   ///< how long it waits, blanked, before it travels
    std::uint8_t light_delay =
        0; ///< how much later the light is turned off than the position, for a beam that lags
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

/// Ensures that a laser does not stay lit at one place: it may for 1 ms, and for a tenth of a picture, as
/// long as it shines nowhere else in between. A place is everything within 1/256 of the field's side.
class StandingLight {
public:
    static constexpr std::int32_t reach = field_side / 256;

    /// `picture` is the number of its points.
    StandingLight(const BeamProfile& profile, std::uint32_t picture)
        : max_{std::max<std::uint32_t>(std::min(profile.rate / 1000, picture / 10), 1)}
    {
    }

    /// Whether it may be lit for the next point.
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
