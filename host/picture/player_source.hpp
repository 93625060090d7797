#pragma once

#include "core/player.hpp"
#include "host/picture/frame_source.hpp"
#include "host/player/word_block.hpp"

#include <cstdint>
#include <string>

namespace kfast {

/// What a panel of any size and format would show, drawn by the core in full redraws.
class PlayerSource : public FrameSource {
public:
    /// `scene`'s bytes must outlive the source.
    PlayerSource(const SceneView& scene, Size panel, Fit fit, PixelFormat format);

    const Frame& show(Time moment) override;
    void set_input(std::uint32_t number, Time place) override { player_.set_input(number, place); }
    bool set_drawing(std::uint32_t number, std::span<const InputStroke> strokes) override
    {
        return player_.set_drawing(number, strokes);
    }
    void set_text(std::uint32_t number, std::string_view text) override { player_.set_text(number, text); }
    std::string facts() const override { return detail_.text(); }
    Detail min_detail() const override { return detail_.min(); }

private:
    WordBlock block_;
    Player player_;
    Frame frame_;
    ShownDetail detail_;
};

}
