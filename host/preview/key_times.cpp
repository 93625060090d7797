#include "host/preview/key_times.hpp"

#include "host/every_item.hpp"

#include <algorithm>

namespace kfast {
namespace {

Clock clock_of(const BeatCursor& beats) { return beats.clock(); }

template <class Cursor>
Clock clock_of(const Cursor& keys)
{
    return keys.beats().clock();
}

template <class Cursor>
void add_times(Cursor keys, std::vector<Time>& times)
{
    while (clock_of(keys).is_time() && !keys.at_end())
        times.push_back(keys.next().time);
}

void add_times(const BoneView& bone, std::vector<Time>& times)
{
    for (const BoneKeys& keys : bone.keys)
        if (keys.kind() == BoneKeys::Kind::own)
            add_times(keys.keys(), times);
}

void add_times(const BonesView& skeleton, std::vector<Time>& times)
{
    add_times(skeleton.common_beats(), times);
    for (BoneCursor bones = skeleton.bones(); !bones.at_end();)
        add_times(bones.next(), times);
}

}

std::vector<Time> key_times(const SceneView& scene)
{
    std::vector<Time> times;
    for (BonesCursor skeletons = scene.skeletons(); !skeletons.at_end();)
        add_times(skeletons.next(), times);
    every_item(scene, [&times](const ItemView& item) {
        if (item.kind == ItemKind::object)
            add_times(item.object.keys(), times);
        if (item.kind == ItemKind::object && item.object.carrier == Carrier::backbones)
            add_times(item.object.backbones.keys(), times);
        for (TrackCursor tracks = item.tracks; !tracks.at_end();)
            add_times(tracks.next().keys, times);
    });
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

}
