#pragma once

#include "core/player.hpp"
#include "host/picture/frame_source.hpp"

#include <cstdint>

namespace kfast {

/// What a panel of any size and format would show, drawn by the core in full redraws.
class PlayerSource : public FrameSource {
public:
    /// `scene`'s bytes must outlive the source.
    PlayerSource(const SceneView& scene, Size panel, Fit fit, PixelFormat format);

    const Frame& show(Time moment) override;
    void set_input(std::uint32_t number, Time place) override { player_.set_input(number, place); }
    bool set_drawing(std::uint32_t number, std::span<const LiveStroke> strokes) override
    {
        return player_.set_drawing(number, strokes);
    }
    void set_text(std::uint32_t number, std::string_view text) override { player_.set_text(number, text); }

private:
    std::vector<std::uint32_t> block_; // words, for the player asks for an alignment of 4
    Player player_;
    Frame frame_;
};

}
