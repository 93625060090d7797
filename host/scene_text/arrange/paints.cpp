#include "host/scene_text/arrange/passes.hpp"

#include "host/scene_text/values/sums.hpp"
#include "host/scene_text/values/writing.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace kfast::scene_text {
namespace {

using art::Channel;
using art::Group;
using art::Node;
using art::Shape;

/// A key of an object has one law for both colours.
bool have_laws_in_common(const Shape& shape, std::int32_t length)
{
    const auto fills = paint_keys(*shape.fill, length);
    const auto lines = paint_keys(*shape.stroke, length);
    std::map<std::int32_t, std::string> laws;
    for (std::size_t i = 0; i + 1 < fills.size(); ++i)
        laws[fills[i].ticks] = fills[i].law;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i)
        if (const auto law = laws.find(lines[i].ticks); law != laws.end() && law->second != lines[i].law)
            return false;
    return true;
}

bool needs_two(const Shape& shape, std::int32_t length)
{
    return shape.fill && shape.stroke &&
           (!shape.fill->opacity.is_still() || !shape.stroke->opacity.is_still() ||
            !have_laws_in_common(shape, length));
}

/// A node that has the content alone.
Node part_of(Shape shape, const std::string& name)
{
    return {.name = name,
            .transform = {},
            .opacity = {1},
            .shown = std::vector{art::Span{}},
            .parent_tag = 0,
            .content = std::move(shape)};
}

void make_two(Node& node)
{
    Shape fill = std::get<Shape>(node.content);
    Shape stroke = fill;
    fill.stroke.reset();
    stroke.fill.reset();
    const std::string line_name = node.name.empty() ? std::string{} : node.name + "-line";
    std::vector<Node> parts;
    parts.push_back(part_of(std::move(fill), node.name));
    parts.push_back(part_of(std::move(stroke), line_name));
    node.content = Group{std::move(parts)};
}

/// The opacity of the only paint.
Channel& opacity_of(Shape& shape) { return shape.fill ? shape.fill->opacity : shape.stroke->opacity; }

void move_opacity(Node& node)
{
    const Channel opacity = std::exchange(opacity_of(std::get<Shape>(node.content)), Channel{1});
    if (has_product(node.opacity, opacity)) {
        node.opacity = product(node.opacity, opacity);
        return;
    }
    Node part = part_of(std::move(std::get<Shape>(node.content)), node.name);
    part.opacity = opacity;
    std::vector<Node> parts;
    parts.push_back(std::move(part));
    node.content = Group{std::move(parts)};
}

void part_paints_of(Node& node, std::int32_t length)
{
    if (auto* const shape = std::get_if<Shape>(&node.content); shape != nullptr) {
        if (needs_two(*shape, length))
            make_two(node);
        else if (!(shape->fill && shape->stroke) && !opacity_of(*shape).is_still())
            move_opacity(node);
    }
    if (auto* const group = std::get_if<Group>(&node.content))
        part_paints(group->nodes, length);
}

}

void part_paints(std::vector<Node>& nodes, std::int32_t length)
{
    for (Node& node : nodes)
        part_paints_of(node, length);
}

}
