#include "core/time/key_interval.hpp"

namespace kfast {

Progress progress_between(Time from, Time to, Time time, const LawPair& laws)
{
    if (time <= from || time >= to)
        return {};
    const auto passed = static_cast<std::uint32_t>((time - from).ticks);
    const auto whole = static_cast<std::uint32_t>((to - from).ticks);
    // Rounded up to the whole, the share would end a hold too early.
    const Share share = std::min(Share::ratio(passed, whole), Share{Share::one - 1});
    const Way x = progress(laws.x, share);
    return {x, laws.y == laws.x ? x : progress(laws.y, share)};
}

}
