#include "host/sound/tour.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace kfast {

namespace {

/// The point at `share` (0 … 1) of the straight line.
FieldPoint between(FieldPoint from, FieldPoint to, double share)
{
    const auto part = [share](std::int16_t begin, std::int16_t end) {
        return static_cast<std::int16_t>(std::lround(begin + (end - begin) * share));
    };
    return {part(from.x, to.x), part(from.y, to.y)};
}

}

Tour tour_of(std::span<const BeamPoint> points)
{
    Tour tour;
    tour.reserve(points.size());
    std::ranges::transform(points, std::back_inserter(tour), &BeamPoint::at);
    return tour;
}

double distance(FieldPoint from, FieldPoint to) { return std::hypot(to.x - from.x, to.y - from.y); }

Tour travel(FieldPoint from, FieldPoint to, std::uint32_t step)
{
    Tour way;
    if (step == 0)
        return way;
    const int steps = static_cast<int>(std::ceil(distance(from, to) / step));
    for (int made = 1; made < steps; ++made)
        way.push_back(between(from, to, static_cast<double>(made) / steps));
    return way;
}

Tour stretched(std::span<const FieldPoint> tour, FieldPoint next, std::size_t count)
{
    Tour longer;
    longer.reserve(count);
    for (std::size_t made = 0; made < count; ++made) {
        const std::size_t way = made * tour.size();
        const std::size_t point = way / count;
        const FieldPoint end = point + 1 < tour.size() ? tour[point + 1] : next;
        longer.push_back(
            between(tour[point], end, static_cast<double>(way % count) / static_cast<double>(count)));
    }
    return longer;
}

void TourPlayer::show(Tour tour)
{
    const std::lock_guard lock{mutex_};
    next_ = std::move(tour);
}

void TourPlayer::take(std::span<FieldPoint> points)
{
    for (FieldPoint& point : points) {
        if (at_ == tour_.size())
            begin_tour();
        point = travelled_ < travel_.size() ? travel_[travelled_++] : tour_[at_++];
    }
}

void TourPlayer::begin_tour()
{
    const FieldPoint from = tour_.back();
    {
        const std::lock_guard lock{mutex_};
        if (next_)
            tour_ = *std::exchange(next_, std::nullopt);
    }
    travel_ = travel(from, tour_.front(), step_);
    travelled_ = 0;
    at_ = 0;
}

}
