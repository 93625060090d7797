#include "host/art/prepare/prepare.hpp"

#include "host/art/budget.hpp"
#include "host/art/document/extent.hpp"

#include <algorithm>

namespace kfast::art {
namespace {

bool is_zero(const Channel& channel) { return greatest(channel) == 0; }

bool is_point(const scene::Outline& outline)
{
    const auto is_there = [&](scene::Vec2 spot) { return distance(spot, outline.from) < 1e-9; };
    return std::ranges::all_of(outline.curves, [&](const scene::Curve& curve) {
        return is_there(curve.to) && (!curve.cubic || (is_there(curve.c1) && is_there(curve.c2)));
    });
}

bool shows_dots(const Shape& shape) { return shape.stroke && shape.stroke->cap != Cap::butt; }

void drop_points(Shape& shape)
{
    auto& keys = shape.drawing.keys;
    const bool one_form =
        std::ranges::all_of(keys, [&](const auto& key) { return same_form(keys.front().value, key.value); });
    if (!one_form || shape.skin || shows_dots(shape))
        return;
    for (std::size_t i = keys.front().value.outlines.size(); i-- > 0;) {
        if (!std::ranges::all_of(keys, [&](const auto& key) { return is_point(key.value.outlines[i]); }))
            continue;
        for (auto& key : keys)
            key.value.outlines.erase(key.value.outlines.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

void drop_transparent(Shape& shape)
{
    if (shape.fill && is_zero(shape.fill->opacity))
        shape.fill.reset();
    if (shape.stroke && (is_zero(shape.stroke->opacity) || is_zero(shape.stroke->width)))
        shape.stroke.reset();
}

bool draws(const Shape& shape)
{
    return (shape.fill || shape.stroke) && std::ranges::any_of(shape.drawing.keys, [](const auto& key) {
               return !key.value.outlines.empty();
           });
}

class Unseen {
public:
    explicit Unseen(const std::vector<Symbol>& symbols) : symbols_{symbols} {}

    void drop(std::vector<Node>& nodes, int depth = 0) const
    {
        Budget::check_depth(depth);
        std::erase_if(nodes, [&](Node& node) { return !is_seen(node, depth); });
    }

private:
    bool is_seen(Node& node, int depth) const
    {
        if (node.shown.empty() || is_zero(node.opacity))
            return false;
        if (auto* shape = std::get_if<Shape>(&node.content)) {
            drop_transparent(*shape);
            drop_points(*shape);
            return draws(*shape);
        }
        if (const auto* use = std::get_if<Use>(&node.content))
            return !symbols_[use->symbol].nodes.empty();
        auto& inner = std::get<Group>(node.content).nodes;
        drop(inner, depth + 1);
        return !inner.empty();
    }

    const std::vector<Symbol>& symbols_;
};

}

void drop_unseen(Document& document)
{
    const Unseen unseen{document.symbols};
    for (Symbol& symbol : document.symbols)
        unseen.drop(symbol.nodes);
    unseen.drop(document.nodes);
}

}
