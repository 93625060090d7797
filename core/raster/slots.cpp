#include "core/raster/slots.hpp"

#include "core/raster/match.hpp"

namespace kfast::raster {
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

void Slots::set_pictures(std::span<PaintStep> coming, std::span<PaintStep> shown)
{
    coming_ = coming;
    shown_ = shown;
    match(shown, coming);
    std::size_t layers = find_groups(coming) + find_groups(shown);
    for (const PaintStep& step : coming)
        layers -= step.kind == PaintStep::Kind::layer && step.partner != PaintStep::no_partner ? 1U : 0U;
    has_same_groups_ = true;
    for (const PaintStep& step : coming)
        has_same_groups_ = has_same_groups_ && is_same_group(step, shown);
    for (const PaintStep& step : shown)
        has_same_groups_ = has_same_groups_ && is_same_group(step, coming);
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
    for (PaintStep& step : coming_) {
        const bool has_partner = step.partner != PaintStep::no_partner;
        while (has_partner && before < step.partner)
            have_room = put(nullptr, &shown_[before++]) && have_room;
        have_room = put(&step, has_partner ? &shown_[before++] : nullptr) && have_room;
    }
    while (before < shown_.size())
        have_room = put(nullptr, &shown_[before++]) && have_room;
    return have_room;
}

/// Gives a slot to a layer, if it is marked, of either picture or of both.
bool Slots::put(PaintStep* coming, PaintStep* shown)
{
    const bool is_marked = (coming != nullptr && coming->slot != PaintStep::no_slot) ||
                           (shown != nullptr && shown->slot != PaintStep::no_slot);
    if (!is_marked)
        return true;
    if (free_ == 0)
        return false;
    const auto slot = static_cast<std::uint8_t>(--free_);
    const SlotMask bit = bit_of(slot);
    layers_[slot] = {coming, shown};
    if (coming != nullptr) {
        coming->slot = slot;
        clear |= is_clear(*coming) ? bit : 0;
        grouped |= coming->is_in_group ? bit : 0;
        even_odd |= coming->rule == FillRule::even_odd ? bit : 0;
    }
    if (shown != nullptr) {
        shown->slot = slot;
        shown_clear |= is_clear(*shown) ? bit : 0;
    }
    if (coming == nullptr || shown == nullptr) {
        recoloured |= bit;
        return true;
    }
    same |= has_same_outlines(*coming, *shown) ? bit : 0;
    recoloured |= is_same_colour(*coming, *shown) ? 0 : bit;
    return true;
}

/// With the opacity of what is around it.
bool Slots::is_same_colour(const PaintStep& coming, const PaintStep& shown) const
{
    return coming.colour == shown.colour && coming.is_in_group == shown.is_in_group &&
           (has_same_groups_ || !coming.is_in_group);
}

void Slots::clear_marks()
{
    for (const std::span<PaintStep> steps : {coming_, shown_})
        for (PaintStep& step : steps)
            step.slot = PaintStep::no_slot;
}

bool Slots::looks_same(SlotMask coming, SlotMask shown) const
{
    if (coming == shown && (coming & recoloured) == 0)
        return true;
    const SlotMask top = top_bit(coming);
    const SlotMask shown_top = top_bit(shown);
    if ((top & clear) != 0 || (shown_top & shown_clear) != 0)
        return false;
    return (top == 0 ? background : layers_[number_of(top)].coming->colour) ==
           (shown_top == 0 ? background : layers_[number_of(shown_top)].shown->colour);
}

bool Slots::is_hidden(SlotMask coming, SlotMask shown, SlotMask touched) const
{
    const SlotMask top = top_bit(coming);
    return top != 0 && top == top_bit(shown) && (touched & (2 * top - 1)) == 0 &&
           (top & (clear | shown_clear | recoloured)) == 0;
}

}
