#pragma once

#include "core/beam/beam_player.hpp"
#include "core/beam/beam_profile.hpp"
#include "host/picture/frame_source.hpp"
#include "host/player/word_block.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace kfast {

/// Draws a scene for a beam, in memory of its own.
class BeamSource final : public InputReceiver {
public:
    static constexpr std::uint32_t any_number = std::numeric_limits<std::uint32_t>::max();

    /// `scene`'s bytes must outlive the source. A picture has no more than `budget` points.
    explicit BeamSource(const SceneView& scene, const BeamProfile& profile,
                        std::uint32_t budget = any_number);

    /// The points of the picture at a time of the timeline, including the scene's very end. Valid until the
    /// next call.
    std::span<const BeamPoint> show(Time moment);
    /// The report of that picture.
    const BeamReport& report() const { return player_.report(); }
    const BeamProfile& profile() const { return player_.profile(); }

    bool set(std::uint32_t number, const InputContent& content) override
    {
        return give_input(player_, number, content);
    }

private:
    WordBlock block_;
    BeamPlayer player_;
    std::vector<BeamPoint> points_;
};

/// CRC-32 of the points of a picture, the same on every target for the same scene, time and profile. For each
/// point 8 bytes: x, then y, each with the low byte first; red, green, blue; 255 where the beam is lit, else
/// 0, as then the colours are.
std::uint32_t hash(std::span<const BeamPoint> points);

}
