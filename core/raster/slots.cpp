#include "core/raster/slots.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace kfast::raster {

namespace {

/// Steps that may have appeared or vanished at one position before the rest is taken to be new.
constexpr std::size_t look_ahead = 8;

void forget_partners(std::span<PaintStep> steps)
{
    for (PaintStep& step : steps)
        step.partner = PaintStep::no_partner;
}

/// How far `step` is ahead in `steps`; look_ahead if it is not.
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

namespace {

constexpr std::uint8_t marked = 0; ///< any slot: which one is found out by assign()

/// Marks the layers within groups. Returns how many layers there are.
std::size_t find_groups(std::span<PaintStep> steps)
{
    std::size_t layers = 0;
    int depth = 0;
    for (PaintStep& step : steps) {
        depth += step.kind == PaintStep::Kind::begin_group ? 1
                 : step.kind == PaintStep::Kind::end_group ? -1
                                                           : 0;
        step.is_in_group = depth != 0;
        step.slot = step.kind == PaintStep::Kind::layer ? marked : PaintStep::no_slot;
        layers += step.slot == marked ? 1U : 0U;
    }
    return layers;
}

bool is_clear(const PaintStep& layer) { return layer.is_in_group || layer.colour.opacity != 255; }

bool is_same_group(const PaintStep& step, std::span<const PaintStep> others)
{
    return step.kind == PaintStep::Kind::layer ||
           (step.partner != PaintStep::no_partner && step.opacity == others[step.partner].opacity);
}

}

void Slots::set_pictures(std::span<PaintStep> next, std::span<PaintStep> shown)
{
    next_ = next;
    shown_ = shown;
    match(shown, next);
    std::size_t layers = find_groups(next) + find_groups(shown);
    for (const PaintStep& step : next)
        layers -= step.kind == PaintStep::Kind::layer && step.partner != PaintStep::no_partner ? 1U : 0U;
    has_same_groups_ = true;
    for (const PaintStep& step : next)
        has_same_groups_ = has_same_groups_ && is_same_group(step, shown);
    for (const PaintStep& step : shown)
        has_same_groups_ = has_same_groups_ && is_same_group(step, next);
    hold_all_ = layers <= slot_count;
    if (hold_all_)
        assign();
}

bool Slots::assign()
{
    same = recoloured = clear = shown_clear = grouped = even_odd = 0;
    free_ = slot_count;
    std::size_t before = 0;
    bool have_room = true;
    for (PaintStep& step : next_) {
        const bool has_partner = step.partner != PaintStep::no_partner;
        while (has_partner && before < step.partner)
            have_room = put(nullptr, &shown_[before++]) && have_room;
        have_room = put(&step, has_partner ? &shown_[before++] : nullptr) && have_room;
    }
    while (before < shown_.size())
        have_room = put(nullptr, &shown_[before++]) && have_room;
    return have_room;
}

/// Assigns a slot to a layer of either picture or of both, if it is marked.
bool Slots::put(PaintStep* next, PaintStep* shown)
{
    const bool is_marked = (next != nullptr && next->slot != PaintStep::no_slot) ||
                           (shown != nullptr && shown->slot != PaintStep::no_slot);
    if (!is_marked)
        return true;
    if (free_ == 0)
        return false;
    const auto slot = static_cast<std::uint8_t>(--free_);
    const SlotMask bit = bit_of(slot);
    layers_[slot] = {next, shown};
    if (next != nullptr) {
        next->slot = slot;
        clear |= is_clear(*next) ? bit : 0;
        grouped |= next->is_in_group ? bit : 0;
        even_odd |= next->rule == FillRule::even_odd ? bit : 0;
    }
    if (shown != nullptr) {
        shown->slot = slot;
        shown_clear |= is_clear(*shown) ? bit : 0;
    }
    if (next == nullptr || shown == nullptr) {
        recoloured |= bit;
        return true;
    }
    same |= has_same_outlines(*next, *shown) ? bit : 0;
    recoloured |= is_same_colour(*next, *shown) ? 0 : bit;
    return true;
}

/// Compares also the opacity of the groups around.
bool Slots::is_same_colour(const PaintStep& next, const PaintStep& shown) const
{
    return next.colour == shown.colour && next.is_in_group == shown.is_in_group &&
           (has_same_groups_ || !next.is_in_group);
}

void Slots::clear_marks()
{
    for (const std::span<PaintStep> steps : {next_, shown_})
        for (PaintStep& step : steps)
            step.slot = PaintStep::no_slot;
}

bool Slots::looks_same(SlotMask next, SlotMask shown) const
{
    if (next == shown && (next & recoloured) == 0)
        return true;
    const SlotMask top = top_bit(next);
    const SlotMask shown_top = top_bit(shown);
    if ((top & clear) != 0 || (shown_top & shown_clear) != 0)
        return false;
    return (top == 0 ? background : layers_[number_of(top)].next->colour) ==
           (shown_top == 0 ? background : layers_[number_of(shown_top)].shown->colour);
}

bool Slots::is_hidden(SlotMask next, SlotMask shown, SlotMask touched) const
{
    const SlotMask top = top_bit(next);
    return top != 0 && top == top_bit(shown) && (touched & (2 * top - 1)) == 0 &&
           (top & (clear | shown_clear | recoloured)) == 0;
}

}
