#pragma once

#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <vector>

namespace kfast {

/// What the clocks of a scene show at a time, in their order.
inline std::vector<Time> clock_times(const SceneView& scene, Time time)
{
    std::vector<Time> shown;
    for (ClockCursor clocks = scene.clocks(); !clocks.at_end();) {
        const Clock clock = clocks.next();
        shown.push_back(clock.at(SceneTime{time, {}, shown}.at(clock.driver)));
    }
    return shown;
}

}
