#include "host/art/document/extent.hpp"
#include "host/scene_text/arrange/arrange.hpp"
#include "host/scene_text/arrange/passes.hpp"
#include "host/scene_text/arrange/placement.hpp"
#include "host/scene_text/values/sums.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace kfast::scene_text {
namespace {

using art::Node;

/// Visits the uses of symbols in nodes, with the factor by which what is around enlarges each.
template <typename Nodes, typename Visit>
void every_use(Nodes& nodes, double around, const Visit& visit)
{
    for (auto& node : nodes) {
        const double factor = around * art::scale_factor_of(node.transform);
        if (auto* const use = std::get_if<art::Use>(&node.content))
            visit(node, *use, factor * art::scale_factor_of(use->copies));
        else if (auto* const group = std::get_if<art::Group>(&node.content))
            every_use(group->nodes, factor, visit);
    }
}

/// Into a group that enlarges them.
void draw_larger(art::Symbol& symbol, double factor)
{
    Node group{.name = {},
               .transform = transform_of({0, 0, 0, factor, factor}),
               .opacity = {1},
               .shown = std::vector{art::Span{}},
               .parent_tag = 0,
               .content = art::Group{std::exchange(symbol.nodes, {})}};
    symbol.nodes.push_back(std::move(group));
}

/// The use of a symbol that is drawn larger.
void scale_down(Node& node, art::Use& use, double factor)
{
    art::Transform& transform = node.transform;
    transform.scale_x = scaled(transform.scale_x, 1 / factor);
    transform.scale_y = scaled(transform.scale_y, 1 / factor);
    transform.anchor_x = scaled(transform.anchor_x, factor);
    transform.anchor_y = scaled(transform.anchor_y, factor);
    use.copies.x *= factor;
    use.copies.y *= factor;
}

}

void draw_symbols_larger(art::Document& document)
{
    constexpr double coarse = 2; // from this factor on, the rounding to 1/16 px is visible
    constexpr double max = 16;
    std::vector<double> factors(document.symbols.size(), 0);
    const auto take = [&](const Node&, const art::Use& use, double factor) {
        factors[use.symbol] = std::clamp(factor, factors[use.symbol], max);
    };
    every_use(std::as_const(document.nodes), 1, take);
    for (std::size_t i = factors.size(); i-- > 0;)
        every_use(std::as_const(document.symbols[i].nodes), std::min(factors[i], coarse), take);
    for (double& factor : factors) // so that its inverse is stored exactly
        factor = std::exp2(std::ceil(std::log2(factor)));
    const auto change = [&factors](Node& node, art::Use& use, double) {
        if (factors[use.symbol] >= coarse)
            scale_down(node, use, factors[use.symbol]);
    };
    every_use(document.nodes, 1, change);
    for (art::Symbol& symbol : document.symbols)
        every_use(symbol.nodes, 1, change);
    for (std::size_t i = 0; i < factors.size(); ++i)
        if (factors[i] >= coarse)
            draw_larger(document.symbols[i], factors[i]);
}

void centre_uses(std::vector<Node>& nodes, const Arranging& arranging)
{
    constexpr double far = 256; // px: there a scale that is rounded to 1/4096 is off by 1/32 px
    every_use(nodes, 1, [&](Node& node, const art::Use& use, double) {
        art::Transform& transform = node.transform;
        const art::Extent& extent = arranging.symbols[use.symbol].extent;
        const bool only_moves = transform.scale_x == art::Channel{1} &&
                                transform.scale_y == art::Channel{1} && transform.rotate == art::Channel{0};
        if (use.copies.count > 1 || !is_still(transform) || only_moves || extent.empty())
            return;
        const scene::Vec2 middle{(extent.x.low + extent.x.high) / 2, (extent.y.low + extent.y.high) / 2};
        if (std::hypot(middle.x, middle.y) < far)
            return;
        const scene::Vec2 place = matrix_at(transform, 0).of(middle);
        transform.anchor_x = {middle.x};
        transform.anchor_y = {middle.y};
        transform.x = {place.x};
        transform.y = {place.y};
    });
}

}
