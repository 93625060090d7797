#pragma once

#include "core/pose/scene_state.hpp"
#include "host/picture/frame_source.hpp"
#include "host/player/word_block.hpp"

#include <cstdint>
#include <string>

namespace kfast {

/// Writes a scene on a panel at any time as elements of an SVG.
class SvgSource : public InputReceiver {
public:
    /// `scene`'s bytes must outlive the source.
    SvgSource(const SceneView& scene, Size panel, Fit fit);

    /// What is visible at a time of the timeline over the background, in pixels of the panel.
    std::string show(Time moment) { return player_.show(moment); }
    Size size() const { return panel_; }
    Colour background() const { return player_.scene().colour(0); }

    bool set(std::uint32_t number, const InputContent& content) override
    {
        return give_input(player_, number, content);
    }

private:
    class SvgPlayer : public SceneState {
    public:
        SvgPlayer(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> memory)
            : SceneState{scene, panel, fit, memory}
        {
        }

        using SceneState::bytes_for;

        std::string show(Time moment);
    };

    Size panel_;
    WordBlock memory_;
    SvgPlayer player_;
};

}
