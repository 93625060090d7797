#pragma once

#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"
#include "host/beam/beam_screen.hpp"
#include "host/beam/beam_source.hpp"
#include "host/picture/frame_source.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace kfast {

/// The scene's time, counted in the points of a beam that has drawn since its beginning.
class BeamClock {
public:
    /// `frame_rate`: frames in 1000 seconds; `rate`: points in a second.
    BeamClock(std::uint32_t frame_rate, std::uint32_t rate)
        : ticks_{std::int64_t{frame_rate} * Time::ticks_per_frame}, points_{std::int64_t{rate} * 1000}
    {
    }

    /// Both round down.
    std::int64_t points_at(Time time) const { return floored(time.ticks * points_, ticks_); }
    Time time_at(std::int64_t points) const
    {
        return {static_cast<std::int32_t>(floored(points * ticks_, points_))};
    }

private:
    static constexpr std::int64_t floored(std::int64_t dividend, std::int64_t divisor)
    {
        return dividend / divisor - (dividend % divisor < 0 ? 1 : 0);
    }

    std::int64_t ticks_;  ///< of the scene
    std::int64_t points_; ///< in the same time
};

/// What the beam drew up to `moment`, for at least `memory` points: the oldest picture first.
///
/// At `moment` it is as far in its picture as if it had drawn this one since the scene began. Before that it
/// drew others, each as the scene was when the next one began, and so often that 60 pictures a second were
/// enough: whole tours. Before the scene's beginning comes what its loop determines.
std::vector<DrawnPicture> drawn_pictures(BeamSource& source, const SceneView& scene, Time moment,
                                         std::int64_t memory);

/// The average number of points of the pictures of a scene.
std::int64_t default_points(const SceneView& scene, const BeamProfile& profile);

/// What a scene looks like on the screen of a vector display.
///
/// The picture depends on scene, time, inputs, profile and display alone: it is drawn from all that the
/// beam drew in the time before that is still visible (drawn_pictures()), with the inputs as they are now.
class BeamScreenSource final : public FrameSource {
public:
    /// `scene`'s bytes must outlive the source.
    BeamScreenSource(const SceneView& scene, const BeamProfile& profile, const BeamDisplay& display,
                     Size size);

    const Frame& show(Time moment) override;
    /// "812 points  123 Hz  lit 9.2  blanked 3.1", in widths of the field.
    std::string facts() const override;
    void reveal(bool hidden) override { screen_.reveal_travel(hidden); }

    bool set(std::uint32_t number, const InputContent& content) override
    {
        return source_.set(number, content);
    }

private:
    SceneView scene_;
    BeamSource source_;
    BeamScreen screen_;
    BeamReport report_;
};

}
