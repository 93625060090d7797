#include "core/playhead.hpp"

#include "core/bytes/expects.hpp"
#include "core/math/fixed.hpp"

namespace kfast {

Playhead::Playhead(const PlayRange& range, EventCursor events)
    : range_{range},
      events_{events},
      place_{place_of(range.begin)},
      has_events_{count({range.begin.ticks, range.end.ticks}) > 0}
{
    expects(range.begin < range.end);
}

void Playhead::seek(Time moment)
{
    const std::int64_t length = range_.length().ticks;
    const std::int64_t period = range_.loop == Loop::ping_pong ? 2 * length : length;
    std::int64_t offset = std::int64_t{moment.ticks} - range_.begin.ticks;
    if (range_.loop == Loop::once) {
        offset = std::clamp<std::int64_t>(offset, 0, length);
    } else {
        const auto divisor = static_cast<std::uint32_t>(period);
        const std::uint32_t away =
            remainder(static_cast<std::uint64_t>(offset < 0 ? -offset : offset), divisor);
        offset = offset < 0 && away != 0 ? period - away : away;
    }
    returning_ = offset > length;
    place_ = place_of(range_.begin) + ((returning_ ? period - offset : offset) << 16);
    put_down_ = true;
}

Playhead::Position Playhead::distance_in(std::int64_t ticks) const
{
    const Position distance = ticks * (speed_ < 0 ? -speed_ : speed_);
    if (has_events_ || range_.loop == Loop::once)
        return distance;
    const auto length = static_cast<std::uint32_t>(range_.length().ticks);
    const std::uint32_t period = range_.loop == Loop::ping_pong ? 2 * length : length;
    const auto whole_ticks = static_cast<std::uint64_t>(distance >> 16);
    return Position{remainder(whole_ticks, period)} << 16 | (distance & 0xFFFF);
}

Playhead::Position Playhead::next_stop(Position distance) const
{
    return runs_back() ? std::max(goal(), place_ - distance) : std::min(goal(), place_ + distance);
}

Playhead::Ticks Playhead::ticks_to(Position place) const
{
    if (runs_back())
        return {ceiling(place), ceiling(place_) - 1};
    return {floor(place_) + 1, floor(place)};
}

EventCursor Playhead::events_from(std::int32_t first) const
{
    EventCursor events = events_;
    for (EventCursor ahead = events; !ahead.at_end() && ahead.next().time.ticks < first;)
        events = ahead;
    return events;
}

std::int32_t Playhead::count(Ticks ticks) const
{
    std::int32_t found = 0;
    for (EventCursor events = events_from(ticks.first);
         !events.at_end() && events.next().time.ticks <= ticks.last;)
        ++found;
    return found;
}

EventView Playhead::nth(EventCursor events, std::int32_t number)
{
    for (; number > 1; --number)
        events.next();
    return events.next();
}

}
