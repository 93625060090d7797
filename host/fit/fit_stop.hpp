#pragma once

#include <stop_token>

namespace kfast::fit {

/// Thrown by a report that is not wanted any more, after the picture that it looks at.
struct FitStopped {};

inline void go_on(const std::stop_token& stop)
{
    if (stop.stop_requested())
        throw FitStopped{};
}

}
