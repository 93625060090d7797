#include "host/scene/shapes/wire_reader.hpp"

#include "host/scene/shapes/mesh_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/node_schema.hpp"
#include "host/schema/property_rule.hpp"

#include <algorithm>
#include <array>

namespace kfast::scene {
namespace {

bool read_closed(const kdl::Value& value, bool& closed, SceneContext& context)
{
    return assign(read_flag(value, context.report), closed);
}

constexpr std::array polyline_rules{PropertyRule<bool>{"closed", read_closed, truth}};

std::vector<Wire> read_polyline(const kdl::Node& node, SceneContext& context)
{
    bool closed = false;
    const bool good = read_properties(node, polyline_rules, closed, context);
    auto wire = read_space_spots(node, context);
    if (!good || !wire)
        return {};
    if (closed)
        wire->push_back(wire->front());
    return {*wire};
}

std::vector<Wire> read_edges(const kdl::Node& node, SceneContext& context)
{
    const bool good = refuse_properties(node, context.report);
    const auto mesh = read_mesh(node, context);
    return good && mesh ? wires_of(*mesh) : std::vector<Wire>{};
}

std::vector<Wire> read_cuboid(const kdl::Node& node, SceneContext& context)
{
    const bool good = refuse_properties(node, context.report);
    const auto box = read_numbers(node.arguments, std::array{coordinates, coordinates, coordinates, extents},
                                  context.report);
    if (!good || !box)
        return {};
    return wires_of(cuboid({box->at(0), box->at(1), box->at(2)}, box->at(3), box->at(4), box->at(5)));
}

struct WireShape {
    NodeForm form;
    std::vector<Wire> (*read)(const kdl::Node&, SceneContext&);
    std::span<const ValueKind> values;
};

constexpr ValueKind coordinate = ValueKind::pixels(coordinates);
constexpr std::array spot_values{coordinate};
constexpr std::array box_values{coordinate, coordinate, coordinate, ValueKind::pixels(extents)};

constexpr std::array shapes{
    WireShape{
        {"wire", "wire X Y Z X Y Z … closed=#true", 6, NodeForm::any_number}, read_polyline, spot_values},
    WireShape{{"mesh", "mesh { vertices X Y Z X Y Z …; edges A B … }", 0, 0, true}, read_edges, {}},
    WireShape{{"cuboid", "cuboid X Y Z WIDTH HEIGHT DEPTH", 6, 6}, read_cuboid, box_values},
};

constexpr auto names = [] {
    std::array<std::string_view, shapes.size()> list;
    std::ranges::transform(shapes, list.begin(), [](const WireShape& shape) { return shape.form.name; });
    return list;
}();

}

std::span<const std::string_view> wire_names() { return names; }

bool is_wire(std::string_view name) { return std::ranges::find(names, name) != names.end(); }

std::vector<Wire> read_wires(const kdl::Node& node, SceneContext& context)
{
    const auto index = std::ranges::find(names, node.name) - names.begin();
    const WireShape& shape = shapes[static_cast<std::size_t>(index)];
    if (!fits(node, shape.form, context.report))
        return {};
    return shape.read(node, context);
}

std::vector<NodeSchema> wire_words()
{
    std::vector<NodeSchema> words;
    for (const WireShape& shape : shapes) {
        NodeSchema own{shape.form.name, shape.form, {shape.values.begin(), shape.values.end()}};
        if (shape.read == read_polyline)
            own.properties = words_of(polyline_rules);
        if (shape.form.takes_nodes)
            own.inside = names_inside_mesh();
        words.push_back(std::move(own));
    }
    return words;
}

}
