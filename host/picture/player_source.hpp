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
    bool set(std::uint32_t number, const InputContent& content) override
    {
        return give_input(player_, number, content);
    }
    std::string facts() const override { return detail_.text(); }
    Detail min_detail() const override { return detail_.min(); }

private:
    WordBlock block_;
    Player player_;
    Frame frame_;
    ShownDetail detail_;
};

}
