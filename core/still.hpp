#pragma once

#include "core/key_interval.hpp"
#include "core/law_pair.hpp"
#include "core/time.hpp"

#include <algorithm>
#include <limits>

namespace kfast {

/// The stretch of time around a moment in which something stays as it is at that moment: from `begin` on, up
/// to but not including `end`.
struct Still {
    Time begin = {std::numeric_limits<std::int32_t>::min()};
    Time end = {std::numeric_limits<std::int32_t>::max()};

    friend constexpr bool operator==(const Still&, const Still&) = default;
    constexpr bool contains(Time time) const { return time >= begin && time < end; }
    /// What holds for both.
    friend constexpr Still operator&(Still a, Still b)
    {
        return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
    }
};

/// Moves at any moment.
constexpr Still moving_at(Time moment) { return {moment, moment + Time{1}}; }

/// Of something on the way between two keys. Less than the whole stretch where it is not certain. Of no use
/// if `moment` is not between them.
Still still_between(Time from, Time to, Time moment, const LawPair& laws);

/// Of something that keys give, around `moment`, which lies in `keys`: it is still before the first of them
/// and from the last one on, and `between` two of them.
template <class Key>
constexpr Still still_around(const KeyInterval<Key>& keys, Time moment, Still between)
{
    if (moment < keys.from.time)
        return {Still{}.begin, keys.from.time};
    if (keys.to.time <= keys.from.time)
        return {keys.from.time, Still{}.end};
    return between;
}

}
