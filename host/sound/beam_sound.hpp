#pragma once

#include "host/beam/beam_source.hpp"
#include "host/picture/frame_source.hpp"
#include "host/sound/led_beam.hpp"

#include <memory>
#include <string>

namespace kfast {

/// Draws a scene as another source does, and leads a beam along the same pictures by a sound card.
class BeamSound final : public FrameSource {
public:
    /// Both sources are of one scene; `led` has the profile of `beam`.
    BeamSound(std::unique_ptr<FrameSource> picture, BeamSource beam, std::shared_ptr<LedBeam> led);

    const Frame& show(Time moment) override;
    void accompany(Time moment) override;
    Pace pace() const override { return picture_->pace(); }
    std::string facts() const override { return picture_->facts(); }
    void reveal(bool hidden) override { picture_->reveal(hidden); }
    void set_input(std::uint32_t number, Time place) override;
    bool set_drawing(std::uint32_t number, std::span<const InputStroke> strokes) override;
    void set_text(std::uint32_t number, std::string_view text) override;

private:
    std::unique_ptr<FrameSource> picture_;
    BeamSource beam_;
    std::shared_ptr<LedBeam> led_;
};

}
