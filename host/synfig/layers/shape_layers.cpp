#include "host/synfig/layers/shape_layers.hpp"

#include "host/geometry/shape.hpp"
#include "host/synfig/bones/linked_skin.hpp"
#include "host/synfig/layers/cover_layers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace kfast::synfig {
namespace {

using scene::Outline;

/// What a layer draws at a frame, in the units of the file.
using ShapeLaw = art::Drawing (*)(const Layer&, double, Vec2 origin);

bool is_nothing(Vec2 spot) { return std::abs(spot.x) < 1e-8 && std::abs(spot.y) < 1e-8; }

scene::Curve curve_between(const SplinePoint& from, const SplinePoint& to, Vec2 origin)
{
    const Vec2 end = origin + to.vertex;
    if (is_nothing(from.leaving()) && is_nothing(to.arriving))
        return scene::line_to(end);
    return scene::cubic_to(origin + from.vertex + 1.0 / 3 * from.leaving(), end - 1.0 / 3 * to.arriving, end);
}

art::Drawing region(const Layer& layer, double frame, Vec2 origin)
{
    const List points = layer.at("bline", frame).as<List>();
    if (points.entries.empty())
        return {};
    Outline outline = outline_along(points, origin);
    outline.closed = true;
    return {{std::move(outline)}};
}

art::Drawing circle(const Layer& layer, double frame, Vec2 origin)
{
    const double radius = std::abs(layer.number("radius", frame, 1));
    // This is clockwise once y points down.
    return {{art::Affine{1, 0, 0, -1, origin.x, origin.y}.of(scene::ellipse({}, radius, radius))}};
}

/// A corner that Synfig rounds by a parabola.
void add_corner(Outline& outline, Vec2 corner, Vec2 end)
{
    const Vec2 from = outline.curves.empty() ? outline.from : outline.curves.back().to;
    outline.curves.push_back(scene::quadratic_to(from, corner, end));
}

Outline bevelled(Vec2 low, Vec2 high, double x, double y)
{
    Outline outline{{low.x + x, high.y}, {}, true};
    outline.curves.push_back(scene::line_to({high.x - x, high.y}));
    add_corner(outline, high, {high.x, high.y - y});
    outline.curves.push_back(scene::line_to({high.x, low.y + y}));
    add_corner(outline, {high.x, low.y}, {high.x - x, low.y});
    outline.curves.push_back(scene::line_to({low.x + x, low.y}));
    add_corner(outline, low, {low.x, low.y + y});
    outline.curves.push_back(scene::line_to({low.x, high.y - y}));
    add_corner(outline, {low.x, high.y}, {low.x + x, high.y});
    return outline;
}

art::Drawing rectangle(const Layer& layer, double frame, Vec2)
{
    const Vec2 one = layer.spot("point1", frame);
    const Vec2 other = layer.spot("point2", frame, {1, 1});
    const double more = std::abs(layer.number("expand", frame, 0));
    const Vec2 low{std::min(one.x, other.x) - more, std::min(one.y, other.y) - more};
    const Vec2 high{std::max(one.x, other.x) + more, std::max(one.y, other.y) + more};
    const double share = std::min(1.0, std::abs(layer.number("bevel", frame, 0))) / 2;
    Vec2 bevel = share * (high - low);
    if (layer.truth("bevCircle", frame, true))
        bevel = {std::min(bevel.x, bevel.y), std::min(bevel.x, bevel.y)};
    if (layer.has("bevel") && !(layer.bends({"bevel"}).empty() && share == 0))
        return {{bevelled(low, high, bevel.x, bevel.y)}};
    const Vec2 corners[] = {{low.x, high.y}, high, {high.x, low.y}, low};
    return {{scene::polyline(corners, true)}};
}

art::Drawing polygon(const Layer& layer, double frame, Vec2 origin)
{
    std::vector<Vec2> spots;
    for (const Value& entry : layer.at("vector_list", frame).as<List>().entries)
        spots.push_back(origin + entry.as<Vec2>());
    if (spots.size() < 3)
        return {};
    return {{scene::polyline(spots, true)}};
}

art::Drawing star(const Layer& layer, double frame, Vec2 origin)
{
    constexpr int max_tips = 1000;
    const int tips = std::clamp(layer.whole("points", frame, 5), 2, max_tips);
    const double turn = layer.number("angle", frame, 90) * std::numbers::pi / 180;
    const bool regular = layer.truth("regular_polygon", frame, false);
    const double outer = layer.number("radius1", frame, 1);
    const double inner = layer.number("radius2", frame, 0.38);
    std::vector<Vec2> spots;
    for (int i = 0; i < 2 * tips; ++i) {
        const double angle = turn - i * std::numbers::pi / tips; // clockwise, as stars of scenes run
        const double radius = i % 2 == 0 ? outer : inner;
        if (i % 2 == 0 || !regular)
            spots.push_back(origin + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    return {{scene::polyline(spots, true)}};
}

art::Drawing checker_board(const Layer& layer, double frame, Vec2)
{
    constexpr double max_squares = 4096;
    const Reading& reading = layer.reading();
    const Vec2 origin = layer.spot("origin", frame, {0.125, 0.125});
    const Vec2 size = layer.spot("size", frame, {0.25, 0.25});
    const Vec2 cell{std::abs(size.x), std::abs(size.y)};
    const double across = reading.width / reading.pixels_per_unit;
    const double down = reading.height / reading.pixels_per_unit;
    if (!(cell.x > 0 && cell.y > 0 && (across / cell.x + 2) * (down / cell.y + 2) < max_squares))
        return {};
    const Vec2 corner{-reading.to_canvas.e / reading.pixels_per_unit,
                      reading.to_canvas.f / reading.pixels_per_unit - down};
    // From the origin, which may be far away, to the first square on the canvas.
    const Vec2 skipped{std::floor((corner.x - origin.x) / cell.x),
                       std::floor((corner.y - origin.y) / cell.y)};
    const int parity = std::fmod(skipped.x + skipped.y, 2) != 0 ? 1 : 0;
    const Vec2 first{origin.x + skipped.x * cell.x, origin.y + skipped.y * cell.y};
    art::Drawing drawing;
    for (int row = 0; first.y + row * cell.y < corner.y + down; ++row)
        for (int column = 0; first.x + column * cell.x < corner.x + across; ++column)
            if ((row + column + parity) % 2 != 0)
                drawing.outlines.push_back(
                    scene::rectangle({first.x + column * cell.x, first.y + row * cell.y}, cell.x, cell.y, 0));
    return drawing;
}

const std::map<std::string_view, ShapeLaw>& shape_laws()
{
    static const std::map<std::string_view, ShapeLaw> laws{{"region", region},
                                                           {"circle", circle},
                                                           {"rectangle", rectangle},
                                                           {"filled_rectangle", rectangle},
                                                           {"polygon", polygon},
                                                           {"star", star},
                                                           {"checker_board", checker_board}};
    return laws;
}

void lose_soft_edges(const Layer& layer)
{
    for (const char* name : {"feather", "feather_x", "feather_y"})
        if (layer.number(name, 0, 0) > 0 || !layer.bends({name}).empty())
            layer.lose("soft edge", "a sharp one");
}

}

Outline outline_along(const List& points, Vec2 origin)
{
    std::vector<SplinePoint> spline;
    for (const Value& entry : points.entries)
        spline.push_back(entry.as<SplinePoint>());
    Outline outline{origin + spline.front().vertex, {}, points.loop};
    for (std::size_t i = 1; i < spline.size(); ++i)
        outline.curves.push_back(curve_between(spline[i - 1], spline[i], origin));
    if (points.loop && spline.size() > 1)
        outline.curves.push_back(curve_between(spline.back(), spline.front(), origin));
    return outline;
}

art::Fill fill_of(const Layer& layer)
{
    const std::string_view name = colour_name(layer);
    art::Fill fill;
    const std::function<art::Rgb(double)> rgb = [&](double frame) {
        return layer.rgb(colour_at(layer, frame));
    };
    fill.colour = traced(rgb, layer.tracing({name}, colour_tolerance));
    const std::function<double(double)> opacity = [&](double frame) {
        return layer.has(name) ? std::clamp(colour_at(layer, frame).alpha, 0.0, 1.0) : 1.0;
    };
    fill.opacity = traced(opacity, layer.tracing({name}, opacity_tolerance));
    fill.rule = layer.number("winding_style", 0, 0) == 1 ? FillRule::even_odd : FillRule::nonzero;
    return fill;
}

art::Node node_of(const Layer& layer)
{
    art::Node node;
    node.name = layer.name();
    const std::function<double(double)> opacity = [&](double frame) {
        return std::clamp(layer.number("amount", frame, 1), 0.0, 1.0);
    };
    node.opacity = traced(opacity, layer.tracing({"amount"}, opacity_tolerance));
    return node;
}

bool moves_as_a_whole(const Layer& layer)
{
    const ValueNode* origin = layer.parameter("origin");
    return origin && origin->kind != "constant" && layer.type() != "checker_board";
}

void move_by_origin(art::Node& node, const Layer& layer)
{
    const art::Affine& to_canvas = layer.reading().to_canvas;
    const Vec2 zero = to_canvas.of(Vec2{});
    const std::function<double(double)> x = [&](double frame) {
        return to_canvas.of(layer.spot("origin", frame)).x;
    };
    const std::function<double(double)> y = [&](double frame) {
        return to_canvas.of(layer.spot("origin", frame)).y;
    };
    node.transform.anchor_x = zero.x;
    node.transform.anchor_y = zero.y;
    node.transform.x = traced(x, layer.tracing({"origin"}, place_tolerance));
    node.transform.y = traced(y, layer.tracing({"origin"}, place_tolerance));
}

std::optional<art::Node> read_shape_layer(const Layer& layer)
{
    const auto law = shape_laws().find(layer.type());
    if (law == shape_laws().end())
        return {};
    lose_soft_edges(layer);
    layer.lose_others({"bline",     "origin",          "radius",      "point1",        "point2",  "expand",
                       "bevel",     "bevCircle",       "vector_list", "points",        "angle",   "radius1",
                       "radius2",   "regular_polygon", "size",        "color",         "feather", "feather_x",
                       "feather_y", "blurtype",        "invert",      "winding_style", "falloff"});
    const bool inverted = layer.truth("invert", 0, false);
    art::Node node = node_of(layer);
    const bool moves = moves_as_a_whole(layer) && !inverted;
    if (moves)
        move_by_origin(node, layer);
    const std::function<art::Drawing(double)> drawing_at = [&](double frame) {
        art::Drawing drawing = law->second(layer, frame, moves ? Vec2{} : layer.spot("origin", frame));
        for (Outline& outline : drawing.outlines)
            outline = layer.reading().to_canvas.of(outline);
        if (inverted)
            drawing.outlines.insert(drawing.outlines.begin(), everywhere(layer.reading()));
        return drawing;
    };
    art::Shape shape;
    if (layer.type() == "region" && !inverted)
        shape.skin = linked_skin(layer);
    if (shape.skin)
        shape.drawing = drawing_at(0);
    else
        shape.drawing =
            traced(drawing_at, layer.tracing({"bline", moves ? "" : "origin", "radius", "point1", "point2",
                                              "expand", "bevel", "vector_list", "points", "angle", "radius1",
                                              "radius2", "regular_polygon", "size"},
                                             place_tolerance));
    shape.fill = fill_of(layer);
    if (inverted)
        shape.fill->rule = FillRule::even_odd;
    node.content = std::move(shape);
    return node;
}

}
