#include "core/paint_order.hpp"

#include "core/item_state.hpp"

#include <algorithm>
#include <utility>

namespace kfast {
namespace {

bool has_order(const ItemView& item)
{
    for (TrackCursor tracks = item.tracks; !tracks.at_end();)
        if (tracks.next().property == Property::order)
            return true;
    return false;
}

}

bool any_has_order(ItemCursor items)
{
    while (!items.at_end())
        if (has_order(items.next()))
            return true;
    return false;
}

PaintOrder::PaintOrder(ItemCursor items, const Moment& moment)
    : all_{items}, rest_{items}, moment_{moment}, is_ordered_{any_has_order(items)}
{
}

std::optional<ItemView> PaintOrder::next()
{
    if (is_ordered_)
        return next_by_order();
    if (rest_.at_end())
        return std::nullopt;
    return rest_.next();
}

std::optional<ItemView> PaintOrder::next_by_order()
{
    for (;;) {
        while (!rest_.at_end()) {
            const ItemView item = rest_.next();
            const std::int32_t order = order_at(item, moment_);
            if (order == order_)
                return item;
            if (order > order_)
                next_order_ = std::min(next_order_, order);
        }
        if (next_order_ == none)
            return std::nullopt;
        order_ = std::exchange(next_order_, none);
        rest_ = all_;
    }
}

}
