#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast::bench {

/// What a frame's work is divided into.
enum class Phase : std::uint8_t {
    update,    ///< Player::show_moment: from the time to finished outlines
    draw,      ///< from outlines to pixels
    send,      ///< the firmware's loop: the clock, the playhead, handing windows to the panel
    load,      ///< what comes once: to check a scene and to make its player
    elsewhere, ///< the panel that takes the windows, and the measuring itself
};

inline constexpr std::size_t phase_count = 5;

/// What each phase has cost.
using PhaseCosts = std::array<std::uint32_t, phase_count>;

}
