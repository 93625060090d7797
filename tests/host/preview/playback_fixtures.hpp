#pragma once

#include "host/preview/playback/preview_playback.hpp"
#include "tests/event_bytes.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kfast::test {

using Seconds = PreviewPlayback::Seconds;

inline constexpr Seconds start{1000};

/// 10 fps and 10 frames; keys at 0, 3, 6.5 and at the end; a clip "slow", frames 4 to 8, repeated, and one
/// that plays once, frames 2.5 to 4. Events stand at 0, 5 and 5.25 frames.
inline PlaybackSetup playback_setup(Loop loop)
{
    static const std::vector<std::byte> events =
        event_bytes({{"begin", Time{0}}, {"step", Time::frame(5)}, {"echo\x1b", {5 * 1024 + 256}}});
    return {.frame_rate = 10000,
            .parts = {{"", {Time{0}, Time::frame(10), loop}},
                      {"slow", {Time::frame(4), Time::frame(8), Loop::repeat}},
                      {"short", {{2 * 1024 + 512}, Time::frame(4), Loop::once}}},
            .keys = {Time::frame(0), Time::frame(3), {6 * 1024 + 512}, Time::frame(10)},
            .events = EventCursor{ByteReader{events}}};
}

/// The same without events.
inline PlaybackSetup silent(Loop loop)
{
    PlaybackSetup silent = playback_setup(loop);
    silent.events = EventCursor{ByteReader{}};
    return silent;
}

inline PreviewPlayback playback(Loop loop, std::optional<int> loops = std::nullopt)
{
    return {silent(loop), Pace::smooth, start, loops};
}

/// A playback with events, and the names of those that were passed.
struct RecordedPlayback {
    explicit RecordedPlayback(std::optional<int> loops = std::nullopt)
        : state{playback_setup(Loop::repeat), Pace::smooth, start, loops}
    {
        state.set_on_event([this](const EventView& event) { names.append(event.name).append(" "); });
    }
    RecordedPlayback(const RecordedPlayback&) = delete;

    std::string passed() { return std::exchange(names, {}); }

    PreviewPlayback state;
    std::string names;
};

inline Seconds after(double seconds) { return start + Seconds{seconds}; }

/// The moments, in frames, after pressing `key` so often.
inline std::vector<double> pressed(PreviewPlayback state, PreviewKey key, int times)
{
    std::vector<double> moments;
    for (int i = 0; i < times; ++i) {
        state.press(key, start);
        moments.push_back(state.time().ticks / 1024.0);
    }
    return moments;
}

}
