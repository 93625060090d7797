#include "host/compiler/limits/clock_phases.hpp"

#include "host/walk/key_times.hpp"

#include <algorithm>
#include <cstdint>

namespace kfast {

ClockPhases::ClockPhases(const SceneView& scene) : clocks_{scene}
{
    if (scene.length() <= Time::frame(max_frames))
        return;
    constexpr std::int32_t even_times = 16;
    for (std::size_t clock = 0; clock < clocks_.count(); ++clock) {
        const Clock& root = clocks_[clocks_.root_of(clock)];
        if (root.loop == Loop::once)
            continue;
        Group& group = group_of(root);
        group.clocks.push_back(clock);
        std::vector<Time> shown = key_times(scene, Driver::of_clock(clock));
        for (std::int32_t i = 0; i <= even_times; ++i)
            shown.push_back({clocks_[clock].length.ticks / even_times * i});
        for (const Time time : shown)
            if (const auto at = clocks_.first_at(clock, time))
                group.times.push_back(*at);
    }
    for (Group& group : groups_) {
        std::ranges::sort(group.times);
        group.times.erase(std::unique(group.times.begin(), group.times.end()), group.times.end());
    }
}

ClockPhases::Group& ClockPhases::group_of(const Clock& root)
{
    const auto has_same_period = [&root](const Group& group) {
        return group.root.length == root.length && group.root.speed == root.speed &&
               group.root.loop == root.loop;
    };
    const auto found = std::ranges::find_if(groups_, has_same_period);
    return found != groups_.end() ? *found : groups_.emplace_back(Group{root, {}, {}});
}

void ClockPhases::put(const Group& group, Time time, std::vector<Time>& shown) const
{
    const std::vector<Time> at = clocks_.at(time);
    for (const std::size_t clock : group.clocks)
        shown[clock] = at[clock];
}

void ClockPhases::vary(MeasuredMoment moment, std::size_t max_pictures,
                       const std::function<std::size_t(const MeasuredMoment&)>& bytes_at) const
{
    moment.clocks = clocks_.at(moment.time);
    std::size_t max = bytes_at(moment);
    const std::size_t of_group = std::max<std::size_t>(max_pictures / groups_.size(), 2);
    for (const Group& group : groups_) {
        std::vector<Time> best = moment.clocks;
        const std::size_t count = std::min(group.times.size(), of_group);
        for (std::size_t i = 0; i < count; ++i) {
            put(group, group.times[i * group.times.size() / count], moment.clocks);
            if (const std::size_t bytes = bytes_at(moment); bytes > max) {
                max = bytes;
                best = moment.clocks;
            }
        }
        moment.clocks = best;
    }
}

}
