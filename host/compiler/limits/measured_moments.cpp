#include "host/compiler/limits/measured_moments.hpp"

#include "core/time/time.hpp"
#include "host/walk/every_item.hpp"
#include "host/walk/input_text.hpp"
#include "host/walk/key_times.hpp"
#include "host/walk/scene_clocks.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>

namespace kfast {
namespace {

constexpr std::int32_t max_even_moments = 4000;
constexpr std::int32_t moments_of_frame = 4;
constexpr int input_combinations = 1500;
/// For all pictures together, about a second on a computer: in the unit of SceneView::cost(),
/// which does not know how many pieces large curves have, and in bytes of outlines, which tell that.
constexpr std::size_t max_cost = 3U << 21;
constexpr std::size_t max_bytes_together = std::size_t{1} << 28;

/// Collects times of one driver, which goes from 0 to `length`.
class DriverMoments {
public:
    DriverMoments(Driver driver, Time length) : driver_{driver}, length_{length} {}

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
        if (item.object.deformer == Deformer::backbones)
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
        if (keys.key_times().driver() == driver_)
            while (!keys.at_end())
                add_change(keys.next().time);
    }

    void add_change(Time time)
    {
        for (const std::int32_t ticks : {time.ticks - 1, time.ticks})
            if (ticks >= 0 && ticks < length_.ticks)
                moments_.push_back({ticks});
    }

    Driver driver_;
    Time length_;
    std::vector<Time> moments_;
};

std::vector<Time> moments_of(const SceneView& scene, Driver driver, Time length, std::int32_t step)
{
    DriverMoments moments{driver, length};
    moments.add_evenly(step);
    every_item(scene, [&moments](const ItemView& item) { moments.add_keys(item); });
    return moments.sorted();
}

/// The times at which a clock first comes to its keys, a tick before and after each, and to some that are
/// spaced evenly over its own time.
void add_first_pass(const SceneView& scene, const SceneClocks& clocks, std::size_t clock,
                    std::vector<Time>& times)
{
    constexpr std::int32_t even_times = 32;
    const Driver driver = Driver::of_clock(clock);
    const Time length = std::min(clocks[clock].length, Clock::end_of_time);
    std::vector<Time> shown = key_times(scene, driver);
    for (std::int32_t i = 1; i <= even_times; ++i)
        shown.push_back({length.ticks / even_times * i});
    for (const Time time : shown)
        if (const auto at = clocks.first_at(clock, time))
            for (const std::int32_t ticks : {at->ticks - 1, at->ticks, at->ticks + 1})
                if (ticks >= 0 && ticks <= scene.length().ticks)
                    times.push_back({ticks});
}

std::vector<Time> times_of(const SceneView& scene)
{
    const Time length = scene.length();
    std::vector<Time> times =
        moments_of(scene, {}, length,
                   std::max(Time::ticks_per_frame / moments_of_frame, length.ticks / max_even_moments));
    const SceneClocks clocks{scene};
    for (std::size_t clock = 0; clock < clocks.count(); ++clock)
        add_first_pass(scene, clocks, clock, times);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

/// The values that the inputs of a scene may have.
class InputPlaces {
public:
    explicit InputPlaces(const SceneView& scene) : default_value_(scene.input_count())
    {
        put_default_places(scene.inputs(), default_value_);
        for (std::uint32_t i = 0; i < default_value_.size(); ++i)
            sample_places_.push_back((scene.number_inputs() & bit_of_input(i)) != 0
                                         ? moments_of(scene, {static_cast<std::uint8_t>(i + 1)}, whole_input,
                                                      whole_input.ticks / even_places)
                                         : std::vector<Time>{default_value_[i]});
        find_largest(scene);
    }

    const std::vector<Time>& default_places() const { return default_value_; }
    /// Those that labels show where they have most points there.
    const std::vector<Time>& largest_places() const { return largest_; }
    /// Samples of one input, in order: evenly spaced ones, those of its keys, and the tick before each.
    std::size_t sample_count(std::size_t input) const
    {
        return std::min(sample_places_[input].size(), max_samples);
    }
    Time sample_place(std::size_t input, std::size_t index) const
    {
        const std::vector<Time>& places = sample_places_[input];
        return places[index * places.size() / sample_count(input)];
    }

    /// A pseudorandom value, mostly an end, as a button sets it; the same sequence every time.
    Time any(std::size_t input)
    {
        const auto choice = random_() % 8;
        if (choice < 4)
            return choice % 2 == 0 ? Time{} : whole_input;
        if (choice < 7)
            return sample_places_[input][random_() % sample_places_[input].size()];
        return default_value_[input];
    }

    std::uint32_t random() { return static_cast<std::uint32_t>(random_()); }

private:
    static constexpr std::int32_t even_places = 32;
    static constexpr std::size_t max_samples = 256;

    void find_largest(const SceneView& scene)
    {
        largest_ = default_value_;
        for (std::uint32_t i = 0; i < largest_.size(); ++i) {
            if ((scene.number_inputs() & bit_of_input(i)) == 0)
                continue;
            if (const auto place = largest_number_place(scene, i)) {
                largest_[i] = *place;
                sample_places_[i].push_back(*place);
            }
        }
    }

    std::vector<Time> default_value_;
    std::vector<Time> largest_;
    std::vector<std::vector<Time>> sample_places_;
    std::mt19937 random_{1};
};

/// Varies each input alone, then all of them at once, at any time.
void add_with_inputs(const std::vector<Time>& times, InputPlaces& places,
                     std::vector<MeasuredMoment>& moments)
{
    const auto any_time = [&] { return times[places.random() % times.size()]; };
    const std::size_t inputs = places.default_places().size();
    for (std::size_t input = 0; input < inputs; ++input)
        for (std::size_t i = 0; i < places.sample_count(input); ++i) {
            moments.push_back({any_time(), places.default_places()});
            moments.back().inputs[input] = places.sample_place(input, i);
        }
    for (const Time end : {Time{}, whole_input})
        for (const Time time : {times.front(), times[times.size() / 2]})
            moments.push_back({time, std::vector<Time>(inputs, end)});
    for (int i = 0; i < input_combinations; ++i) {
        moments.push_back({any_time(), {}});
        for (std::size_t input = 0; input < inputs; ++input)
            moments.back().inputs.push_back(places.any(input));
    }
}

}

std::vector<MeasuredMoment> measured_moments(const SceneView& scene)
{
    const std::vector<Time> times = times_of(scene);
    InputPlaces places{scene};
    std::vector<MeasuredMoment> moments;
    moments.reserve(times.size());
    for (const Time time : times)
        moments.push_back({time, places.default_places()});
    if (places.largest_places() != places.default_places())
        for (const Time time : times)
            moments.push_back({time, places.largest_places()});
    if (scene.number_inputs() != 0)
        add_with_inputs(times, places, moments);
    return moments;
}

std::size_t affordable_pictures(const SceneView& scene, std::size_t outline_bytes)
{
    return std::min(max_cost / std::max<std::uint32_t>(scene.cost(), 1),
                    max_bytes_together / std::max<std::size_t>(outline_bytes, 1));
}

void thin_out(std::vector<MeasuredMoment>& moments, std::size_t count)
{
    const std::size_t left = std::max<std::size_t>(count, 2);
    if (moments.size() <= left)
        return;
    std::vector<MeasuredMoment> spread;
    for (std::size_t i = 0; i < left; ++i)
        spread.push_back(std::move(moments[i * (moments.size() - 1) / (left - 1)]));
    moments = std::move(spread);
}

}
