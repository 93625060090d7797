#pragma once

#include "core/playhead.hpp"
#include "tests/event_bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kfast::test {

/// Plays events that it keeps itself, and writes their names as they are passed.
class Played {
public:
    Played(const PlayRange& stretch, const std::vector<EventView>& events)
        : bytes_{event_bytes(events)}, playhead_{stretch, EventCursor{ByteReader{bytes_}}}
    {
    }
    Played(const Played&) = delete;

    Playhead& operator*() { return playhead_; }
    Playhead* operator->() { return &playhead_; }

    std::string passed(std::int64_t ticks)
    {
        std::string names;
        playhead_.advance(ticks, [&](const EventView& event) { names += event.name; });
        return names;
    }

private:
    std::vector<std::byte> bytes_;
    Playhead playhead_;
};

}
