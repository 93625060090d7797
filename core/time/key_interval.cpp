#include "core/time/key_interval.hpp"

namespace kfast {

ProgressXY progress_between(Time from, Time to, Time time, const LawPair& laws)
{
    if (time <= from || time >= to)
        return {};
    const auto passed = static_cast<std::uint32_t>((time - from).ticks);
    const auto whole = static_cast<std::uint32_t>((to - from).ticks);
    // Rounded up to the whole, the share would end a hold too early.
    const Fraction fraction = std::min(Fraction::ratio(passed, whole), Fraction{Fraction::one - 1});
    const Progress x = progress(laws.x, fraction);
    return {x, laws.y == laws.x ? x : progress(laws.y, fraction)};
}

}
