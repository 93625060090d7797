#pragma once

#include "core/playhead.hpp"
#include "library/kfast.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace kfast {

/// An animation by a clock of milliseconds, one whole frame of the scene after another, with the events that
/// are passed.
class Playback {
public:
    /// As the animation's constructor.
    Playback(const SceneView& scene, Size panel, std::span<std::byte> block)
        : animation_{scene, panel, Fit::contain, block}, playhead_{scene}
    {
    }

    const Animation& animation() const { return animation_; }
    /// For setting inputs, for redraw() and show(): the next update() shows a picture in any case.
    Animation& change()
    {
        is_stale_ = true;
        return animation_;
    }

    /// Begins anew, at the next update(), with a clip or the whole scene; fails as the animation does.
    bool choose_clip(std::string_view name)
    {
        const auto clip = animation_.scene().clip(name);
        if (clip)
            begin(play_range_of(*clip));
        return clip && animation_.choose_clip(name);
    }
    void choose_scene()
    {
        begin(play_range_of(animation_.scene()));
        animation_.choose_scene();
    }

    /// Lets the scene run to where a clock shows this many milliseconds, calls
    /// event_passed(const EventView&) for each event on the way (core/playhead.hpp), and computes the
    /// picture if it is another frame than before. The first call is the beginning, whatever the clock shows;
    /// it may run over 2^32. Returns whether there is something to be drawn.
    template <class EventPassed>
    bool update(std::uint32_t milliseconds, EventPassed&& event_passed)
    {
        playhead_.advance(ticks_until(milliseconds), event_passed);
        const Time frame = frame_at(playhead_.moment());
        if (!is_stale_ && frame == shown_)
            return false;
        animation_.show_moment(frame);
        shown_ = frame;
        is_stale_ = false;
        return true;
    }

    /// Whether what plays once has reached its end, which it continues to show.
    bool finished() const { return playhead_.finished(); }

    template <PixelFormat format, class DrawRectangle>
    bool draw(std::span<std::byte> buffer, DrawRectangle&& draw_rectangle)
    {
        return animation_.draw<format>(buffer, draw_rectangle);
    }

private:
    /// 1/1000 frame per second times milliseconds, for each of which 1024 ticks pass.
    static constexpr std::uint64_t parts_of_tick = 1'000'000;

    void begin(const PlayRange& range)
    {
        playhead_ = Playhead{range, animation_.scene().events()};
        is_stale_ = true;
        is_running_ = false;
    }

    std::int64_t ticks_until(std::uint32_t milliseconds)
    {
        const std::uint32_t passed = is_running_ ? milliseconds - clock_ : 0;
        clock_ = milliseconds;
        is_running_ = true;
        const std::uint64_t parts =
            rest_ + std::uint64_t{passed} * animation_.scene().frame_rate() * Time::ticks_per_frame;
        rest_ = static_cast<std::uint32_t>(parts % parts_of_tick);
        return static_cast<std::int64_t>(parts / parts_of_tick);
    }

    /// The end of what plays once need not be a whole frame, nor the beginning of a clip.
    Time frame_at(Time moment) const
    {
        const Time whole = Time::frame(moment.ticks / Time::ticks_per_frame);
        return finished() ? moment : std::max(whole, playhead_.range().begin);
    }

    Animation animation_;
    Playhead playhead_;
    Time shown_;
    std::uint32_t clock_ = 0;
    std::uint32_t rest_ = 0; ///< parts of a tick
    bool is_running_ = false;
    bool is_stale_ = true;
};

}
