#pragma once

#include "core/time/hermite.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// One number over time, from key times that a program adds: a smooth curve through all of them, held before
/// the first and behind the last (core/time/hermite.hpp). Keeps them in an array of the caller's, which must
/// outlive it.
///
///     std::array<KeySample, 8> keys;
///     Track height{keys};
///     height.add(Time::frame(30), 200);
///     height.add(Time::frame(0), 40);
///     const std::int32_t now = height.value_at(Time::frame(7)) >> fine_bits;
class Track {
public:
    /// Begins without key times, whatever `storage` holds.
    explicit Track(std::span<KeySample> storage) : storage_{storage} {}

    /// In any order; a key time that is there already gets the new value. False, and nothing is changed, if
    /// the array is full, |value| is more than 2^20, or `time` is 2^30 ticks or more away from 0.
    bool add(Time time, std::int32_t value);
    void clear() { count_ = 0; }

    std::size_t count() const { return count_; }
    /// In the order of their times.
    std::span<const KeySample> keys() const { return storage_.first(count_); }
    /// Only if there is a key time.
    Time first_time() const { return storage_.front().time; }
    Time last_time() const { return storage_[count_ - 1].time; }
    /// In 1/256 of the unit of the values; see hermite(). 0 if there are no key times. Any time is allowed.
    std::int32_t value_at(Time time) const;

private:
    std::span<KeySample> storage_;
    std::size_t count_ = 0;
};

}
