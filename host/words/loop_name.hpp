#pragma once

#include "core/scene/scene_view.hpp"

#include <string_view>

namespace kfast {

/// As scenes are written.
constexpr std::string_view loop_name(Loop loop)
{
    switch (loop) {
    case Loop::once:
        return "once";
    case Loop::repeat:
        return "repeat";
    case Loop::ping_pong:
        return "ping-pong";
    }
    return {};
}

}
