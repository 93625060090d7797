#include "host/beam/beam_display.hpp"

#include <algorithm>
#include <array>

namespace kfast {
namespace {

/// The plates of a scope follow at once, so this is its DAC: an MCP4922 changes by 0.55 V/µs, of 4.1 V, and
/// is there after 4.5 µs.
constexpr BeamDeflection plates{.bandwidth = 300e3, .damping = 1, .top_speed = 134e3};

/// Chosen: a yoke that is there within the ten points that the profile crt waits.
constexpr BeamDeflection coils{.bandwidth = 20e3, .damping = 0.75, .top_speed = 6e3};

/// What the ILDA test pattern at 30,000 points a second comes to is a bandwidth of 2.4 kHz. The others are
/// chosen: without overshoot such a mirror lags behind by the four points of the profile galvo.
constexpr BeamDeflection mirrors{.bandwidth = 2.4e3, .damping = 1, .top_speed = 2.5e3};

/// Spots and half-lives are chosen: those of the eye and of a camera are longer than those of any phosphor
/// for moving pictures.
constexpr std::array displays{
    BeamDisplay{"scope", plates, 0.6, 8, Phosphor::green},
    BeamDisplay{"crt", coils, 0.5, 8, Phosphor::white},
    BeamDisplay{"galvo", mirrors, 0.7, 8, Phosphor::rgb},
};

}

const BeamDisplay& display_of(std::string_view profile_name)
{
    return *std::ranges::find(displays, profile_name, &BeamDisplay::name);
}

}
