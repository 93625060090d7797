#pragma once

#include "host/beam/beam_screen.hpp"
#include "host/beam/beam_source.hpp"
#include "host/picture/frame_source.hpp"

#include <string>

namespace kfast {

/// What a scene looks like on the screen of a vector display.
///
/// The picture depends on scene, moment, inputs, profile and display alone: it is drawn from all that the
/// beam drew in the time before that is still seen (drawn_pictures.hpp), with the inputs as they are now.
class BeamScreenSource final : public FrameSource {
public:
    /// `scene`'s bytes must outlive the source.
    BeamScreenSource(const SceneView& scene, const BeamProfile& profile, const BeamDisplay& display,
                     Size size);

    const Frame& show(Time moment) override;
    /// "812 points  123 Hz  lit 9.2  blanked 3.1", in widths of the field.
    std::string facts() const override;
    void reveal(bool hidden) override { screen_.reveal_travel(hidden); }

    void set_input(std::uint32_t number, Time place) override { source_.set_input(number, place); }
    bool set_drawing(std::uint32_t number, std::span<const InputStroke> strokes) override
    {
        return source_.set_drawing(number, strokes);
    }
    void set_text(std::uint32_t number, std::string_view text) override { source_.set_text(number, text); }

private:
    SceneView scene_;
    BeamSource source_;
    BeamScreen screen_;
    BeamReport report_;
};

}
