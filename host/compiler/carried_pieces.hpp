#pragma once

#include "host/compiler/backbone_timeline.hpp"
#include "host/compiler/key_way.hpp"

#include <cstdint>

namespace kfast {

/// When the key of a way is what is shown, and when the way ends.
struct WayTimes {
    Time since; ///< the key's time; 0 for the first key
    Time until; ///< when the next key takes over, or nothing moves any more
    Time next;  ///< of the next key, or the key itself
};

/// As curve_pieces(), for a way in relative coordinates: looks at the curves as backbones carry them, at
/// every frame, or at 200 moments if there are more frames, and at each key of the backbones.
std::uint32_t carried_curve_pieces(const KeyWay& way, const WayTimes& times,
                                   const BackboneTimeline& backbones, std::uint32_t unit_bits, double scale);

}
