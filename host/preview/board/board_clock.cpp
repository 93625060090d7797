#include "host/preview/board/board_clock.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {

void BoardClock::restart()
{
    next_ = 0;
    frame_ = 0;
    begun_.clear();
}

void BoardClock::take(double seconds)
{
    constexpr std::size_t of_late = 12;
    begun_.push_back(next_);
    if (begun_.size() > of_late)
        begun_.pop_front();
    const double done = next_ + seconds;
    frame_ = std::max(frame_ + 1, static_cast<std::int64_t>(std::floor(done / frame_seconds_)));
    next_ = std::max(done, static_cast<double>(frame_) * frame_seconds_);
}

std::optional<double> BoardClock::rate() const
{
    if (begun_.size() < 2)
        return std::nullopt;
    return static_cast<double>(begun_.size() - 1) / (begun_.back() - begun_.front());
}

}
