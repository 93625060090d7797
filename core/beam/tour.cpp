#include "core/beam/tour.hpp"

#include <algorithm>

namespace kfast {

void Tour::reverse(std::size_t first, std::size_t last)
{
    const std::span<BeamLeg> section = legs_.subspan(first, last - first + 1);
    std::reverse(section.begin(), section.end());
    for (BeamLeg& leg : section)
        leg = reversed(lines_, leg);
}

std::size_t Tour::move(std::size_t first, std::size_t count, std::size_t place)
{
    const auto at = [this](std::size_t index) { return legs_.begin() + static_cast<std::ptrdiff_t>(index); };
    if (place < first) {
        std::rotate(at(place), at(first), at(first + count));
        return place;
    }
    std::rotate(at(first), at(first + count), at(place));
    return place - count;
}

std::span<const FieldPoint> Tour::starts_of(std::size_t place) const
{
    const BeamLine& line = lines_.line(legs_[place].line);
    return lines_.is_closed(line) ? lines_.points(line).first(line.points - std::size_t{1})
                                  : std::span<const FieldPoint>{};
}

namespace {

constexpr std::size_t max_moved = 3;
constexpr std::size_t max_looked_at = 16;

class Improvement {
public:
    Improvement(Tour& tour, std::size_t window, RouteEffort& effort)
        : tour_{tour}, window_{window}, effort_{effort}
    {
    }

    /// Goes around the tour until nothing has become shorter all around.
    void run()
    {
        std::size_t unchanged = 0;
        for (std::size_t place = 0; unchanged < tour_.size() && !effort_.is_spent();
             place = tour_.behind(place)) {
            is_better_ = false;
            change_at(place);
            unchanged = is_better_ ? 0 : unchanged + 1;
        }
    }

private:
    void change_at(std::size_t place);
    void choose_start(std::size_t place);
    void reverse_from(std::size_t first);
    void move_from(std::size_t first, std::size_t count);
    bool move_to(std::size_t first, std::size_t count, std::size_t place, std::int32_t gain);

    Tour& tour_;
    std::size_t window_;
    RouteEffort& effort_;
    bool is_better_ = false;
};

void Improvement::change_at(std::size_t place)
{
    choose_start(place);
    reverse_from(place);
    for (std::size_t count = 1; count <= max_moved && place + count < tour_.size(); ++count)
        move_from(place, count);
}

/// For a line with many points, checks only some at even distances, and then those around the best.
void Improvement::choose_start(std::size_t place)
{
    const std::span<const FieldPoint> starts = tour_.starts_of(place);
    if (starts.empty() || tour_.size() == 1)
        return;
    const FieldPoint from = tour_.end_of(tour_.before(place));
    const FieldPoint to = tour_.begin_of(tour_.behind(place));
    const auto travel_by = [&](FieldPoint start) {
        return beam_travel(from, start) + beam_travel(start, to);
    };
    const std::size_t known = tour_.start_of(place);
    std::size_t best = known;
    std::int32_t min = travel_by(starts[known]);
    const auto look_at = [&](std::size_t start) {
        const std::int32_t travel = travel_by(starts[start]);
        if (travel < min) {
            min = travel;
            best = start;
        }
    };
    const std::size_t step = starts.size() / max_looked_at + 1;
    for (std::size_t start = 0; start < starts.size(); start += step)
        look_at(start);
    std::size_t before = best;
    std::size_t behind = best;
    for (std::size_t away = 1; away < step; ++away) {
        before = (before == 0 ? starts.size() : before) - 1;
        behind = behind + 1 == starts.size() ? 0 : behind + 1;
        look_at(before);
        look_at(behind);
    }
    effort_.spend(static_cast<std::uint32_t>(2 * starts.size() / step + 4 * step));
    if (best == known)
        return;
    tour_.set_start(place, best);
    is_better_ = true;
}

/// Reverses parts of the tour from `first` on, each time the first one that makes the tour shorter.
void Improvement::reverse_from(std::size_t first)
{
    const std::int32_t arrival = tour_.travel_to(first);
    if (arrival == 0)
        return;
    const FieldPoint from = tour_.end_of(tour_.before(first));
    const FieldPoint begin = tour_.begin_of(first);
    const std::size_t bound = std::min(tour_.size() - (first == 0 ? 1 : 0), first + window_);
    for (std::size_t last = first; last < bound && !effort_.is_spent(); ++last) {
        const FieldPoint end = tour_.end_of(last);
        const FieldPoint to = tour_.begin_of(tour_.behind(last));
        effort_.spend(3);
        if (beam_travel(from, end) + beam_travel(begin, to) >= arrival + beam_travel(end, to))
            continue;
        tour_.reverse(first, last);
        effort_.spend(static_cast<std::uint32_t>(last - first));
        is_better_ = true;
        return;
    }
}

void Improvement::move_from(std::size_t first, std::size_t count)
{
    const std::size_t last = first + count - 1;
    const FieldPoint from = tour_.end_of(tour_.before(first));
    const FieldPoint to = tour_.begin_of(tour_.behind(last));
    const std::int32_t gain = beam_travel(from, tour_.begin_of(first)) + beam_travel(tour_.end_of(last), to) -
                              beam_travel(from, to);
    effort_.spend(3);
    if (gain <= 0)
        return;
    for (std::size_t away = 1; away <= window_ && !effort_.is_spent(); ++away) {
        if (away <= first && move_to(first, count, first - away, gain))
            return;
        if (last + 1 + away <= tour_.size() && move_to(first, count, last + 1 + away, gain))
            return;
    }
}

/// Moves them if they are nearer to their new neighbours than they gain here.
bool Improvement::move_to(std::size_t first, std::size_t count, std::size_t place, std::int32_t gain)
{
    const std::size_t next = place == tour_.size() ? 0 : place;
    const std::size_t last = first + count - 1;
    if (tour_.before(next) == last || next == first)
        return false;
    const FieldPoint from = tour_.end_of(tour_.before(next));
    const FieldPoint to = tour_.begin_of(next);
    const FieldPoint begin = tour_.begin_of(first);
    const FieldPoint end = tour_.end_of(last);
    const std::int32_t limit = gain + beam_travel(from, to);
    const std::int32_t as_is = beam_travel(from, begin) + beam_travel(end, to);
    const std::int32_t reversed = beam_travel(from, end) + beam_travel(begin, to);
    effort_.spend(5);
    if (std::min(as_is, reversed) >= limit)
        return false;
    effort_.spend(static_cast<std::uint32_t>(place < first ? first - place : place - first));
    const std::size_t now = tour_.move(first, count, place);
    if (reversed < as_is)
        tour_.reverse(now, now + count - 1);
    is_better_ = true;
    return true;
}

}

void improve(Tour& tour, std::size_t window, RouteEffort& effort) { Improvement{tour, window, effort}.run(); }

}
