#pragma once

#include "core/bytes/op_counter.hpp"
#include "core/math/fixed.hpp"
#include "core/time/key_interval.hpp"
#include "core/time/time.hpp"

#include <cstdint>

namespace kfast {

/// Values of tracks are computed in 1/256 of their unit.
inline constexpr int fine_bits = 8;

/// A value at a moment; |value| is at most 2^20.
struct KeySample {
    Time time;
    std::int32_t value = 0;
};

/// The keys around a moment: it lies at `from` or between `from` and `to`. The one before is `from` again if
/// there is none, and the one after `to`. All are the same before the first key and from the last one on.
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
/// The curve leaves the range of the values by at most 8/27 of it: no slope times the time of the way is more
/// than the range.
std::int32_t hermite(const HermiteSpan& span, Time time);

/// A reader of anything that has a `time` and a `value` (KeyReader).
template <KeyReader Cursor>
HermiteSpan hermite_span_at(Cursor keys, Time time)
{
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

/// Two values of keys, and how far the way from one to the other has come.
struct KeySpan {
    std::int32_t from;
    std::int32_t to;
    Progress progress;
};

/// Which of the two laws of a key governs.
enum class LawAxis : std::uint8_t { x, y };

/// Of a quantity in 1/16 px, in 1/256 of it.
constexpr Fixed fine_pixels(std::int32_t fine)
{
    return Fixed::from_raw(fine * (Fixed::one >> (4 + fine_bits)));
}

/// Rounded to nearest, halves up, in 1/256 of the unit of the values.
constexpr std::int32_t fine_value(const KeySpan& key_span)
{
    return key_span.from * (1 << fine_bits) +
           multiply(key_span.to - key_span.from, key_span.progress.raw, 16 - fine_bits);
}

}
