#pragma once

#include "core/time.hpp"

#include <cstdint>

namespace kfast {

/// How far a scene has come, counted in whole frames from its start. It counts within one turn of the scene
/// and so can run for ever.
class Playhead {
public:
    /// `length` is at least one frame, at most kfb::max_time.
    constexpr Playhead(Time length, Loop loop)
        : length_{static_cast<std::uint32_t>(length.ticks)}, loop_{loop}
    {
    }

    /// From 0 to the length of the scene.
    constexpr Time time() const
    {
        return wrap({static_cast<std::int32_t>(position_)}, {static_cast<std::int32_t>(length_)}, loop_);
    }

    constexpr void advance(std::uint32_t frames)
    {
        for (; frames > 0; --frames)
            step();
    }

private:
    static constexpr std::uint32_t frame = Time::ticks_per_frame;

    constexpr void step()
    {
        const std::uint32_t turn = loop_ == Loop::ping_pong ? 2 * length_ : length_;
        if (position_ < turn - frame)
            position_ += frame;
        else
            position_ = loop_ == Loop::once ? length_ : position_ - (turn - frame);
    }

    std::uint32_t length_;
    std::uint32_t position_ = 0; ///< in ticks; on the way back of ping-pong it lies beyond the length
    Loop loop_;
};

}
