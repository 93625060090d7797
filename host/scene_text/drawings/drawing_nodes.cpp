#include "host/scene_text/drawings/drawing_nodes.hpp"

#include "host/art/geometry/shape_form.hpp"
#include "host/kdl/readable.hpp"
#include "host/scene_text/drawings/stored_drawings.hpp"
#include "host/scene_text/values/grid.hpp"
#include "host/scene_text/values/nodes.hpp"
#include "host/scene_text/values/writing.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace kfast::scene_text {

namespace {

using art::ShapeForm;

/// For the numbers of shapes: more are never needed.
constexpr int max_decimals = 5;

/// A number that has few decimals already.
kdl::Value plain(double value)
{
    std::array<char, 40> digits;
    for (int decimals = 0; decimals <= max_decimals; ++decimals) {
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                       std::chars_format::fixed, decimals);
        double read = 0;
        std::from_chars(digits.data(), end.ptr, read);
        if (std::abs(read - value) > 1e-9 && decimals < max_decimals)
            continue;
        kdl::Value number;
        number.data = kdl::Number{read == 0 ? "0" : std::string{digits.data(), end.ptr}, read};
        return number;
    }
    return {};
}

kdl::Value coordinate(double value) { return number(on_grid(value, coordinates), coordinates); }

kdl::Node with_spots(std::string_view name, const std::vector<scene::Vec2>& spots)
{
    kdl::Node node = named_node(name);
    for (const scene::Vec2 spot : spots) {
        node.arguments.push_back(coordinate(spot.x));
        node.arguments.push_back(coordinate(spot.y));
    }
    return node;
}

struct FormNode {
    const scene::Outline& outline;

    kdl::Node operator()(const art::PathForm&) const { return named_node("path", text(path_data(outline))); }
    kdl::Node operator()(const art::CircleForm& circle) const
    {
        kdl::Node node = named_node("circle", plain(circle.centre.x), plain(circle.centre.y));
        set(node, "r", plain(circle.radius));
        return node;
    }
    kdl::Node operator()(const art::EllipseForm& ellipse) const
    {
        kdl::Node node = named_node("ellipse", plain(ellipse.centre.x), plain(ellipse.centre.y));
        set(node, "rx", plain(ellipse.radius_x));
        set(node, "ry", plain(ellipse.radius_y));
        return node;
    }
    kdl::Node operator()(const art::RectForm& rect) const
    {
        kdl::Node node = named_node("rect", plain(rect.upper_left.x), plain(rect.upper_left.y),
                                    plain(rect.width), plain(rect.height));
        if (rect.corner != 0)
            set(node, "corner", plain(rect.corner));
        return node;
    }
    kdl::Node operator()(const art::PolygonForm& polygon) const
    {
        return with_spots("polygon", polygon.spots);
    }
    kdl::Node operator()(const art::LineForm& line) const { return with_spots("line", line.spots); }
};

bool is_long(const art::ShapeForm& form)
{
    constexpr std::size_t max_spots = 12;
    if (const auto* const polygon = std::get_if<art::PolygonForm>(&form))
        return polygon->spots.size() > max_spots;
    const auto* const line = std::get_if<art::LineForm>(&form);
    return line != nullptr && line->spots.size() > max_spots;
}

/// Lists of many points are easier to read in the lines of a path.
ShapeForm form_of(const scene::Outline& outline)
{
    ShapeForm form = art::shape_form(outline);
    return is_long(form) ? ShapeForm{} : form;
}

using Forms = std::vector<ShapeForm>;

/// A rectangle with sharp corners is a polygon, too.
bool is_sharp(const ShapeForm& form)
{
    const auto* const rect = std::get_if<art::RectForm>(&form);
    return std::holds_alternative<art::PolygonForm>(form) || (rect != nullptr && rect->corner == 0);
}

ShapeForm polygon_of(const scene::Outline& outline)
{
    art::PolygonForm polygon{{outline.from}};
    for (const scene::Curve& curve : outline.curves)
        polygon.spots.push_back(curve.to);
    if (polygon.spots.back().x == outline.from.x && polygon.spots.back().y == outline.from.y)
        polygon.spots.pop_back();
    return polygon;
}

/// Where drawings have different kinds at one position, all have polygons there, or else paths.
void agree(std::vector<Forms>& forms, std::span<const art::Drawing* const> drawings)
{
    std::size_t places = 0;
    for (const Forms& own : forms)
        places = std::max(places, own.size());
    for (std::size_t i = 0; i < places; ++i) {
        std::set<std::size_t> kinds;
        bool all_sharp = true;
        for (const Forms& own : forms)
            if (i < own.size()) {
                kinds.insert(own[i].index());
                all_sharp = all_sharp && is_sharp(own[i]);
            }
        for (std::size_t drawing = 0; kinds.size() > 1 && drawing < forms.size(); ++drawing)
            if (i < forms[drawing].size())
                forms[drawing][i] =
                    all_sharp ? polygon_of(drawings[drawing]->outlines[i]) : ShapeForm{art::PathForm{}};
    }
}

std::vector<kdl::Node> nodes_of(const art::Drawing& drawing, const Forms& forms)
{
    std::vector<kdl::Node> nodes;
    for (std::size_t i = 0; i < forms.size(); ++i)
        nodes.push_back(std::visit(FormNode{drawing.outlines[i]}, forms[i]));
    if (nodes.empty())
        nodes.push_back(named_node("empty"));
    return nodes;
}

}

std::vector<std::vector<kdl::Node>> shapes_of(std::span<const art::Drawing* const> drawings)
{
    std::vector<Forms> forms;
    for (const art::Drawing* drawing : drawings) {
        Forms& own = forms.emplace_back();
        for (const scene::Outline& outline : drawing->outlines)
            own.push_back(form_of(outline));
    }
    agree(forms, drawings);
    std::vector<std::vector<kdl::Node>> shapes;
    for (std::size_t i = 0; i < forms.size(); ++i)
        shapes.push_back(nodes_of(*drawings[i], forms[i]));
    return shapes;
}

namespace {

/// Shorter ones are repeated.
constexpr std::size_t shortest = 60;

/// A drawing that is in keys.
struct Shared {
    std::string user; ///< the first object that has it
    std::vector<kdl::Node*> keys;
};

class Drawings {
public:
    void collect(std::vector<kdl::Node>& items)
    {
        for (kdl::Node& item : items)
            if (item.name == "object")
                collect_keys(item);
            else
                collect(item.children);
    }

    std::vector<kdl::Node> share(Names& names)
    {
        std::vector<kdl::Node> symbols;
        for (const std::string* text : order_) {
            const Shared& shared = drawings_.at(*text);
            if (shared.keys.size() < 2)
                continue;
            const std::string name = names.unique(shared.user + "-drawing", "drawing");
            kdl::Node symbol = named_node("symbol", scene_text::text(name));
            symbol.children = std::move(shared.keys.front()->children);
            symbols.push_back(std::move(symbol));
            for (kdl::Node* key : shared.keys)
                key->children = {named_node("use", scene_text::text(name))};
        }
        return symbols;
    }

private:
    void collect_keys(kdl::Node& object)
    {
        for (kdl::Node& key : object.children) {
            if (key.name != "key" || key.children.empty())
                continue;
            const std::string drawing = kdl::readable(key.children, {});
            if (drawing.size() < shortest)
                continue;
            const auto [entry, is_new] = drawings_.try_emplace(drawing);
            if (is_new) {
                entry->second.user = *object.arguments.front().string();
                order_.push_back(&entry->first);
            }
            entry->second.keys.push_back(&key);
        }
    }

    std::map<std::string, Shared> drawings_ = {};
    std::vector<const std::string*> order_ = {}; ///< in the order of the text
};

}

std::vector<kdl::Node> share_drawings(std::vector<kdl::Node>& symbols, std::vector<kdl::Node>& items,
                                      Names& names)
{
    Drawings drawings;
    drawings.collect(symbols);
    drawings.collect(items);
    return drawings.share(names);
}

}
