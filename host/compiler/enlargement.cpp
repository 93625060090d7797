#include "host/compiler/enlargement.hpp"

#include "host/compiler/scale_bound.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace kfast {
namespace {

/// Raises those of the symbols that `items` use, where `around` is that of what the items lie in.
void raise(std::vector<Enlargement>& symbols, const std::vector<scene::Item>& items,
           const Enlargement& around)
{
    for (const scene::Item& item : items) {
        if (const auto* group = std::get_if<scene::Group>(&item.content))
            raise(symbols, group->items, around.inside(item));
        else if (const auto* use = std::get_if<scene::Use>(&item.content))
            symbols[use->symbol].cover(around.inside(item));
    }
}

}

Enlargement Enlargement::unseen(const Extents& extents)
{
    return {extents, 0, {.nearest = -std::numeric_limits<double>::infinity()}};
}

Enlargement Enlargement::inside(const scene::Item& item) const
{
    return {*extents_, scale_ * scale_bound(item.tracks), depth_inside(depth_, item, *extents_)};
}

void Enlargement::cover(const Enlargement& other)
{
    scale_ = std::max(scale_, other.scale_);
    depth_.nearest = std::max(depth_.nearest, other.depth_.nearest);
    depth_.is_turned = depth_.is_turned || other.depth_.is_turned;
}

// A symbol uses only symbols before it: going backwards, all uses of a symbol come before itself.
std::vector<Enlargement> symbol_enlargements(const Extents& extents)
{
    const scene::Scene& scene = extents.scene();
    std::vector<Enlargement> symbols(scene.symbols.size(), Enlargement::unseen(extents));
    raise(symbols, scene.items, Enlargement::outermost(extents));
    for (std::size_t i = symbols.size(); i-- > 0;)
        raise(symbols, scene.symbols[i].items, Enlargement{symbols[i]});
    return symbols;
}

}
