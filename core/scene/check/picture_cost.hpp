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

    /// A bit for each part that something of [from, to) lies in.
    std::uint32_t between(Time from, Time to) const;

private:
    Time length_;
    int shift_ = 0; ///< a part has 2^shift_ ticks
};

/// What the worst picture of a scene takes: a sum of what its items take, for each part of its time, so that
/// items that are never seen together are not added up.
///
/// Costs are in thousands (1024) of instructions of a Cortex-M0, and on the whole lower than they are.
class PictureCost {
public:
    /// Where sums end; more than a Pico (RP2040, 125 MHz, some 1.7 cycles an instruction) does in nine
    /// tenths of a second.
    static constexpr std::uint32_t max = 0xFFFF;

    /// `parts` as of SceneParts.
    void add(std::uint32_t cost, std::uint32_t parts);
    /// Of the part in which it is most.
    std::uint32_t largest() const;

private:
    std::uint32_t always_ = 0;
    std::array<std::uint16_t, SceneParts::max> in_part_{};
};

/// The cost of an item with so many tracks, whether it is seen or not.
std::uint32_t cost_of_item(std::uint32_t tracks);
/// The cost of drawing a leaf of so many points, each of which takes `per_point` instructions, at most 1024,
/// more than others.
std::uint32_t cost_of_leaf(const ObjectStyle& style, std::uint32_t points, std::uint32_t per_point);
/// The cost of finding a place on a path of so many segments.
std::uint32_t cost_of_path(std::uint32_t segments);
/// The cost of moving what is laid out of a scene to a moment, however far away, and of as many borders as
/// its pictures may have (SceneView::borders()). `keys` is how many its timelines have.
std::uint32_t cost_of_records(const SceneRecords& records, std::uint32_t keys, std::uint32_t borders);
/// Of looking for the item with the lowest order among items beside each other, again and again: `ordered` of
/// them have a track of it.
std::uint32_t cost_of_ordered(std::uint32_t items, std::uint32_t ordered);

/// What items take together, those of a symbol counted wherever it is used.
struct ItemTotals {
    std::uint16_t items = 0;
    std::uint16_t paint_steps = 0;
    std::uint16_t cost = 0;       ///< of a symbol: PictureCost::most()
    std::uint8_t depth : 4 = 0;   ///< groups and uses in each other
    std::uint8_t blended : 4 = 0; ///< those in each other that may be blended as a whole, leaves too
    std::uint8_t spaces : 4 = 0;  ///< those in each other that are placed, leaves too
    bool has_several_layers : 1 = false;
    bool is_too_much : 1 = false; ///< for the format: then figures are not to be relied on
    std::uint32_t shown = 0; ///< of a symbol: the parts in which it takes more than a thousand for each item

    static ItemTotals of_leaf(const ObjectStyle& style);
    /// Of an item inside of which there are these.
    ItemTotals in_item() const;
    /// Of the same item, which is placed, or may be blended as a whole.
    void place();
    void blend();
    /// With an item beside those before.
    void add(const ItemTotals& item);
};

}
