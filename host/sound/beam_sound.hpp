#pragma once

#include "host/beam/beam_source.hpp"
#include "host/picture/frame_source.hpp"
#include "host/sound/deflection.hpp"
#include "host/sound/sound_card.hpp"
#include "host/sound/tour_player.hpp"

#include <memory>
#include <string>

namespace kfast {

/// Draws a scene as another source does, and leads a beam along the same pictures by a sound card. The sound
/// goes on for as long as it lives.
class BeamSound final : public FrameSource {
public:
    /// Both sources are of one scene. The sound has the rate of `beam`'s profile. Throws Failure where there
    /// is no such device.
    BeamSound(std::unique_ptr<FrameSource> picture, BeamSource beam, const Deflection& deflection,
              const std::string& device);

    const Frame& show(Time moment) override;
    Pace pace() const override { return picture_->pace(); }
    std::string facts() const override { return picture_->facts(); }
    void reveal(bool hidden) override { picture_->reveal(hidden); }
    void set_input(std::uint32_t number, Time place) override;
    bool set_drawing(std::uint32_t number, std::span<const LiveStroke> strokes) override;
    void set_text(std::uint32_t number, std::string_view text) override;

private:
    void next(std::span<StereoSample> samples);

    std::unique_ptr<FrameSource> picture_;
    BeamSource beam_;
    Deflection deflection_;
    TourPlayer player_;
    std::unique_ptr<SoundCard> card_; ///< opened last and closed first: it asks the player
};

}
