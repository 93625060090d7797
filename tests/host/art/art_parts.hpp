#pragma once

#include "host/art/document/document.hpp"

#include <utility>

/// Short ways to say what a document consists of.
namespace kfast::test {

inline art::Shape filled(art::Animated<art::Drawing> drawing)
{
    art::Shape shape;
    shape.drawing = std::move(drawing);
    shape.fill.emplace();
    return shape;
}

inline art::Node node_of(art::Shape shape)
{
    art::Node node;
    node.content = std::move(shape);
    return node;
}

/// 100 px wide and high, and 40 frames long.
inline art::Document document_of(art::Node node)
{
    art::Document document;
    document.width = document.height = 100;
    document.frames = 40;
    document.nodes.push_back(std::move(node));
    return document;
}

}
