#pragma once

#include "core/item_view.hpp"
#include "core/moment.hpp"

#include <cstdint>
#include <limits>
#include <optional>

namespace kfast {

/// Whether one of `items` has a track of Property::order.
bool any_has_order(ItemCursor items);

/// Items that lie beside each other, in the order in which they are painted at one moment: by
/// Property::order, and of equals the first first.
///
/// Items without such tracks are read once, others once more for each different order that they have at the
/// moment: no memory is needed, and at most kfb::max_ordered_items lie beside
/// each other then.
class PaintOrder {
public:
    PaintOrder(ItemCursor items, const Moment& moment);

    /// Nothing after the last item.
    std::optional<ItemView> next();

private:
    std::optional<ItemView> next_by_order();

    static constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();

    ItemCursor all_;
    ItemCursor rest_;
    Moment moment_;
    bool is_ordered_ = false;
    std::int32_t order_ = std::numeric_limits<std::int32_t>::min(); ///< of the items that are painted now
    std::int32_t next_order_ = none;                                ///< the lowest above it, of those passed
};

}
