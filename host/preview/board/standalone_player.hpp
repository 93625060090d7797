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
        : block_{Player::block_bytes(scene, panel)},
          player_{*Player::create(scene, panel, fit, block_.bytes())}
    {
    }
    StandalonePlayer(const StandalonePlayer&) = delete;

    Player& player() { return player_; }

    bool set(std::uint32_t number, const InputContent& content) final
    {
        return give_input(player_, number, content);
    }

private:
    WordBlock block_;
    Player player_;
};

}
