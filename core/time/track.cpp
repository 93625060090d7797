#include "core/time/track.hpp"

#include <algorithm>

namespace kfast {

ProgressXY progress_between(Time from, Time to, Time time, const LawPair& laws, const SpringFeature* springs)
{
    if (time <= from || time >= to)
        return {};
    const auto passed = static_cast<std::uint32_t>((time - from).ticks);
    const auto whole = static_cast<std::uint32_t>((to - from).ticks);
    // Rounded up to the whole, the fraction would end a hold too early.
    const Fraction fraction = std::min(Fraction::ratio(passed, whole), Fraction{Fraction::one - 1});
    const Progress x = progress(laws.x, fraction, springs);
    return {x, laws.y == laws.x ? x : progress(laws.y, fraction, springs)};
}

namespace {

/// The rise of the line from `a` to `b` in the time from `from` to `to`, which are within.
std::int32_t rise(const KeySample& a, const KeySample& b, Time from, Time to)
{
    const auto part = static_cast<std::uint32_t>((to - from).ticks);
    const auto whole = static_cast<std::uint32_t>((b.time - a.time).ticks);
    return multiply(to_fine(b.value - a.value), static_cast<std::int32_t>(Fraction::ratio(part, whole).raw),
                    16);
}

std::int64_t times(std::int64_t value, std::int32_t fraction) { return rounded_shift(value * fraction, 16); }

}

std::int32_t hermite(const HermiteSpan& span, Time time)
{
    const auto& [before, from, to, after] = span;
    if (time <= from.time || from.time == to.time)
        return to_fine(from.value);
    const std::int64_t begin = before.time == from.time ? 0 : rise(before, to, from.time, to.time);
    const std::int64_t end = after.time == to.time ? 0 : rise(from, after, from.time, to.time);
    const std::int64_t change = to_fine(to.value - from.value);
    const auto fraction =
        static_cast<std::int32_t>(Fraction::ratio(static_cast<std::uint32_t>((time - from.time).ticks),
                                                  static_cast<std::uint32_t>((to.time - from.time).ticks))
                                      .raw);
    const std::int64_t cubic = begin + end - 2 * change;
    const std::int64_t square = 3 * change - 2 * begin - end;
    const std::int64_t passed = times(begin + times(square + times(cubic, fraction), fraction), fraction);
    return to_fine(from.value) + static_cast<std::int32_t>(passed);
}

namespace {

constexpr std::int32_t max_value = 1 << 20;
constexpr std::int32_t max_ticks = 1 << 30;

class KeySampleCursor {
public:
    explicit KeySampleCursor(std::span<const KeySample> keys) : keys_{keys} {}

    bool at_end() const { return keys_.empty(); }

    KeySample next()
    {
        const KeySample key = keys_.front();
        keys_ = keys_.subspan(1);
        return key;
    }

private:
    std::span<const KeySample> keys_;
};

bool is_within(std::int32_t value, std::int32_t limit) { return value >= -limit && value <= limit; }

}

bool Track::add(Time time, std::int32_t value)
{
    if (!is_within(value, max_value) || !is_within(time.ticks, max_ticks - 1))
        return false;
    const auto keys = storage_.first(count_);
    const auto place = std::ranges::lower_bound(keys, time, {}, &KeySample::time);
    if (place != keys.end() && place->time == time) {
        place->value = value;
        return true;
    }
    if (count_ == storage_.size())
        return false;
    const auto index = place - keys.begin();
    ++count_;
    const auto grown = storage_.first(count_);
    std::move_backward(grown.begin() + index, grown.end() - 1, grown.end());
    grown[static_cast<std::size_t>(index)] = {time, value};
    return true;
}

std::int32_t Track::value_at(Time time) const
{
    if (count_ == 0)
        return 0;
    return hermite(hermite_span_at(KeySampleCursor{keys()}, time), time);
}

}
