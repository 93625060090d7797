#include "host/compiler/scale_bound.hpp"

#include "host/compiler/track_peak.hpp"

#include <algorithm>
#include <cstddef>

namespace kfast {
namespace {

/// Raises the bounds of the symbols that `items` use, where `items` are enlarged by `scale`.
void raise(std::vector<double>& symbols, const std::vector<scene::Item>& items, double scale)
{
    for (const scene::Item& item : items) {
        const double inside = scale * scale_bound(item.tracks);
        if (const auto* group = std::get_if<scene::Group>(&item.content))
            raise(symbols, group->items, inside);
        else if (const auto* use = std::get_if<scene::Use>(&item.content))
            symbols[use->symbol] = std::max(symbols[use->symbol], inside);
    }
}

}

double scale_bound(const std::vector<scene::Track>& tracks)
{
    return std::max(track_peak(tracks, Property::scale_x, scale_one),
                    track_peak(tracks, Property::scale_y, scale_one)) /
           scale_one;
}

// A symbol uses only symbols before it: going backwards, all uses of a symbol come before itself.
std::vector<double> symbol_scale_bounds(const scene::Scene& scene)
{
    std::vector<double> bounds(scene.symbols.size(), 0);
    raise(bounds, scene.items, 1);
    for (std::size_t i = bounds.size(); i-- > 0;)
        raise(bounds, scene.symbols[i].items, bounds[i]);
    return bounds;
}

}
