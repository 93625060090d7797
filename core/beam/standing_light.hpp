#pragma once

#include "core/beam/beam_profile.hpp"
#include "core/beam/field_point.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace kfast {

/// Takes care that a laser does not stay lit at one place: it may for 1 ms, and for a tenth of a picture, as
/// long as it shines nowhere else in between. A place is what lies within 1/256 of the field's side.
class StandingLight {
public:
    static constexpr std::int32_t reach = field_side / 256;

    /// `picture` is the number of its points.
    StandingLight(const BeamProfile& profile, std::uint32_t picture)
        : most_{std::max<std::uint32_t>(std::min(profile.rate / 1000, picture / 10), 1)}
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
        points_ = std::min(points_, most_) + 1;
        return points_ <= most_;
    }

private:
    std::uint32_t most_;
    std::uint32_t points_ = 0; ///< that have been lit around `place_`
    FieldPoint place_;
};

}
