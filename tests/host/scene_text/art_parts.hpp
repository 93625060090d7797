#pragma once

#include "host/art/document/document.hpp"

#include <string>
#include <utility>
#include <variant>
#include <vector>

/// Small pieces of documents.
namespace kfast::test {

inline art::Drawing box(double x, double y, double width, double height)
{
    return {{{{x, y},
              {scene::line_to({x + width, y}), scene::line_to({x + width, y + height}),
               scene::line_to({x, y + height}), scene::line_to({x, y})},
              true}}};
}

inline art::Shape filled(art::Animated<art::Drawing> drawing,
                         art::Animated<art::Rgb> colour = {art::Rgb{1, 0, 0}})
{
    art::Shape shape;
    shape.drawing = std::move(drawing);
    shape.fill = art::Fill{std::move(colour), {1}, FillRule::nonzero};
    return shape;
}

inline art::Node node(std::string name, decltype(art::Node::content) content, art::Transform transform = {})
{
    art::Node result;
    result.name = std::move(name);
    result.content = std::move(content);
    result.transform = std::move(transform);
    return result;
}

inline art::Node red_box(std::string name) { return node(std::move(name), filled(box(10, 10, 20, 20))); }

inline art::Channel rising(double from, double to) { return art::Channel{{{0, from, {}}, {30, to, {}}}}; }

inline art::Document document(std::vector<art::Node> nodes)
{
    art::Document result;
    result.width = 100;
    result.height = 80;
    result.frames = 60;
    result.nodes = std::move(nodes);
    return result;
}

}
