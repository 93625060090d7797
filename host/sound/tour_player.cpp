#include "host/sound/tour_player.hpp"

#include <utility>

namespace kfast {

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
