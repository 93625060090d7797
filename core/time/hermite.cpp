#include "core/time/hermite.hpp"

namespace kfast {
namespace {

std::int32_t fine(std::int32_t value) { return value * (1 << fine_bits); }

/// How far the slope of the line between `a` and `b` leads in the time from `from` to `to`, which lie within.
std::int32_t rise(const KeySample& a, const KeySample& b, Time from, Time to)
{
    const auto part = static_cast<std::uint32_t>((to - from).ticks);
    const auto whole = static_cast<std::uint32_t>((b.time - a.time).ticks);
    return multiply(fine(b.value - a.value), static_cast<std::int32_t>(Fraction::ratio(part, whole).raw), 16);
}

std::int64_t times(std::int64_t value, std::int32_t fraction)
{
    return (value * fraction + Fraction::one / 2) >> 16;
}

}

std::int32_t hermite(const HermiteSpan& span, Time time)
{
    const auto& [before, from, to, after] = span;
    if (time <= from.time || from.time == to.time)
        return fine(from.value);
    const std::int64_t begin = before.time == from.time ? 0 : rise(before, to, from.time, to.time);
    const std::int64_t end = after.time == to.time ? 0 : rise(from, after, from.time, to.time);
    const std::int64_t change = fine(to.value - from.value);
    const auto fraction =
        static_cast<std::int32_t>(Fraction::ratio(static_cast<std::uint32_t>((time - from.time).ticks),
                                                  static_cast<std::uint32_t>((to.time - from.time).ticks))
                                      .raw);
    const std::int64_t cubic = begin + end - 2 * change;
    const std::int64_t square = 3 * change - 2 * begin - end;
    const std::int64_t passed = times(begin + times(square + times(cubic, fraction), fraction), fraction);
    return fine(from.value) + static_cast<std::int32_t>(passed);
}

}
