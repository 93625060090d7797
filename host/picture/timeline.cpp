#include "host/picture/timeline.hpp"

#include <cstdio>
#include <cstdlib>

namespace kfast {
namespace {

std::int64_t quotient_up(std::int64_t dividend, std::int64_t divisor)
{
    return (dividend + divisor - 1) / divisor;
}

/// The ticks of the scene's time while `passes` from one end to the other are played.
std::int64_t ticks_of(const Timeline& timeline, int passes)
{
    const std::int64_t way = std::int64_t{timeline.stretch.length().ticks} * passes;
    return quotient_up(way * Playhead::as_authored, std::abs(timeline.speed));
}

}

Playhead Timeline::playhead(EventCursor events) const
{
    Playhead playhead{stretch, events};
    playhead.set_speed(speed);
    playhead.seek(speed < 0 ? stretch.end : stretch.begin);
    return playhead;
}

int Timeline::frame_count() const
{
    const std::int64_t begun = quotient_up(ticks_of(*this, 1), Time::ticks_per_frame);
    return static_cast<int>(begun) + (stretch.loop == Loop::once ? 1 : 0);
}

Time Timeline::frame_time(int frame) const { return shown_at(std::int64_t{frame} * Time::ticks_per_frame); }

std::int64_t Timeline::period_ticks() const
{
    return ticks_of(*this, stretch.loop == Loop::ping_pong ? 2 : 1);
}

Time Timeline::shown_at(std::int64_t ticks) const
{
    Playhead head = playhead();
    head.advance(ticks);
    return head.moment();
}

double Timeline::seconds(std::int64_t ticks) const
{
    return static_cast<double>(ticks) * 1000 / (static_cast<double>(frame_rate) * Time::ticks_per_frame);
}

Timeline timeline_of(const SceneView& scene) { return {scene.frame_rate(), play_range_of(scene)}; }

std::string frame_digits(int frame)
{
    char text[16];
    std::snprintf(text, sizeof text, "%04d", frame);
    return text;
}

}
