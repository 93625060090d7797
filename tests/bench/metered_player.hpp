#pragma once

#include "core/player.hpp"
#include "tests/bench/phase.hpp"

#include <cstddef>
#include <span>

namespace kfast::bench {

/// A player for the firmware's loop whose work is told apart from that of the loop.
template <class Meter>
class MeteredPlayer {
public:
    MeteredPlayer(Player& player, Meter& meter) : player_{player}, meter_{meter} {}

    void show_moment(Time moment)
    {
        meter_.enter(Phase::update);
        player_.show_moment(moment);
        meter_.enter(Phase::send);
    }

    bool is_coarse() const { return player_.is_coarse(); }

    template <PixelFormat format>
    std::span<const Change> draw_changes(std::span<std::byte> pixels, Size granularity, int area_bytes)
    {
        meter_.enter(Phase::draw);
        const auto changes = player_.draw_changes<format>(pixels, granularity, area_bytes);
        meter_.enter(Phase::send);
        return changes;
    }

private:
    Player& player_;
    Meter& meter_;
};

}
