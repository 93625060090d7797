#pragma once

#include "core/bytes/op_counter.hpp"
#include "core/time/law_pair.hpp"
#include "core/time/time.hpp"

#include <algorithm>
#include <concepts>
#include <cstdint>

namespace kfast {

/// Reads keys, of which there is at least one, in the order of their times.
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

/// The two keys around a moment; the same key twice before the first and from the last one on.
template <class Key>
struct KeyInterval {
    Key from;
    Key to;
};

template <KeyReader Cursor>
auto interval_at(Cursor keys, Time time)
{
    auto from = keys.next();
    while (!keys.at_end() && from.time <= time) {
        const auto to = keys.next();
        if (to.time > time)
            return KeyInterval<decltype(from)>{from, to};
        from = to;
    }
    return KeyInterval<decltype(from)>{from, from};
}

/// The share of the way between two keys, apart for x and y.
struct ProgressXY {
    Progress x;
    Progress y;

    constexpr bool is_at_beginning() const { return x == Progress{} && y == Progress{}; }
    friend constexpr bool operator==(const ProgressXY&, const ProgressXY&) = default;
};

/// How far the way that leads from the time `from` to the time `to` has come at `time`; nothing of it on and
/// before `from`, nor if there is no way.
ProgressXY progress_between(Time from, Time to, Time time, const LawPair& laws);

}
