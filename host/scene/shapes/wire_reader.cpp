#include "host/scene/shapes/wire_reader.hpp"

#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace kfast::scene {

namespace {

constexpr NodeForm vertices_form{"vertices", "vertices X Y Z X Y Z …", 3, NodeForm::any_number};
constexpr NodeForm edges_form{"edges", "edges A B  C D …", 2, NodeForm::any_number};
constexpr NodeForm face_form{"face", "face A B C …", 3, NodeForm::any_number};
constexpr std::array<std::string_view, 3> names_inside{vertices_form.name, edges_form.name, face_form.name};
constexpr Range whole_numbers{1, 1'000'000'000};

class MeshReader {
public:
    MeshReader(const kdl::Node& node, SceneContext& context) : node_{node}, context_{context} {}

    std::optional<Mesh> read()
    {
        read_vertices(); // which may follow the edges
        if (is_good_ && mesh_.vertices.empty())
            fail(node_.name_span, "this mesh has no vertices", "write vertices X Y Z X Y Z … into it");
        for (const kdl::Node& node : node_.children)
            if (is_good_ && node.name != vertices_form.name)
                read_edges(node);
        if (is_good_ && mesh_.edges.empty())
            fail(node_.name_span, "this mesh has no edges", "write edges A B … or face A B C … into it");
        if (!is_good_)
            return std::nullopt;
        warn_of_loose_vertex();
        return std::move(mesh_);
    }

private:
    void fail(SourceSpan place, std::string message, std::string hint)
    {
        is_good_ = context_.report.error(place, std::move(message), std::move(hint));
    }

    bool has_form(const kdl::Node& node, const NodeForm& form)
    {
        const bool good = fits(node, form, context_.report) && refuse_properties(node, context_.report);
        is_good_ = is_good_ && good;
        return good;
    }

    void read_vertices()
    {
        for (const kdl::Node& node : node_.children) {
            if (node.name != vertices_form.name || !has_form(node, vertices_form))
                continue;
            const auto spots = read_space_spots(node, context_);
            is_good_ = is_good_ && spots.has_value();
            if (!spots)
                continue;
            mesh_.vertices.insert(mesh_.vertices.end(), spots->begin(), spots->end());
            for (std::size_t i = 0; i < spots->size(); ++i)
                places_.push_back(span(node.arguments[3 * i].place, node.arguments[3 * i + 2].place));
        }
    }

    void read_edges(const kdl::Node& node)
    {
        if (node.name == edges_form.name)
            read_pairs(node);
        else if (node.name == face_form.name)
            read_face(node);
        else
            fail(node.name_span, "a mesh has no node " + in_quotes(node.name),
                 word_hint(node.name, names_inside));
    }

    void read_pairs(const kdl::Node& node)
    {
        if (!has_form(node, edges_form))
            return;
        const auto& ends = node.arguments;
        if (ends.size() % 2 != 0)
            return fail(ends.back().place, "this edge has no other end",
                        "add the vertex that it leads to, or remove this one");
        for (std::size_t i = 0; i < ends.size(); i += 2)
            add_edge(ends[i], ends[i + 1]);
    }

    void read_face(const kdl::Node& node)
    {
        if (!has_form(node, face_form))
            return;
        const auto& corners = node.arguments;
        for (std::size_t i = 0; i < corners.size(); ++i)
            add_edge(corners[i], corners[(i + 1) % corners.size()]);
    }

    void add_edge(const kdl::Value& from, const kdl::Value& to)
    {
        const auto a = is_good_ ? read_vertex(from) : std::nullopt;
        const auto b = a ? read_vertex(to) : std::nullopt;
        if (!b)
            return;
        if (*a == *b)
            return fail(to.place, "this edge leads from a vertex to itself",
                        "name another vertex, or remove the edge");
        mesh_.edges.push_back({*a, *b});
    }

    std::optional<std::size_t> read_vertex(const kdl::Value& value)
    {
        const auto number = read_whole_number(value, whole_numbers, context_.report);
        is_good_ = is_good_ && number.has_value();
        if (!number)
            return std::nullopt;
        const auto vertex = static_cast<std::size_t>(*number);
        if (vertex <= mesh_.vertices.size())
            return vertex - 1;
        fail(value.place, "there is no vertex " + std::to_string(vertex),
             "this mesh has " + std::to_string(mesh_.vertices.size()) +
                 (mesh_.vertices.size() == 1 ? " vertex" : " vertices") + ", counted from 1");
        return std::nullopt;
    }

    void warn_of_loose_vertex()
    {
        std::vector<bool> is_used(mesh_.vertices.size());
        for (const Edge& edge : mesh_.edges)
            is_used[edge.from] = is_used[edge.to] = true;
        const auto loose = std::ranges::find(is_used, false);
        if (loose == is_used.end())
            return;
        const auto vertex = static_cast<std::size_t>(loose - is_used.begin());
        context_.report.warning(
            places_[vertex], "no edge leads to vertex " + std::to_string(vertex + 1) + ", which is not seen",
            "add an edge, or remove the vertex");
    }

    const kdl::Node& node_;
    SceneContext& context_;
    Mesh mesh_;
    std::vector<SourceSpan> places_; ///< of the vertices
    bool is_good_ = true;
};

}

std::optional<std::vector<Vec3>> read_space_spots(const kdl::Node& node, SceneContext& context)
{
    const auto numbers = read_numbers(node.arguments, std::array{coordinates}, context.report);
    if (!numbers)
        return std::nullopt;
    if (const std::size_t rest = numbers->size() % 3; rest != 0) {
        context.report.error(node.arguments[numbers->size() - rest].place,
                             rest == 1 ? "this x has no y and no z" : "this x and y have no z",
                             "every point has three numbers, X Y Z: add what is missing, or remove this");
        return std::nullopt;
    }
    std::vector<Vec3> spots;
    for (std::size_t i = 0; i < numbers->size(); i += 3)
        spots.push_back({(*numbers)[i], (*numbers)[i + 1], (*numbers)[i + 2]});
    return spots;
}

std::optional<Mesh> read_mesh(const kdl::Node& node, SceneContext& context)
{
    return MeshReader{node, context}.read();
}

std::vector<std::string_view> names_inside_mesh() { return {names_inside.begin(), names_inside.end()}; }

std::vector<NodeSchema> mesh_schema()
{
    const ValueKind coordinate = ValueKind::pixels(coordinates);
    const ValueKind vertex = ValueKind::whole(whole_numbers);
    return {{vertices_form.name, vertices_form, {coordinate}},
            {edges_form.name, edges_form, {vertex}},
            {face_form.name, face_form, {vertex}}};
}

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

std::vector<NodeSchema> wire_schema()
{
    std::vector<NodeSchema> words;
    for (const WireShape& shape : shapes) {
        NodeSchema own{shape.form.name, shape.form, {shape.values.begin(), shape.values.end()}};
        if (shape.read == read_polyline)
            own.properties = schema_of(polyline_rules);
        if (shape.form.takes_nodes)
            own.inside = names_inside_mesh();
        words.push_back(std::move(own));
    }
    return words;
}

}
