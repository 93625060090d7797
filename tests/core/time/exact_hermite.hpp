#pragma once

#include "core/time/track.hpp"

#include <cstddef>
#include <vector>

namespace kfast::test {

/// The smooth curve through keys in the order of their times, of which there is at least one: slope
/// (v[i + 1] - v[i - 1]) / (t[i + 1] - t[i - 1]) at an inner key, 0 at both ends, held outside.
class ExactHermite {
public:
    explicit ExactHermite(std::vector<KeySample> keys) : keys_{std::move(keys)} {}

    double at(Time time) const
    {
        if (time <= keys_.front().time)
            return keys_.front().value;
        std::size_t next = 1;
        while (next < keys_.size() && keys_[next].time <= time)
            ++next;
        if (next == keys_.size())
            return keys_.back().value;
        const KeySample& from = keys_[next - 1];
        const KeySample& to = keys_[next];
        const double duration = double(to.time.ticks) - from.time.ticks;
        const double u = (double(time.ticks) - from.time.ticks) / duration;
        return (1 + 2 * u) * (1 - u) * (1 - u) * from.value +
               u * (1 - u) * (1 - u) * duration * slope(next - 1) + u * u * (3 - 2 * u) * to.value +
               u * u * (u - 1) * duration * slope(next);
    }

private:
    double slope(std::size_t key) const
    {
        if (key == 0 || key + 1 == keys_.size())
            return 0;
        const KeySample& before = keys_[key - 1];
        const KeySample& after = keys_[key + 1];
        return (double(after.value) - before.value) / (double(after.time.ticks) - before.time.ticks);
    }

    std::vector<KeySample> keys_;
};

}
