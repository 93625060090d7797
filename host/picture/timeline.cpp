#include "host/picture/timeline.hpp"

#include <algorithm>

namespace kfast {

int Timeline::frame_count() const
{
    const std::int64_t begun =
        (std::int64_t{length.ticks} + Time::ticks_per_frame - 1) / Time::ticks_per_frame;
    return static_cast<int>(begun) + (loop == Loop::once ? 1 : 0);
}

Time Timeline::frame_time(int frame) const
{
    const std::int64_t ticks = std::int64_t{frame} * Time::ticks_per_frame;
    return {static_cast<std::int32_t>(std::min<std::int64_t>(ticks, length.ticks))};
}

std::int64_t Timeline::period_ticks() const
{
    return std::int64_t{length.ticks} * (loop == Loop::ping_pong ? 2 : 1);
}

Time Timeline::shown_at(std::int64_t ticks) const
{
    const std::int64_t period = period_ticks();
    const std::int64_t place = loop == Loop::once ? std::min(ticks, period) : ticks % period;
    return {static_cast<std::int32_t>(place > length.ticks ? period - place : place)};
}

double Timeline::seconds(std::int64_t ticks) const
{
    return static_cast<double>(ticks) * 1000 / (static_cast<double>(frame_rate) * Time::ticks_per_frame);
}

Timeline timeline_of(const SceneView& scene) { return {scene.frame_rate(), scene.length(), scene.loop()}; }

}
