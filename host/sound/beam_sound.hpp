#pragma once

#include "core/beam/beam_player.hpp"
#include "core/beam/beam_profile.hpp"
#include "host/beam/beam_source.hpp"
#include "host/picture/frame_source.hpp"
#include "host/sound/deflection.hpp"
#include "host/sound/sound_card.hpp"
#include "host/sound/tour.hpp"

#include <memory>
#include <span>
#include <string>

namespace kfast {

/// A beam that a sound card drives along what was shown last, for as long as this lives. Begins in the middle
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

/// Draws a scene as another source does, and drives a beam along the same pictures by a sound card.
class BeamSound final : public FrameSource {
public:
    /// Both sources are of one scene; `led` has the profile of `beam`.
    BeamSound(std::unique_ptr<FrameSource> picture, BeamSource beam, std::shared_ptr<LedBeam> led);

    const Frame& show(Time moment) override;
    void accompany(Time moment) override;
    Pace pace() const override { return picture_->pace(); }
    std::string facts() const override { return picture_->facts(); }
    void reveal(bool hidden) override { picture_->reveal(hidden); }
    bool set(std::uint32_t number, const InputContent& content) override;

private:
    std::unique_ptr<FrameSource> picture_;
    BeamSource beam_;
    std::shared_ptr<LedBeam> led_;
};

}
