#include "core/match_pictures.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace kfast {
namespace {

using Kind = PaintStep::Kind;
using StepChange = PaintStep::Change;

/// Steps that may have appeared or vanished in one place before the rest is taken to be new.
constexpr std::size_t look_ahead = 8;

void forget_partners(TracedPicture& picture)
{
    for (PaintStep& step : picture.steps()) {
        step.partner = PaintStep::no_partner;
        step.change = StepChange::all;
        step.top = step.layer.top;
        step.bottom = step.layer.bottom;
    }
}

/// Both have the same outlines: nothing of what they come from has moved.
bool stays(const PaintStep& before, const PaintStep& after, std::uint32_t moved)
{
    return before.still == after.still && (before.still.inputs & moved) == 0;
}

bool has_same_outlines(const TracedPicture& shown, const PaintStep& before, const TracedPicture& coming,
                       const PaintStep& after, std::uint32_t moved)
{
    return (stays(before, after, moved) && shown.coarseness == coming.coarseness) ||
           shown.outlines.is_equal(before.layer.outlines, coming.outlines, after.layer.outlines);
}

StepChange change_between(const TracedPicture& shown, const PaintStep& before, const TracedPicture& coming,
                          const PaintStep& after, std::uint32_t moved)
{
    if (after.kind != Kind::layer)
        return StepChange::none;
    if (before.layer.colour != after.layer.colour || before.layer.rule != after.layer.rule)
        return StepChange::all;
    return has_same_outlines(shown, before, coming, after, moved) ? StepChange::none : StepChange::outlines;
}

void join(TracedPicture& shown, std::size_t before, TracedPicture& coming, std::size_t after,
          std::uint32_t moved)
{
    PaintStep& a = shown.steps()[before];
    PaintStep& b = coming.steps()[after];
    a.partner = static_cast<std::uint16_t>(after);
    b.partner = static_cast<std::uint16_t>(before);
    a.change = b.change = change_between(shown, a, coming, b, moved);
    a.top = b.top = std::min(a.top, b.top);
    a.bottom = b.bottom = std::max(a.bottom, b.bottom);
}

bool is_same_step(const PaintStep& a, const PaintStep& b) { return a.item == b.item && a.kind == b.kind; }

/// How far `step` lies ahead in `steps`; look_ahead if it does not.
std::size_t distance_to(const PaintStep& step, std::span<const PaintStep> steps)
{
    const std::size_t most = std::min(steps.size(), look_ahead);
    for (std::size_t i = 0; i < most; ++i)
        if (is_same_step(steps[i], step))
            return i;
    return look_ahead;
}

void find_partners(TracedPicture& shown, TracedPicture& coming, std::uint32_t moved)
{
    std::size_t before = 0;
    std::size_t after = 0;
    while (before < shown.step_count && after < coming.step_count) {
        const std::size_t vanished = distance_to(coming.steps()[after], shown.steps().subspan(before));
        const std::size_t appeared = distance_to(shown.steps()[before], coming.steps().subspan(after));
        if (vanished <= appeared && vanished < look_ahead)
            join(shown, before += vanished, coming, after, moved);
        else if (appeared < look_ahead)
            join(shown, before, coming, after += appeared, moved);
        ++before;
        ++after;
    }
}

/// Whether the blending steps of both pictures are the same and in the same places.
bool blends_alike(const TracedPicture& shown, const TracedPicture& coming)
{
    const auto are_alike = [](const TracedPicture& picture, const TracedPicture& other) {
        return std::ranges::all_of(picture.steps(), [&](const PaintStep& step) {
            return step.kind == Kind::layer || (step.partner != PaintStep::no_partner &&
                                                step.opacity == other.steps()[step.partner].opacity);
        });
    };
    return are_alike(shown, coming) && are_alike(coming, shown);
}

/// What is blended counts as changed, all of it.
void change_blended(TracedPicture& picture, TracedPicture& other)
{
    int depth = 0;
    for (PaintStep& step : picture.steps()) {
        depth += step.kind == Kind::begin_blend ? 1 : step.kind == Kind::end_blend ? -1 : 0;
        if (depth == 0)
            continue;
        step.change = StepChange::all;
        if (step.partner != PaintStep::no_partner)
            other.steps()[step.partner].change = StepChange::all;
    }
}

}

void match(TracedPicture& shown, TracedPicture& coming, std::uint32_t moved)
{
    forget_partners(shown);
    forget_partners(coming);
    find_partners(shown, coming, moved);
    if (blends_alike(shown, coming))
        return;
    change_blended(shown, coming);
    change_blended(coming, shown);
}

}
