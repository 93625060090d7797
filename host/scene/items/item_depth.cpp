#include "host/scene/items/item_depth.hpp"

#include <algorithm>
#include <variant>

namespace kfast::scene {
namespace {

int depth_of(const Item& item, const SymbolTable& symbols)
{
    if (const Group* const group = std::get_if<Group>(&item.content))
        return depth_of(group->items, symbols) + 1;
    if (const Use* const use = std::get_if<Use>(&item.content))
        return symbols.entries[use->symbol].depth + 1;
    return 0;
}

}

int depth_of(std::span<const Item> items, const SymbolTable& symbols)
{
    int depth = 0;
    for (const Item& item : items)
        depth = std::max(depth, depth_of(item, symbols));
    return depth;
}

}
