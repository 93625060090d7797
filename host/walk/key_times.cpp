#include "host/walk/key_times.hpp"

#include "host/walk/every_item.hpp"
#include "host/walk/scene_clocks.hpp"

#include <algorithm>
#include <utility>

namespace kfast {
namespace {

/// Collects the times of keys that go by one driver.
class KeyTimes {
public:
    explicit KeyTimes(Driver driver) : driver_{driver} {}

    void add(const SkeletonView& skeleton)
    {
        add(skeleton.common_key_times());
        for (BoneCursor bones = skeleton.bones(); !bones.at_end();)
            for (const BoneKeys& keys : bones.next().keys)
                if (keys.kind() == BoneKeys::Kind::own)
                    add(keys.keys().key_times());
    }

    void add(const ItemView& item)
    {
        if (item.kind == ItemKind::object)
            add(item.object.keys().key_times());
        if (item.kind == ItemKind::object && item.object.deformer == Deformer::backbones)
            add(item.object.backbones.keys().key_times());
        for (TrackCursor tracks = item.tracks; !tracks.at_end();)
            add(tracks.next().keys.key_times());
    }

    std::vector<Time> sorted()
    {
        std::ranges::sort(times_);
        times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
        return std::move(times_);
    }

private:
    void add(KeyTimeCursor key_times)
    {
        while (key_times.driver() == driver_ && !key_times.at_end())
            times_.push_back(key_times.next().time);
    }

    Driver driver_;
    std::vector<Time> times_;
};

}

std::vector<Time> key_times(const SceneView& scene, const ItemView& item, Driver driver)
{
    KeyTimes times{driver};
    times.add(item);
    if (item.kind == ItemKind::object && item.object.deformer == Deformer::bones)
        times.add(skeleton_of(scene, item.object.skeleton));
    return times.sorted();
}

std::vector<Time> bone_key_times(const SceneView& scene, const ItemView& item, Driver driver)
{
    KeyTimes times{driver};
    times.add(skeleton_of(scene, item.object.skeleton));
    return times.sorted();
}

std::vector<Time> key_times(const SceneView& scene, Driver driver)
{
    KeyTimes times{driver};
    for (SkeletonCursor skeletons = scene.skeletons(); !skeletons.at_end();)
        times.add(skeletons.next());
    every_item(scene, [&times](const ItemView& item) { times.add(item); });
    return times.sorted();
}

std::vector<Time> shown_key_times(const SceneView& scene)
{
    std::vector<Time> times = key_times(scene);
    const SceneClocks clocks{scene};
    for (std::size_t clock = 0; clock < clocks.count(); ++clock)
        for (const Time key : key_times(scene, Driver::of_clock(clock)))
            if (const auto time = clocks.first_at(clock, key); time && *time <= scene.length())
                times.push_back(*time);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

}
