#include "core/scene/check/picture_cost.hpp"

#include "core/math/stroke_trimmer.hpp"
#include "core/scene/kfb_limits.hpp"

namespace kfast {
namespace {

// Instructions of a Cortex-M0 (host/fit/cost_table.cpp has their averages).
constexpr std::uint32_t per_item = 512;
constexpr std::uint32_t per_track = 64;
constexpr std::uint32_t per_layer = 1024;
constexpr std::uint32_t per_filled_point = 512;
constexpr std::uint32_t per_stroked_point = 1024;
constexpr std::uint32_t per_trimmed_point = 512; ///< each time that it is traced
constexpr std::uint32_t per_dash = 8192;
constexpr std::uint32_t per_order_looked_at = 32;
constexpr std::uint32_t per_path_segment = 128;
constexpr std::uint32_t per_timeline = 256;
constexpr std::uint32_t per_key_passed = 64;
constexpr std::uint32_t per_track_with_new_keys = 256;
constexpr std::uint32_t per_bone = 2048;
constexpr std::uint32_t per_border = 48;

/// The product of it and the cost of a point does not overflow; more exceeds the maximum cost anyway.
constexpr std::uint32_t max_points = 1U << 20;

constexpr std::uint32_t max_keys = 1U << 24; ///< no product of it overflows

constexpr std::uint32_t thousands(std::uint32_t instructions) { return instructions / 1024 + 1; }

/// The number of fills and strokes.
constexpr std::uint32_t layers_of(const ObjectStyle& style)
{
    return (style.is_filled ? 1U : 0U) + (style.is_stroked ? 1U : 0U);
}

}

SceneParts::SceneParts(Time length) : length_{length}
{
    while (static_cast<std::uint32_t>(length.ticks) >> shift_ >= max)
        ++shift_;
}

std::uint32_t SceneParts::between(Time from, Time to) const
{
    if (from >= to || from > length_)
        return 0;
    const std::uint32_t first = static_cast<std::uint32_t>(from.ticks) >> shift_;
    const std::uint32_t last = static_cast<std::uint32_t>(std::min(to.ticks - 1, length_.ticks)) >> shift_;
    return all >> (max - 1 - last) & all << first;
}

void PictureCost::add(std::uint32_t cost, std::uint32_t parts)
{
    if (parts == SceneParts::all) {
        always_ = std::min(always_ + std::min(cost, max), max);
        return;
    }
    for (std::uint16_t& part : in_part_) {
        if ((parts & 1) != 0)
            part = static_cast<std::uint16_t>(std::min(part + std::min(cost, max), max));
        parts >>= 1;
    }
}

std::uint32_t PictureCost::largest() const
{
    return std::min(always_ + *std::ranges::max_element(in_part_), max);
}

std::uint32_t cost_of_item(std::uint32_t tracks) { return thousands(per_item + per_track * tracks); }

std::uint32_t cost_of_leaf(const ObjectStyle& style, std::uint32_t points, std::uint32_t per_point)
{
    const std::uint32_t fill = style.is_filled ? per_filled_point + per_point : 0;
    const std::uint32_t stroke = style.is_stroked ? per_stroked_point + per_point : 0;
    return thousands(per_layer * layers_of(style) + std::min(points, max_points) * (fill + stroke));
}

/// All points are traced to measure the strokes, then twice for each batch of them.
std::uint32_t cost_of_trim(const ObjectStyle& style, std::uint32_t points, std::uint32_t strokes)
{
    const std::uint32_t passes = 2 * (std::min(strokes, max_points) / StrokeTrimmer::batch + 1) + 1;
    const std::uint32_t traced = std::min(points, max_points / passes) * passes; // more is too much anyway
    return thousands(per_trimmed_point * layers_of(style) * traced);
}

std::uint32_t cost_of_dashes(std::uint32_t dashes) { return dashes * (per_dash / 1024); }

std::uint32_t cost_of_path(std::uint32_t segments) { return thousands(per_path_segment * segments); }

std::uint32_t cost_of_records(const SceneRecords& records, std::uint32_t keys, std::uint32_t borders)
{
    return thousands(per_timeline * records.timelines + per_track_with_new_keys * records.tracks +
                     per_bone * records.bones + per_border * borders) +
           thousands(std::min(keys, max_keys) * per_key_passed);
}

std::uint32_t cost_of_ordered(std::uint32_t items, std::uint32_t ordered)
{
    return thousands(per_order_looked_at * std::min(items, kfb::max_ordered_items) *
                     (std::min(ordered, kfb::max_ordered_items) + 1));
}

ItemTotals ItemTotals::of_leaf(const ObjectStyle& style)
{
    const std::uint32_t layers = layers_of(style);
    ItemTotals leaf;
    leaf.items = 1;
    leaf.paint_steps = static_cast<std::uint16_t>(layers);
    leaf.has_several_layers = layers > 1;
    return leaf;
}

ItemTotals ItemTotals::in_item() const
{
    ItemTotals item = *this;
    item.is_too_much = is_too_much || depth == kfb::max_depth || items == kfb::max_items;
    item.depth = static_cast<std::uint8_t>((depth + 1U) & 15U);
    ++item.items;
    return item;
}

void ItemTotals::place() { spaces = static_cast<std::uint8_t>((spaces + 1U) & 15U); }

void ItemTotals::blend()
{
    blended = static_cast<std::uint8_t>((blended + 1U) & 15U);
    is_too_much = is_too_much || paint_steps + 2U > kfb::max_paint_steps;
    paint_steps = static_cast<std::uint16_t>(paint_steps + 2);
}

void ItemTotals::add(const ItemTotals& item)
{
    has_several_layers = items != 0 || item.has_several_layers;
    is_too_much = is_too_much || item.is_too_much || std::uint32_t{items} + item.items > kfb::max_items ||
                  std::uint32_t{paint_steps} + item.paint_steps > kfb::max_paint_steps;
    items = static_cast<std::uint16_t>(items + item.items);
    paint_steps = static_cast<std::uint16_t>(paint_steps + item.paint_steps);
    depth = item.depth > depth ? item.depth : depth;
    blended = item.blended > blended ? item.blended : blended;
    spaces = item.spaces > spaces ? item.spaces : spaces;
}

}
