#pragma once

#include "core/bytes/expects.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <algorithm>
#include <cstdint>

namespace kfast {

/// The position of playing, and the events that it passes. It counts within one round: it can run for ever.
///
/// An event is passed when playing arrives at its time, from either side, and once for each arrival: not
/// again when playing goes on from there, nor when it reverses there. At a position that is set, at first or
/// by seek(), it arrives with the next advance(). So the events that are reported depend on the path alone,
/// not on how it is divided into advances. A repeating range ends and begins at one time, which looks like
/// the beginning: forwards the events at the end are passed first, then those at the beginning; backwards it
/// is the other way round. Events outside the range are not passed.
class Playhead {
public:
    static constexpr std::int32_t as_authored = 1 << 16;
    static constexpr std::int32_t fastest = 16 * as_authored;

    /// Sets it to the beginning, to run as authored. What `events` reads must outlive the playhead.
    Playhead(const PlayRange& range, EventCursor events);
    /// For the whole scene, whose bytes must outlive the playhead.
    explicit Playhead(const SceneView& scene) : Playhead{play_range_of(scene), scene.events()} {}

    const PlayRange& range() const { return range_; }
    /// Q16 of the authored speed, within ±fastest; negative speeds run backwards, 0 is a stop.
    std::int32_t speed() const { return speed_; }
    void set_speed(std::int32_t speed)
    {
        expects(speed >= -fastest && speed <= fastest);
        speed_ = speed;
    }

    /// Sets it to any time of the timeline; a time outside the range is mapped into it by its loop:
    /// in `ping_pong`, a time after the end is one of the way back. Reports nothing itself.
    void seek(Time moment);

    /// Lets `ticks` of the scene's time pass, 0 … 2^40, and calls report(const EventView&) for every event
    /// on the way, in the order of passing; of events at one time, the first first, and backwards the last
    /// first. Fractions of a tick are carried along. Reads the list of events from its beginning, once for
    /// each round and backwards once for each event to report.
    template <class Report>
    void advance(std::int64_t ticks, Report&& report);
    void advance(std::int64_t ticks)
    {
        advance(ticks, [](const EventView&) {});
    }

    /// The time to be shown, rounded down to a tick: within the range, its ends included.
    Time moment() const { return {floor(place_)}; }
    /// Whether it is on the way back of `ping_pong`.
    bool returning() const { return returning_; }
    /// Whether `once` has come to the end that it runs to; it stays there.
    bool finished() const { return range_.loop == Loop::once && place_ == goal(); }

private:
    /// Ticks of the timeline in Q16.
    using Position = std::int64_t;
    /// The whole ticks from `first` to `last`, both included.
    struct Ticks {
        std::int32_t first = 0;
        std::int32_t last = 0;
    };

    static constexpr Position place_of(Time time) { return Position{time.ticks} << 16; }
    static constexpr std::int32_t floor(Position place) { return static_cast<std::int32_t>(place >> 16); }
    static constexpr std::int32_t ceiling(Position place) { return floor(place + 0xFFFF); }

    bool runs_back() const { return (speed_ < 0) != returning_; }
    /// The end that it runs to.
    Position goal() const { return place_of(runs_back() ? range_.begin : range_.end); }
    Position distance_in(std::int64_t ticks) const;
    /// How far it goes on `distance` without a reversal.
    Position next_stop(Position distance) const;
    /// Where it arrives on the way to `place`: without the position where it is.
    Ticks ticks_to(Position place) const;
    /// The events from tick `first` on.
    EventCursor events_from(std::int32_t first) const;
    std::int32_t count(Ticks ticks) const;
    /// The event with a number that is counted from 1.
    static EventView nth(EventCursor events, std::int32_t number);

    template <class Report>
    void report_within(Ticks ticks, Report& report) const;
    template <class Report>
    void put_at(Time time, Report& report);
    template <class Report>
    void turn(Report& report);

    PlayRange range_;
    EventCursor events_;
    Position place_;
    std::int32_t speed_ = as_authored;
    bool has_events_;
    bool returning_ = false; ///< on the way back of ping-pong
    bool put_down_ = true;   ///< and has not yet arrived there
};

template <class Report>
void Playhead::advance(std::int64_t ticks, Report&& report)
{
    expects(ticks >= 0 && ticks <= std::int64_t{1} << 40);
    if (put_down_)
        put_at(moment(), report);
    put_down_ = false;
    Position distance = distance_in(ticks);
    while (distance > 0) {
        const Position stop = next_stop(distance);
        distance -= stop < place_ ? place_ - stop : stop - place_;
        report_within(ticks_to(stop), report);
        place_ = stop;
        if (finished())
            return;
        // Forwards a repeating range cannot be at its end, which looks like its beginning.
        if (place_ == goal() && (distance > 0 || !runs_back()))
            turn(report);
    }
}

template <class Report>
void Playhead::turn(Report& report)
{
    if (range_.loop == Loop::ping_pong)
        returning_ = !returning_;
    else
        put_at(runs_back() ? range_.end : range_.begin, report);
}

template <class Report>
void Playhead::put_at(Time time, Report& report)
{
    place_ = place_of(time);
    report_within({time.ticks, time.ticks}, report);
}

template <class Report>
void Playhead::report_within(Ticks ticks, Report& report) const
{
    std::int32_t left = count(ticks);
    EventCursor events = events_from(ticks.first);
    if (!runs_back())
        for (; left > 0; --left)
            report(events.next());
    for (; left > 0; --left) // the list is only read forwards
        report(nth(events, left));
}

}
