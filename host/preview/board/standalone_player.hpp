#pragma once

#include "core/player.hpp"
#include "host/picture/frame_source.hpp"
#include "host/player/word_block.hpp"

namespace kfast {

/// A player in memory of its own, whose inputs can be set.
class StandalonePlayer : public InputReceiver {
public:
    /// `scene`'s bytes must outlive it.
    StandalonePlayer(const SceneView& scene, Size panel, Fit fit)
        : block_{Player::block_bytes(scene, panel)}, player_{
                                                         *Player::create(scene, panel, fit, block_.bytes())}
    {
    }
    StandalonePlayer(const StandalonePlayer&) = delete;

    Player& player() { return player_; }

    void set_input(std::uint32_t number, Time place) final { player_.set_input(number, place); }
    bool set_drawing(std::uint32_t number, std::span<const InputStroke> strokes) final
    {
        return player_.set_drawing(number, strokes);
    }
    void set_text(std::uint32_t number, std::string_view text) final { player_.set_text(number, text); }

private:
    WordBlock block_;
    Player player_;
};

}
