#pragma once

#include <cstdint>
#include <deque>
#include <optional>

namespace kfast {

/// Which frames a board begins when, as its run loop does (firmware/run/run.hpp): one after the other,
/// leaving out those for which it would come too late. Times are in seconds since the first one.
class BoardClock {
public:
    /// `frame_seconds` is what a frame lasts in the scene.
    explicit BoardClock(double frame_seconds) : frame_seconds_{frame_seconds} {}

    /// Begins again: frame 0 is due.
    void restart();
    bool is_due(double now) const { return next_ <= now; }
    double next() const { return next_; }
    /// The frame that the board begins at next().
    std::int64_t frame() const { return frame_; }
    /// That frame takes `seconds`; the next one follows it.
    void take(double seconds);
    /// The rate of the last frames begun, per second; none before there are two.
    std::optional<double> rate() const;

private:
    double frame_seconds_;
    double next_ = 0;
    std::int64_t frame_ = 0;
    std::deque<double> begun_; ///< the last ones, without breaks between them
};

}
