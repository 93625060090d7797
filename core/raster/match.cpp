#include "core/raster/match.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace kfast::raster {
namespace {

/// Steps that may have appeared or vanished in one place before the rest is taken to be new.
constexpr std::size_t look_ahead = 8;

void forget_partners(std::span<PaintStep> steps)
{
    for (PaintStep& step : steps)
        step.partner = PaintStep::no_partner;
}

/// How far `step` lies ahead in `steps`; look_ahead if it does not.
std::size_t distance_to(const PaintStep& step, std::span<const PaintStep> steps)
{
    const std::size_t reach = std::min(steps.size(), look_ahead);
    for (std::size_t i = 0; i < reach; ++i)
        if (steps[i].item == step.item && steps[i].kind == step.kind)
            return i;
    return look_ahead;
}

}

void match(std::span<PaintStep> shown, std::span<PaintStep> next)
{
    forget_partners(shown);
    forget_partners(next);
    std::size_t before = 0;
    std::size_t after = 0;
    while (before < shown.size() && after < next.size()) {
        const std::size_t vanished = distance_to(next[after], shown.subspan(before));
        const std::size_t appeared = distance_to(shown[before], next.subspan(after));
        const bool is_found = std::min(vanished, appeared) < look_ahead;
        if (is_found && vanished <= appeared)
            before += vanished;
        else if (is_found)
            after += appeared;
        if (is_found) {
            shown[before].partner = static_cast<std::uint16_t>(after);
            next[after].partner = static_cast<std::uint16_t>(before);
        }
        ++before;
        ++after;
    }
}

}
