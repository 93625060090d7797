#pragma once

#include "core/clock.hpp"
#include "core/key_interval.hpp"
#include "core/law_pair.hpp"
#include "core/time.hpp"

#include <algorithm>
#include <limits>

namespace kfast {

/// Where something stays as it is at a moment: in the stretch of time around it, from `begin` on, up to but
/// not including `end`, as long as none of `inputs` moves.
struct Still {
    Time begin = {std::numeric_limits<std::int32_t>::min()};
    Time end = {std::numeric_limits<std::int32_t>::max()};

    std::uint32_t inputs = 0; ///< a bit for each, the first in the lowest

    friend constexpr bool operator==(const Still&, const Still&) = default;
    constexpr bool contains(Time time) const { return time >= begin && time < end; }
    /// Whether it stays up to `time` where the inputs `moved`, a bit for each, have moved since.
    constexpr bool holds(Time time, std::uint32_t moved) const
    {
        return contains(time) && (inputs & moved) == 0;
    }
    /// What holds for both.
    friend constexpr Still operator&(Still a, Still b)
    {
        return {std::max(a.begin, b.begin), std::min(a.end, b.end), a.inputs | b.inputs};
    }
};

/// Moves at any moment.
constexpr Still moving_at(Time moment) { return {.begin = moment, .end = moment + Time{1}}; }

constexpr std::uint32_t bit_of_input(std::uint32_t number) { return std::uint32_t{1} << number; }

/// Of something whose keys go by `clock`, if it is `still` there.
constexpr Still still_by_clock(Clock clock, Still still)
{
    return clock.is_time() ? still : Still{.inputs = bit_of_input(clock.input - 1U)};
}

/// Moves at any moment, and maybe with any input.
constexpr Still moving_with_any_input(Time moment)
{
    return {.begin = moment, .end = moment + Time{1}, .inputs = ~std::uint32_t{0}};
}

/// Of something on the way between two keys. Less than the whole stretch where it is not certain. Of no use
/// if `moment` is not between them.
Still still_between(Time from, Time to, Time moment, const LawPair& laws);

/// Of something that keys give, around `moment`, which lies in `keys`: it is still before the first of them
/// and from the last one on, and `between` two of them.
template <class Key>
constexpr Still still_around(const KeyInterval<Key>& keys, Time moment, Still between)
{
    if (moment < keys.from.time)
        return {.begin = Still{}.begin, .end = keys.from.time};
    if (keys.to.time <= keys.from.time)
        return {.begin = keys.from.time, .end = Still{}.end};
    return between;
}

}
