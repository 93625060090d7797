#pragma once

#include "core/beam/beam_player.hpp"
#include "core/beam/beam_profile.hpp"
#include "host/sound/deflection.hpp"
#include "host/sound/sound_card.hpp"
#include "host/sound/tour_player.hpp"

#include <memory>
#include <span>
#include <string>

namespace kfast {

/// A beam that a sound card leads along what was shown last, for as long as this lives. Begins in the middle
/// of the field.
class LedBeam {
public:
    /// The sound has the rate of `profile`. Throws Failure where there is no such device.
    LedBeam(const BeamProfile& profile, const Deflection& deflection, const std::string& device);

    void show(std::span<const BeamPoint> points);

private:
    void next(std::span<StereoSample> samples);

    Deflection deflection_;
    TourPlayer player_;
    std::unique_ptr<SoundCard> card_; ///< opened last and closed first: it asks the player
};

}
