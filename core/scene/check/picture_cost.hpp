#pragma once

#include "core/scene/item_view.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace kfast {

/// The time of a scene, cut into at most 32 parts of the same length.
class SceneParts {
public:
    static constexpr std::uint32_t max = 32;
    static constexpr std::uint32_t all = 0xFFFF'FFFF;

    explicit SceneParts(Time length);

    /// A bit for each part in which something of [from, to) is.
    std::uint32_t between(Time from, Time to) const;

private:
    Time length_;
    int shift_ = 0; ///< a part has 2^shift_ ticks
};

/// The cost of the worst picture of a scene: a sum of what its items cost, for each part of its time, so that
/// items that are never seen together are not added up.
///
/// Costs are in thousands (1024) of instructions of a Cortex-M0, and on the whole lower than in fact.
class PictureCost {
public:
    /// The limit of sums; more than a Pico (RP2040, 125 MHz, some 1.7 cycles an instruction) does in nine
    /// tenths of a second.
    static constexpr std::uint32_t max = 0xFFFF;

    /// `parts` as returned by SceneParts.
    void add(std::uint32_t cost, std::uint32_t parts);
    /// The cost of the part in which it is highest.
    std::uint32_t largest() const;

private:
    std::uint32_t always_ = 0;
    std::array<std::uint16_t, SceneParts::max> in_part_{};
};

/// The cost of an item with `tracks` tracks, whether it is seen or not.
std::uint32_t cost_of_item(std::uint32_t tracks);
/// What it costs to trim a leaf of so many points and strokes.
std::uint32_t cost_of_trim(const ObjectStyle& style, std::uint32_t points, std::uint32_t strokes);
/// What the dashes of its stroke cost more.
std::uint32_t cost_of_dashes(std::uint32_t dashes);
/// The cost of drawing a leaf of `points` points, each of which takes `per_point` instructions, at most 1024,
/// more than others.
std::uint32_t cost_of_leaf(const ObjectStyle& style, std::uint32_t points, std::uint32_t per_point);
/// The cost of finding a position on a path of `segments` segments.
std::uint32_t cost_of_path(std::uint32_t segments);
/// The cost of moving the laid-out scene to a time, however far away, and of as many borders as
/// its pictures may have (SceneView::borders()). `keys` is how many its timelines have.
std::uint32_t cost_of_records(const SceneRecords& records, std::uint32_t keys, std::uint32_t borders);
/// The cost of searching the item with the lowest order in a list, again and again: `ordered` of
/// them have a track of it.
std::uint32_t cost_of_ordered(std::uint32_t items, std::uint32_t ordered);

/// The sums of items, those of a symbol counted wherever it is used.
struct ItemTotals {
    std::uint16_t items = 0;
    std::uint16_t paint_steps = 0;
    std::uint16_t cost = 0;       ///< of a symbol: PictureCost::most()
    std::uint8_t depth : 4 = 0;   ///< nested groups and uses
    std::uint8_t blended : 4 = 0; ///< nested ones that may be blended as a whole, including leaves
    std::uint8_t spaces : 4 = 0;  ///< nested ones that are placed, including leaves
    bool has_several_layers : 1 = false;
    bool is_too_much : 1 = false; ///< exceeds the format: then the numbers are not valid
    std::uint32_t shown = 0; ///< of a symbol: the parts in which it costs more than a thousand for each item

    static ItemTotals of_leaf(const ObjectStyle& style);
    /// The totals of an item that contains these.
    ItemTotals in_item() const;
    /// For the same item, which is placed, or may be blended as a whole.
    void place();
    void blend();
    /// Adds an item of the same list.
    void add(const ItemTotals& item);
};

}
