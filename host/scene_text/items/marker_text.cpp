#include "host/scene_text/items/marker_text.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene_text/values/grid.hpp"
#include "host/scene_text/values/names.hpp"
#include "host/scene_text/values/nodes.hpp"

#include <algorithm>
#include <iterator>

namespace kfast::scene_text {
namespace {

class MarkerText {
public:
    MarkerText(const art::Document& document, std::int32_t length, art::Losses& losses)
        : length_{length}, repeats_{document.loop == Loop::repeat}, losses_{losses}
    {
        std::vector<art::Marker> markers = document.markers;
        std::ranges::stable_sort(markers, {}, &art::Marker::time);
        for (const art::Marker& marker : markers)
            add(marker);
    }

    std::vector<kdl::Node> take()
    {
        std::ranges::move(events_, std::back_inserter(clips_));
        return std::move(clips_);
    }

private:
    void add(const art::Marker& marker)
    {
        const double end = marker.time + marker.duration;
        if (marker.time > off_grid(length_, times) || (marker.time < 0 && end <= 0)) {
            losses_.add({"marker outside of the animation", clean_name(marker.name, "marker"), marker.time,
                         "it is left out"});
            return;
        }
        if (marker.duration > 0)
            add_clip(marker.name, on_grid(marker.time, times), std::min(on_grid(end, times), length_));
        if (marker.time >= 0)
            add_event(marker.name, std::min(on_grid(marker.time, times), length_));
    }

    void add_clip(const std::string& name, std::int32_t from, std::int32_t to)
    {
        if (to <= from)
            return;
        if (clips_.size() == scene::max_clips) {
            losses_.add({"more than " + std::to_string(scene::max_clips) + " markers that last",
                         "",
                         {},
                         "the first of them are clips, the others only events"});
            return;
        }
        kdl::Node clip = named_node("clip", text(names_.unique(name, "clip")));
        set(clip, "from", number(from, times));
        set(clip, "to", number(to, times));
        clips_.push_back(std::move(clip));
    }

    /// The end of a scene that repeats is its beginning.
    void add_event(const std::string& name, std::int32_t ticks)
    {
        const std::int32_t moment = repeats_ && ticks == length_ ? 0 : ticks;
        events_.push_back(named_node("event", number(moment, times), text(clean_name(name, "marker"))));
    }

    std::int32_t length_;
    bool repeats_;
    art::Losses& losses_;
    Names names_ = {};
    std::vector<kdl::Node> clips_ = {};
    std::vector<kdl::Node> events_ = {};
};

}

std::vector<kdl::Node> marker_nodes(const art::Document& document, std::int32_t length, art::Losses& losses)
{
    return MarkerText{document, length, losses}.take();
}

}
