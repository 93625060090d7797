#include "host/art/prepare.hpp"
#include "host/scene/shape.hpp"
#include "tests/host/art/canvas_drawing.hpp"
#include "tests/host/art/drawn_distance.hpp"
#include "tests/host/art/random_document.hpp"
#include "tests/rounds.hpp"

#include <array>
#include <cmath>
#include <doctest/doctest.h>

namespace kfast::test {
namespace {

using art::Animated;
using art::Channel;
using art::Document;
using art::Drawing;
using art::Figure;
using art::Group;
using art::Key;
using art::Node;
using scene::Spot;

constexpr double tolerance = 1.0 / 32;

/// Random art whose channels have a key at every frame or so, most of which are of no use.
class CrowdedArt {
public:
    CrowdedArt(unsigned seed, bool depth) : random_{seed}, depth_{depth} {}

    Document document()
    {
        Document document;
        document.width = 240;
        document.height = 200;
        document.frames = 40;
        if (depth_)
            document.camera = 500;
        document.nodes.push_back(group(3));
        return document;
    }

private:
    Channel channel(double low, double high)
    {
        if (random_.chance(0.4))
            return random_.number(low, high);
        const double middle = (low + high) / 2;
        Channel channel = random_.channel(0, 40, (high - low) / 6);
        for (auto& key : channel.keys)
            key.value += middle;
        channel = random_.crowded(channel, 0);
        return random_.crowded(channel, random_.chance(0.5) ? 1e-5 * (high - low) : 0);
    }

    art::Transform transform()
    {
        art::Transform transform;
        transform.anchor_x = channel(-20, 20);
        transform.anchor_y = channel(-20, 20);
        transform.x = channel(-60, 60);
        transform.y = channel(-60, 60);
        transform.scale_x = channel(0.2, 2);
        transform.scale_y = channel(0.2, 2);
        transform.rotate = channel(-200, 200);
        if (random_.chance(0.2))
            transform.skew = random_.number(-30, 30);
        if (depth_) {
            transform.rotate_x = channel(-50, 50);
            transform.rotate_y = channel(-50, 50);
            transform.z = channel(-40, 40);
        }
        return transform;
    }

    Drawing drawing(Spot shift)
    {
        scene::Outline outline = scene::ellipse(Spot{30, 20} + shift, 40, 25);
        outline.curves[1].c2 = outline.curves[1].c2 + shift;
        return {{outline}};
    }

    Node figure()
    {
        Figure figure;
        std::vector<Key<Drawing>> keys;
        for (int i = 0; i < 30; ++i)
            keys.push_back({1.25 * i, drawing({10 * std::sin(0.15 * i), random_.number(0, 0.01)}), {}});
        if (random_.chance(0.5))
            keys.resize(1);
        figure.drawing = Animated<Drawing>{std::move(keys)};
        figure.fill.emplace();
        Node node;
        node.content = std::move(figure);
        return named(std::move(node));
    }

    Node group(int depth)
    {
        Group group;
        for (int i = random_.integer(1, 2); i > 0; --i)
            group.nodes.push_back(depth > 0 && random_.chance(0.7) ? this->group(depth - 1) : figure());
        Node node;
        node.content = std::move(group);
        return named(std::move(node));
    }

    Node named(Node node)
    {
        node.name = std::to_string(next_name_++);
        node.transform = transform();
        return node;
    }

    RandomArt random_;
    bool depth_;
    int next_name_ = 0;
};

std::size_t count_keys(const std::vector<Node>& nodes)
{
    std::size_t count = 0;
    for (const Node& node : nodes) {
        const auto& t = node.transform;
        for (const Channel* channel :
             {&t.anchor_x, &t.anchor_y, &t.x, &t.y, &t.scale_x, &t.scale_y, &t.rotate})
            count += channel->keys.size();
        if (const auto* group = std::get_if<Group>(&node.content))
            count += count_keys(group->nodes);
        else
            count += std::get<Figure>(node.content).drawing.keys.size();
    }
    return count;
}

/// Of control points: their number is the same, where nothing is merged.
double farthest_control(const Drawing& left, const Drawing& right)
{
    double most = 0;
    for (std::size_t i = 0; i < left.outlines.size(); ++i)
        for (std::size_t j = 0; j < left.outlines[i].curves.size(); ++j) {
            const auto& one = left.outlines[i].curves[j];
            const auto& other = right.outlines[i].curves[j];
            most = std::max(
                {most, distance(one.c1, other.c1), distance(one.c2, other.c2), distance(one.to, other.to)});
        }
    return most;
}

double worst(const Document& before, const Document& after, RandomArt& random, int times)
{
    double most = 0;
    for (int i = 0; i < times; ++i) {
        const double time = random.number(-1, 41);
        const CanvasDrawings left{before, time};
        const CanvasDrawings right{after, time};
        for (const auto& [name, drawing] : left.drawings())
            most = std::max(most, farthest_control(drawing, right.drawings().at(name)));
    }
    return most;
}

/// Where the edges of a line along a polygon meet outside of its corners.
std::vector<Spot> tips(const scene::Outline& outline, double half_width)
{
    std::vector<Spot> corners{outline.from};
    for (const scene::Curve& curve : outline.curves)
        corners.push_back(curve.to);
    std::vector<Spot> result;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Spot corner = corners[i];
        const auto towards = [&](Spot other) { return 1 / distance(corner, other) * (other - corner); };
        const Spot one = towards(corners[(i + 1) % corners.size()]);
        const Spot other = towards(corners[(i + corners.size() - 1) % corners.size()]);
        result.push_back(corner - half_width / std::abs(cross(one, other)) * (one + other));
    }
    return result;
}

Node of(Figure figure)
{
    Node node;
    node.content = std::move(figure);
    return node;
}

Figure filled(Animated<Drawing> drawing)
{
    Figure figure;
    figure.drawing = std::move(drawing);
    figure.fill.emplace();
    return figure;
}

Document with(Node node)
{
    Document document;
    document.width = document.height = 100;
    document.frames = 40;
    document.nodes.push_back(std::move(node));
    return document;
}

}

TEST_CASE("simplification moves nothing on the canvas by more than the tolerance")
{
    std::size_t before = 0;
    std::size_t after = 0;
    double most = 0;
    for (unsigned seed = 0; seed < static_cast<unsigned>(rounds(60)); ++seed) {
        const Document given = CrowdedArt{seed, false}.document();
        Document simple = given;
        art::simplify(simple, tolerance);
        RandomArt random{seed + 1000};
        most = std::max(most, worst(given, simple, random, 150));
        before += count_keys(given.nodes);
        after += count_keys(simple.nodes);
    }
    CHECK(most <= tolerance);
    CHECK(most > tolerance / 64);
    CHECK(after * 4 < before * 3);
}

TEST_CASE("simplification in space moves nothing by more than the tolerance")
{
    double most = 0;
    for (unsigned seed = 0; seed < static_cast<unsigned>(rounds(40)); ++seed) {
        const Document given = CrowdedArt{seed, true}.document();
        Document simple = given;
        art::simplify(simple, tolerance);
        RandomArt random{seed + 1000};
        most = std::max(most, worst(given, simple, random, 150));
    }
    CHECK(most <= tolerance);
    CHECK(most > 0);
}

TEST_CASE("what a group enlarges is simplified less")
{
    scene::Outline outline{{0, 0}, {}, true};
    for (const Spot to : {Spot{10, 0.02}, {20, 0}, {20, 20}})
        outline.curves.push_back(scene::line_to(to));
    for (const double factor : {1.0, 4.0}) {
        Node group;
        group.transform.scale_x = factor;
        group.content = Group{{of(filled(Drawing{{outline}}))}};
        Document document = with(std::move(group));
        art::simplify(document, tolerance);
        const Node& inner = std::get<Group>(document.nodes[0].content).nodes[0];
        const auto& curves = std::get<Figure>(inner.content).drawing.value().outlines[0].curves;
        CHECK(curves.size() == (factor > 1 ? 3 : 2));
    }
}

TEST_CASE("what several channels may be off adds up to no more than the tolerance")
{
    const double off = 0.6 * tolerance;
    const Channel bump{{{0, 0, {}}, {5, 5 + off, {}}, {10, 10, {}}}};
    Node outer;
    outer.transform.x = bump;
    outer.content = Group{{of(filled(Drawing{{scene::rectangle({0, 0}, 9, 9, 0)}}))}};
    Node& inner = std::get<Group>(outer.content).nodes[0];
    inner.name = "square";
    inner.transform.x = bump;
    const Document given = with(outer);
    Document simple = given;
    art::simplify(simple, tolerance);
    RandomArt random{1};
    CHECK(worst(given, simple, random, 200) <= tolerance);

    Document alone = with(of(filled(Drawing{{scene::rectangle({0, 0}, 9, 9, 0)}})));
    alone.nodes[0].transform.x = Channel{{{0, 0, {}}, {5, 5 + off / 2, {}}, {10, 10, {}}}};
    art::simplify(alone, tolerance);
    CHECK(alone.nodes[0].transform.x.keys.size() == 2);
}

TEST_CASE("what comes near to the viewer is simplified less")
{
    Node node = of(filled(Drawing{{scene::rectangle({0, 0}, 9, 9, 0)}}));
    node.name = "square";
    node.transform.x = Channel{{{0, 0, {}}, {5, 5 + tolerance / 3, {}}, {10, 10, {}}}};
    for (const double depth : {0.0, 80.0}) {
        Document document = with(node);
        document.camera = 100;
        document.nodes[0].transform.z = depth;
        art::simplify(document, tolerance);
        CHECK(document.nodes[0].transform.x.keys.size() == (depth > 0 ? 3 : 2));
    }
}

TEST_CASE("keys of drawings that are nearly equal are equal afterwards")
{
    const auto at = [](double x) { return Drawing{{scene::ellipse({x, 5}, 4, 4)}}; };
    Figure figure = filled(Animated<Drawing>{
        {{0, at(0), {}}, {5, at(20), {}}, {9, at(20.001), {}}, {12, at(20.0005), {}}, {20, at(0.001), {}}}});
    Document document = with(of(figure));
    art::simplify(document, tolerance);
    const auto& keys = std::get<Figure>(document.nodes[0].content).drawing.keys;
    REQUIRE(keys.size() == 4);
    CHECK(keys[1].value == keys[2].value);
    CHECK(keys[0].value == keys[3].value);
}

TEST_CASE("a wide line with miters lets its drawing move less")
{
    const auto at = [](double x, double y) {
        return Drawing{{scene::polyline(std::vector<Spot>{{0, 0}, {x, y}, {0, 9}}, true)}};
    };
    const Animated<Drawing> drawing{{{0, at(20, 4), {}}, {5, at(30, 4.005), {}}, {10, at(40, 4), {}}}};
    Figure line;
    line.drawing = drawing;
    line.line.emplace().width = 12;
    Document filled_only = with(of(filled(drawing)));
    Document lined = with(of(line));
    art::simplify(filled_only, tolerance);
    art::simplify(lined, tolerance);
    CHECK(std::get<Figure>(filled_only.nodes[0].content).drawing.keys.size() == 2);
    CHECK(std::get<Figure>(lined.nodes[0].content).drawing.keys.size() == 3);
}

TEST_CASE("a line that grows out of a point loses keys, for it keeps its direction")
{
    std::vector<Key<Drawing>> keys;
    for (int i = 0; i <= 20; ++i)
        keys.push_back(
            {2.0 * i, {{scene::polyline(std::vector<Spot>{{5, 5}, {5 + 3.0 * i, 5 + 2.0 * i}}, false)}}, {}});
    Figure figure;
    figure.drawing = Animated<Drawing>{keys};
    figure.line.emplace().width = 9;
    Document document = with(of(figure));
    art::simplify(document, tolerance);
    CHECK(std::get<Figure>(document.nodes[0].content).drawing.keys.size() == 2);
}

TEST_CASE("the tips of a line's corners move by no more than the tolerance")
{
    std::size_t kept = 0;
    double most = 0;
    for (unsigned seed = 0; seed < static_cast<unsigned>(rounds(60)); ++seed) {
        RandomArt random{seed};
        const double noise = random.number(0, 0.0003);
        std::vector<Key<Drawing>> keys;
        const std::array<Spot, 4> corners{Spot{0, 0}, {60, 5}, {50, 60}, {10, 40}};
        const Spot speed = random.spot(0.2);
        for (int i = 0; i <= 30; ++i) {
            std::vector<Spot> spots;
            for (const Spot corner : corners)
                spots.push_back(corner + i * (0.01 * corner.x * speed) + random.spot(noise));
            keys.push_back({1.0 * i, {{scene::polyline(spots, true)}}, {}});
        }
        Figure figure;
        figure.drawing = Animated<Drawing>{keys};
        figure.line.emplace().width = random.number(1, 20);
        Document simple = with(of(figure));
        art::simplify(simple, tolerance);
        const auto& after = std::get<Figure>(simple.nodes[0].content).drawing;
        kept += after.keys.size();
        for (int i = 0; i < 60; ++i) {
            const double time = random.number(0, 30);
            const double half_width = figure.line->width.value() / 2;
            const auto before = tips(figure.drawing.at(time).outlines[0], half_width);
            const auto now = tips(after.at(time).outlines[0], half_width);
            for (std::size_t corner = 0; corner < 4; ++corner)
                most = std::max(most, distance(before[corner], now[corner]));
        }
    }
    CHECK(most <= tolerance);
    CHECK(most > 0);
    CHECK(kept < static_cast<std::size_t>(rounds(60)) * 25);
}

TEST_CASE("between changes of form, keys and segments go")
{
    const auto line = [](std::vector<Spot> spots) { return Drawing{{scene::polyline(spots, false)}}; };
    const art::Ease hold{art::EaseKind::hold};
    const Animated<Drawing> drawing{{{0, line({{0, 0}, {10, 0}, {20, 0}}), {}},
                                     {5, line({{0, 0}, {10, 5}, {20, 10}}), {}},
                                     {10, line({{0, 0}, {10, 10}, {20, 20}}), hold},
                                     {12, line({{0, 0}, {20, 20}}), {}},
                                     {14, line({{0, 0}, {20, 20}}), {}},
                                     {16, line({{0, 0}, {20, 20}}), {}},
                                     {20, line({{0, 0}, {5, 20}, {30, 0}}), {}}}};
    Document document = with(of(filled(drawing)));
    art::simplify(document, tolerance);
    const auto& keys = std::get<Figure>(document.nodes[0].content).drawing.keys;
    REQUIRE(keys.size() == 5);
    CHECK(keys[0].value.outlines[0].curves.size() == 1);
    CHECK(keys[1].time == 10);
    CHECK(keys[1].ease == hold);
    CHECK(keys[2].time == 12);
    CHECK(keys[3].time == 16);
    CHECK(keys[4].value.outlines[0].curves.size() == 2);
}

TEST_CASE("neighbours of one parent keep the same transform")
{
    RandomArt random{7};
    Document document = with(Node{});
    document.nodes.clear();
    art::Transform transform;
    std::vector<Key<double>> keys;
    for (int i = 0; i <= 40; ++i)
        keys.push_back({1.0 * i, 30 * std::sin(0.1 * i), {}});
    transform.rotate = Channel{keys};
    for (const double size : {1.0, 90.0}) {
        Node node;
        node.parent_tag = 3;
        node.transform = transform;
        node.content = Group{{of(filled(Drawing{{scene::rectangle({0, 0}, size, size, 0)}}))}};
        document.nodes.push_back(std::move(node));
    }
    art::simplify(document, tolerance);
    CHECK(document.nodes[0].transform == document.nodes[1].transform);
    CHECK(document.nodes[0].transform.rotate.keys.size() < 41);
}

TEST_CASE("what is never seen is taken out")
{
    const Drawing square{{scene::rectangle({0, 0}, 9, 9, 0)}};
    const Drawing point{{scene::polyline(std::vector<Spot>{{5, 5}, {5, 5}}, true)}};
    Document document = with(of(filled(square)));
    Node hidden = of(filled(square));
    hidden.shown.clear();
    Node clear = of(filled(square));
    clear.opacity = 0;
    Node inkless = of(Figure{});
    Node empty;
    empty.content = Group{{hidden, clear, inkless}};
    Figure dot;
    dot.drawing = point;
    dot.line.emplace().cap = Cap::round;
    Figure no_dot = dot;
    no_dot.line->cap = Cap::butt;
    for (Node node : {hidden, clear, inkless, empty, of(filled(point)), of(dot), of(no_dot)})
        document.nodes.push_back(node);
    art::simplify(document, tolerance);
    REQUIRE(document.nodes.size() == 2);
    CHECK(std::get<Figure>(document.nodes[1].content).line.has_value());
}

TEST_CASE("without a tolerance only what is of no use goes")
{
    Document document = with(of(filled(Drawing{{scene::ellipse({5, 5}, 4, 4)}})));
    document.nodes[0].transform.x = Channel{{{0, 1, {}}, {5, 6, {}}, {10, 11, {}}, {20, 5, {}}}};
    document.nodes[0].transform.y = Channel{{{0, 1, {}}, {5, 1, {}}}};
    art::simplify(document, 0);
    CHECK(document.nodes[0].transform.x == Channel{{{0, 1, {}}, {10, 11, {}}, {20, 5, {}}}});
    CHECK(document.nodes[0].transform.y == Channel{1});
}

}
