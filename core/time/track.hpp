#pragma once

#include "core/bytes/expects.hpp"
#include "core/bytes/op_counter.hpp"
#include "core/math/fixed.hpp"
#include "core/time/time.hpp"
#include "core/time/velocity_law.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Reads keys, at least one, in the order of their times.
template <class C>
concept KeyReader = std::copyable<C> && requires(C cursor, const C& before)
{
    {
        before.at_end()
        } -> std::same_as<bool>;
    {
        cursor.next().time
        } -> std::convertible_to<Time>;
};

/// The two keys around a time; the same key twice before the first and from the last one on.
template <class Key>
struct KeyInterval {
    Key from;
    Key to;
};

template <KeyReader Cursor>
auto interval_at(Cursor keys, Time time)
{
    expects(!keys.at_end());
    auto from = keys.next();
    while (!keys.at_end() && from.time <= time) {
        const auto to = keys.next();
        if (to.time > time)
            return KeyInterval<decltype(from)>{from, to};
        from = to;
    }
    return KeyInterval<decltype(from)>{from, from};
}

/// The progress from one key to the next, separate for x and y.
struct ProgressXY {
    Progress x;
    Progress y;

    constexpr bool is_at_beginning() const { return x == Progress{} && y == Progress{}; }
    friend constexpr bool operator==(const ProgressXY&, const ProgressXY&) = default;
};

/// The progress at `time` from a key at `from` to one at `to`; 0 unless `time` is after `from` and before
/// `to`. `springs` is not null if one of the laws needs the feature.
ProgressXY progress_between(Time from, Time to, Time time, const LawPair& laws, const SpringFeature* springs);

/// Values of tracks are computed in 1/256 of their unit.
inline constexpr int fine_bits = 8;
constexpr std::int32_t to_fine(std::int32_t value) { return value * (1 << fine_bits); }
/// In whole units, rounded to nearest, halves up.
constexpr std::int32_t from_fine(std::int32_t fine) { return rounded_shift(fine, fine_bits); }

/// A value at a time; |value| is at most 2^20.
struct KeySample {
    Time time;
    std::int32_t value = 0;
};

/// The keys around a time: it is at `from` or between `from` and `to`. `before` is `from` again if there is
/// no such key, and `after` is `to`. All are the same before the first key and from the last one on.
struct HermiteSpan {
    KeySample before;
    KeySample from;
    KeySample to;
    KeySample after;
};

/// The value at `time` on the cubic Hermite curve from span.from to span.to, in 1/256 of the unit of the
/// values. The slope at a key is (after - before) / (time of after - time of before), and 0 at the first and
/// at the last key. Exact on a key, else within range / 40000 + 2 / 256 units of the exact value, where range
/// is the largest difference of the four values.
///
/// The curve leaves the range of the values by at most 8/27 of it: no slope times the time from key to key is
/// more than the range.
std::int32_t hermite(const HermiteSpan& span, Time time);

/// `keys` reads anything that has a `time` and a `value` (KeyReader).
template <KeyReader Cursor>
HermiteSpan hermite_span_at(Cursor keys, Time time)
{
    expects(!keys.at_end());
    const auto next = [&keys] {
        const auto key = keys.next();
        return KeySample{key.time, key.value};
    };
    KeySample before = next();
    KeySample from = before;
    while (!keys.at_end() && from.time <= time) {
        const KeySample to = next();
        if (to.time > time)
            return {before, from, to, keys.at_end() ? to : next()};
        before = from;
        from = to;
    }
    return {from, from, from, from};
}

/// Two values of keys, and the progress from one to the other.
struct KeySpan {
    std::int32_t from;
    std::int32_t to;
    Progress progress;
};

/// Which of the two laws of a key applies.
enum class LawAxis : std::uint8_t { x, y };

/// A length from 1/256 of 1/16 px.
constexpr Fixed fine_pixels(std::int32_t fine)
{
    return Fixed::from_raw(fine * (Fixed::one >> (4 + fine_bits)));
}

/// The value in 1/256 of the unit of the values, rounded to nearest, halves up.
constexpr std::int32_t fine_value(const KeySpan& key_span)
{
    return to_fine(key_span.from) +
           multiply(key_span.to - key_span.from, key_span.progress.raw, 16 - fine_bits);
}

/// One number over time, from keys that a program adds: a smooth curve through all of them (hermite()),
/// constant before the first and after the last. Keeps them in an array of the caller's, which must outlive
/// it.
///
///     std::array<KeySample, 8> keys;
///     Track height{keys};
///     height.add(Time::frame(30), 200);
///     height.add(Time::frame(0), 40);
///     const std::int32_t now = height.value_at(Time::frame(7)) >> fine_bits;
class Track {
public:
    /// Begins without keys, whatever `storage` holds.
    explicit Track(std::span<KeySample> storage) : storage_{storage} {}

    /// Keys come in any order; a key at a time that is there already gets the new value. False, and nothing
    /// changes, if the array is full, |value| is more than 2^20, or `time` is 2^30 ticks or more from 0.
    bool add(Time time, std::int32_t value);
    void clear() { count_ = 0; }

    std::size_t count() const { return count_; }
    /// The keys in the order of their times.
    std::span<const KeySample> keys() const { return storage_.first(count_); }
    /// The time of the first key; only if there is one.
    Time first_time() const
    {
        expects(count_ != 0);
        return storage_.front().time;
    }
    /// The time of the last key; only if there is one.
    Time last_time() const
    {
        expects(count_ != 0);
        return storage_[count_ - 1].time;
    }
    /// In 1/256 of the unit of the values; see hermite(). 0 if there are no keys. Any time is allowed.
    std::int32_t value_at(Time time) const;

private:
    std::span<KeySample> storage_;
    std::size_t count_ = 0;
};

}
