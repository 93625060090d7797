#include "host/preview/playback/key_times.hpp"

#include "host/walk/every_item.hpp"
#include "host/walk/skeleton_of.hpp"

#include <algorithm>
#include <utility>

namespace kfast {
namespace {

/// Collects the moments of keys that go by one clock.
class KeyTimes {
public:
    explicit KeyTimes(Clock clock) : clock_{clock} {}

    void add(const BonesView& skeleton)
    {
        add(skeleton.common_beats());
        for (BoneCursor bones = skeleton.bones(); !bones.at_end();)
            for (const BoneKeys& keys : bones.next().keys)
                if (keys.kind() == BoneKeys::Kind::own)
                    add(keys.keys().beats());
    }

    void add(const ItemView& item)
    {
        if (item.kind == ItemKind::object)
            add(item.object.keys().beats());
        if (item.kind == ItemKind::object && item.object.carrier == Carrier::backbones)
            add(item.object.backbones.keys().beats());
        for (TrackCursor tracks = item.tracks; !tracks.at_end();)
            add(tracks.next().keys.beats());
    }

    std::vector<Time> sorted()
    {
        std::ranges::sort(times_);
        times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
        return std::move(times_);
    }

private:
    void add(BeatCursor beats)
    {
        while (beats.clock() == clock_ && !beats.at_end())
            times_.push_back(beats.next().time);
    }

    Clock clock_;
    std::vector<Time> times_;
};

}

std::vector<Time> key_times(const SceneView& scene, const ItemView& item, Clock clock)
{
    KeyTimes times{clock};
    times.add(item);
    if (item.kind == ItemKind::object && item.object.carrier == Carrier::bones)
        times.add(skeleton_of(scene, item.object.skeleton));
    return times.sorted();
}

std::vector<Time> bone_key_times(const SceneView& scene, const ItemView& item, Clock clock)
{
    KeyTimes times{clock};
    times.add(skeleton_of(scene, item.object.skeleton));
    return times.sorted();
}

std::vector<Time> key_times(const SceneView& scene, Clock clock)
{
    KeyTimes times{clock};
    for (BonesCursor skeletons = scene.skeletons(); !skeletons.at_end();)
        times.add(skeletons.next());
    every_item(scene, [&times](const ItemView& item) { times.add(item); });
    return times.sorted();
}

}
