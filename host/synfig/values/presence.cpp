#include "host/synfig/values/presence.hpp"

#include <algorithm>
#include <iterator>

namespace kfast::synfig {
namespace {

Presence settled(bool on) { return {on ? 1.0 : 0.0, 0, 0}; }

}

Presence presence_at(const Entry& entry, double time)
{
    const auto& all = entry.switchings;
    if (all.empty())
        return settled(true);
    const auto next = std::ranges::lower_bound(all, time, {}, &Switching::time);
    if (next != all.end() && (next->time == time || next == all.begin()))
        return settled(next->on);
    const Switching& before = *std::prev(next);
    if (next == all.end() || next->on == before.on)
        return settled(before.on);
    const double share = (time - before.time) / (next->time - before.time);
    return next->on ? Presence{share, next->time, before.time} : Presence{1 - share, before.time, next->time};
}

}
