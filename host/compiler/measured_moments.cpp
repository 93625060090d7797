#include "host/compiler/measured_moments.hpp"

#include "host/every_item.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::int32_t most_even_moments = 4000;
constexpr std::int32_t moments_of_frame = 4;

/// Collects moments that lie within a scene.
class Moments {
public:
    explicit Moments(Time length) : length_{length} {}

    void add_evenly()
    {
        const std::int32_t step =
            std::max(Time::ticks_per_frame / moments_of_frame, length_.ticks / most_even_moments);
        for (std::int32_t ticks = 0; ticks < length_.ticks; ticks += step)
            moments_.push_back({ticks});
        moments_.push_back(length_);
    }

    template <class Cursor>
    void add_keys(Cursor keys)
    {
        while (!keys.at_end())
            add_change(keys.next().time);
    }

    std::vector<Time> sorted()
    {
        std::ranges::sort(moments_);
        moments_.erase(std::unique(moments_.begin(), moments_.end()), moments_.end());
        return std::move(moments_);
    }

private:
    void add_change(Time time)
    {
        for (const std::int32_t ticks : {time.ticks - 1, time.ticks})
            if (ticks >= 0 && ticks < length_.ticks)
                moments_.push_back({ticks});
    }

    Time length_;
    std::vector<Time> moments_;
};

void add_keys(const ItemView& item, Moments& moments)
{
    for (TrackCursor tracks = item.tracks; !tracks.at_end();) {
        const TrackView track = tracks.next();
        if (!track.is_fixed)
            moments.add_keys(track.keys);
    }
    if (item.kind != ItemKind::object)
        return;
    moments.add_keys(item.object.keys());
    if (item.object.carrier == Carrier::backbones)
        moments.add_keys(item.object.backbones.keys());
}

}

std::vector<Time> measured_moments(const SceneView& scene)
{
    Moments moments{scene.length()};
    moments.add_evenly();
    every_item(scene, [&moments](const ItemView& item) { add_keys(item, moments); });
    return moments.sorted();
}

}
