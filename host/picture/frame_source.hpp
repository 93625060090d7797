#pragma once

#include "core/live_drawing.hpp"
#include "core/time.hpp"
#include "host/picture/frame.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace kfast {

/// When a picture changes while a scene plays.
enum class Pace {
    smooth,    ///< whenever it is asked
    by_frames, ///< at the frames of the scene alone
};

/// Draws a scene on one panel. Which one is chosen at run time, hence virtual.
class FrameSource {
public:
    virtual ~FrameSource() = default;

    /// The picture at a moment of the timeline, the scene's very end included. Valid until the next call.
    virtual const Frame& show(Time moment) = 0;
    /// As Player::set_input().
    virtual void set_input(std::uint32_t number, Time place) = 0;
    /// As Player::set_drawing().
    virtual bool set_drawing(std::uint32_t number, std::span<const LiveStroke> strokes) = 0;
    /// As Player::set_text().
    virtual void set_text(std::uint32_t number, std::string_view text) = 0;
    virtual Pace pace() const { return Pace::smooth; }
};

}
