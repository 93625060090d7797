#pragma once

#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"
#include "firmware/link/message.hpp"
#include "host/picture/picture.hpp"

#include <string_view>

namespace kfast {

/// Watches a simulated board while it runs.
class Onlooker {
public:
    Onlooker() = default;
    virtual ~Onlooker() = default;
    Onlooker(const Onlooker&) = delete;
    Onlooker& operator=(const Onlooker&) = delete;

    /// The picture has changed, or time has passed. It is that of the time `moment` of what plays.
    virtual void see(const Frame& picture, Time moment, const link::Playing& playing) = 0;
    virtual void hear(const EventView& event) = 0;
    /// Nothing plays, and why. The picture says so.
    virtual void see_nothing(const Frame& picture, std::string_view why) = 0;
    /// Whether the board is to be switched off. Asked often.
    virtual bool has_seen_enough() = 0;
};

}
