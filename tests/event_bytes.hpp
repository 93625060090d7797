#pragma once

#include "core/scene/scene_view.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kfast::test {

/// Events as a scene stores them; `events` rise in time. Names are literals.
inline std::vector<std::byte> event_bytes(const std::vector<EventView>& events)
{
    std::vector<std::byte> bytes;
    Time before;
    for (const EventView& event : events) {
        auto code = static_cast<std::uint32_t>(2 * (event.time - before).ticks + 1);
        for (; code >= 0x80; code >>= 7)
            bytes.push_back(static_cast<std::byte>(code | 0x80));
        bytes.push_back(static_cast<std::byte>(code));
        bytes.push_back(static_cast<std::byte>(event.name.size()));
        for (const char letter : event.name)
            bytes.push_back(static_cast<std::byte>(letter));
        before = event.time;
    }
    return bytes;
}

}
