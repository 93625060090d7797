#include "host/preview/key_times.hpp"

#include "host/every_item.hpp"

#include <algorithm>

namespace kfast {
namespace {

template <class Cursor>
void add_times(Cursor keys, std::vector<Time>& times)
{
    while (!keys.at_end())
        times.push_back(keys.next().time);
}

}

std::vector<Time> key_times(const SceneView& scene)
{
    std::vector<Time> times;
    every_item(scene, [&times](const ItemView& item) {
        if (item.kind == ItemKind::object)
            add_times(item.object.keys(), times);
        for (TrackCursor tracks = item.tracks; !tracks.at_end();)
            add_times(tracks.next().keys, times);
    });
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

}
