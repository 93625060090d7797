#include "core/still.hpp"

#include "core/velocity_law.hpp"

#include <cstdint>

namespace kfast {
namespace {

/// `part` / `count` of the way from a time to another.
Time time_at(Time from, Time to, std::uint32_t part, std::uint32_t count)
{
    const auto whole = static_cast<std::uint32_t>((to - from).ticks);
    return from + Time{static_cast<std::int32_t>(std::uint64_t{whole} * part / count)};
}

/// The share of a moment is rounded, and so is that from which on a step is taken: nearer to the borders of a
/// step than `doubt`, nothing but the moment itself is known to lie in it.
Still still_in_step(const VelocityLaw& law, Time from, Time to, Time moment)
{
    const Way way = progress_between(from, to, moment, {law, law}).x;
    const auto step = (static_cast<std::uint32_t>(way.raw) * law.steps + Way::one / 2) / Way::one;
    const Time doubt{(to - from).ticks / Way::one + 1};
    return {.begin = std::min(moment, time_at(from, to, step, law.steps) + doubt + Time{1}),
            .end = std::max(moment + Time{1}, time_at(from, to, step + 1, law.steps) - doubt)};
}

Still still_by(const VelocityLaw& law, Time from, Time to, Time moment)
{
    if (law.kind == VelocityLaw::Kind::hold)
        return {.begin = from, .end = to};
    const bool is_stepped = law.kind == VelocityLaw::Kind::steps && moment >= from && moment < to;
    return is_stepped ? still_in_step(law, from, to, moment) : moving_at(moment);
}

}

Still still_between(Time from, Time to, Time moment, const LawPair& laws)
{
    const Still by_x = still_by(laws.x, from, to, moment);
    return laws.y == laws.x ? by_x : by_x & still_by(laws.y, from, to, moment);
}

}
