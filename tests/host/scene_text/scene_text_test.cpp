#include "tests/host/scene_text/written.hpp"

#include <iostream>

namespace kfast::test {
namespace {

using art::Ease;
using art::EaseKind;
using art::Figure;
using art::Group;
using art::Node;

art::Drawing box(double x, double y, double width, double height)
{
    return {{{{x, y},
              {scene::line_to({x + width, y}), scene::line_to({x + width, y + height}),
               scene::line_to({x, y + height}), scene::line_to({x, y})},
              true}}};
}

Figure filled(art::Drawing drawing, art::Rgb colour)
{
    Figure figure;
    figure.drawing = {std::move(drawing)};
    figure.fill = art::Fill{{colour}, {1}, FillRule::nonzero};
    return figure;
}

Node node(std::string name, std::variant<Figure, Group> content)
{
    Node result;
    result.name = std::move(name);
    result.content = std::move(content);
    return result;
}

art::Document document(std::vector<Node> nodes)
{
    art::Document result;
    result.width = 100;
    result.height = 80;
    result.frames = 60;
    result.nodes = std::move(nodes);
    return result;
}

}

TEST_CASE("a figure becomes an object")
{
    std::cout << written(document({node("box", filled(box(10, 10, 20, 20), {1, 0.5, 0}))}));
}

TEST_CASE("a group with tracks")
{
    Node body = node("body", filled(box(10, 10, 20, 20), {1, 0.5, 0}));
    body.content = filled(box(10, 10, 20, 20), {1, 0.5, 0});
    auto& figure = std::get<Figure>(body.content);
    figure.line = art::Line{};
    figure.line->width = {3};
    figure.drawing = art::Animated<art::Drawing>{
        {{0, box(10, 10, 20, 20), {EaseKind::cubic, 0.4, 0, 0.2, 1}}, {20, box(10, 10, 40, 20), {}}}};
    figure.fill->colour =
        art::Animated<art::Rgb>{{{0, {1, 0.5, 0}, {}}, {20, {0, 0.5, 1}, {}}, {50, {}, {}}}};
    body.transform.rotate =
        art::Channel{{{0, 0, {}}, {30, 90, {EaseKind::cubic, 0.42, 0, 0.58, 1}}, {60, 0, {}}}};
    body.transform.anchor_x = {20};
    body.transform.x = {20};
    body.shown = {{5, 40}};
    Node group = node("all of it", Group{{body, node("body", filled(box(1.03, 2, 3, 4), {1, 1, 1}))}});
    group.transform.x = art::Channel{{{0, 0, {}}, {30, 9, {}}}};
    art::Document made = document({group});
    made.markers = {{"go", 5, 0}, {"walk", 10, 20}};
    std::cout << written(made);
}

}
