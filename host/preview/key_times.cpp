#include "host/preview/key_times.hpp"

#include <algorithm>

namespace kfast {

std::vector<Time> key_times(const SceneView& scene)
{
    std::vector<Time> times;
    for (ObjectCursor objects = scene.objects(); !objects.at_end();)
        for (KeyCursor keys = objects.next().keys; !keys.at_end();)
            times.push_back(keys.next().time);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

}
