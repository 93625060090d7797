#include "host/compiler/measured_moments.hpp"

#include "host/every_item.hpp"

#include <algorithm>
#include <cstdint>
#include <random>

namespace kfast {
namespace {

constexpr std::int32_t most_even_moments = 4000;
constexpr std::int32_t moments_of_frame = 4;
constexpr std::int32_t places_of_input = 64;
constexpr std::int32_t times_of_input = 8;

/// Collects moments of one clock, which goes from 0 to `length`.
class ClockMoments {
public:
    ClockMoments(Clock clock, Time length) : clock_{clock}, length_{length} {}

    void add_evenly(std::int32_t step)
    {
        for (std::int32_t ticks = 0; ticks < length_.ticks; ticks += step)
            moments_.push_back({ticks});
        moments_.push_back(length_);
    }

    void add_keys(const ItemView& item)
    {
        for (TrackCursor tracks = item.tracks; !tracks.at_end();) {
            const TrackView track = tracks.next();
            if (!track.is_fixed)
                add_keys(track.keys);
        }
        if (item.kind != ItemKind::object)
            return;
        add_keys(item.object.keys());
        if (item.object.carrier == Carrier::backbones)
            add_keys(item.object.backbones.keys());
    }

    std::vector<Time> sorted()
    {
        std::ranges::sort(moments_);
        moments_.erase(std::unique(moments_.begin(), moments_.end()), moments_.end());
        return std::move(moments_);
    }

private:
    template <class Cursor>
    void add_keys(Cursor keys)
    {
        if (keys.beats().clock() == clock_)
            while (!keys.at_end())
                add_change(keys.next().time);
    }

    void add_change(Time time)
    {
        for (const std::int32_t ticks : {time.ticks - 1, time.ticks})
            if (ticks >= 0 && ticks < length_.ticks)
                moments_.push_back({ticks});
    }

    Clock clock_;
    Time length_;
    std::vector<Time> moments_;
};

std::vector<Time> moments_of(const SceneView& scene, Clock clock, Time length, std::int32_t step)
{
    ClockMoments moments{clock, length};
    moments.add_evenly(step);
    every_item(scene, [&moments](const ItemView& item) { moments.add_keys(item); });
    return moments.sorted();
}

std::vector<Time> times_of(const SceneView& scene)
{
    const Time length = scene.length();
    return moments_of(scene, {}, length,
                      std::max(Time::ticks_per_frame / moments_of_frame, length.ticks / most_even_moments));
}

std::vector<Time> usual_places(const SceneView& scene)
{
    std::vector<Time> places;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();) {
        const InputView input = inputs.next();
        places.push_back(input.place_of(input.usual));
    }
    return places;
}

/// As they would be moved by nobody in particular; the same ones every time.
void add_anywhere(const std::vector<Time>& times, std::size_t inputs, std::vector<MeasuredMoment>& moments)
{
    std::mt19937 random{1};
    for (const Time time : times) {
        std::vector<Time> places(inputs);
        for (Time& place : places)
            place.ticks = static_cast<std::int32_t>(random() % (whole_input.ticks + 1U));
        moments.push_back({time, std::move(places)});
    }
}

void add_ways(const SceneView& scene, const std::vector<Time>& usual, std::vector<MeasuredMoment>& moments)
{
    for (std::size_t i = 0; i < usual.size(); ++i) {
        const Clock clock{static_cast<std::uint8_t>(i + 1)};
        for (const Time place : moments_of(scene, clock, whole_input, whole_input.ticks / places_of_input))
            for (std::int32_t part = 0; part < times_of_input; ++part) {
                MeasuredMoment moment{{scene.length().ticks / times_of_input * part}, usual};
                moment.inputs[i] = place;
                moments.push_back(std::move(moment));
            }
    }
}

}

std::vector<MeasuredMoment> measured_moments(const SceneView& scene)
{
    const std::vector<Time> times = times_of(scene);
    const std::vector<Time> usual = usual_places(scene);
    std::vector<MeasuredMoment> moments;
    for (const Time time : times)
        moments.push_back({time, usual});
    if (usual.empty())
        return moments;
    add_anywhere(times, usual.size(), moments);
    add_ways(scene, usual, moments);
    return moments;
}

}
