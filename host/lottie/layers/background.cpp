#include "host/lottie/layers/background.hpp"

#include "host/art/document/matrix_at.hpp"
#include "host/lottie/drawings/extent.hpp"
#include "host/lottie/shapes/transform.hpp"

namespace kfast::lottie {
namespace {

bool is_still(const art::Transform& transform)
{
    return !transform.path &&
           std::ranges::all_of(
               std::initializer_list<const art::Channel*>{
                   &transform.anchor_x, &transform.anchor_y, &transform.x, &transform.y, &transform.z,
                   &transform.scale_x, &transform.scale_y, &transform.rotate, &transform.rotate_x,
                   &transform.rotate_y, &transform.skew, &transform.skew_axis},
               [](const art::Channel* channel) { return steady_value(*channel).has_value(); }) &&
           is_flat(transform);
}

bool is_plain(const art::Node& node)
{
    return is_still(node.transform) && steady_value(node.opacity) == 1.0 &&
           node.shown == std::vector<art::Span>{{}};
}

/// The colour of a shape that is a background.
std::optional<art::Rgb> background_of(const art::Node& node, const art::Document& document,
                                      const art::Affine& matrix = {})
{
    if (!is_plain(node))
        return std::nullopt;
    const art::Affine inner = matrix * matrix_at(node.transform, 0);
    if (const auto* group = std::get_if<art::Group>(&node.content))
        return group->nodes.size() == 1 ? background_of(group->nodes.front(), document, inner) : std::nullopt;
    const auto& shape = std::get<art::Shape>(node.content);
    if (!shape.drawing.is_still() || shape.drawing.value().outlines.size() != 1 || !shape.fill ||
        shape.stroke || !shape.fill->colour.is_still() || steady_value(shape.fill->opacity) != 1.0)
        return std::nullopt;
    const auto corners = Box{0, 0, document.width, document.height}.corners();
    if (!contains({{inner.of(shape.drawing.value().outlines.front())}}, corners))
        return std::nullopt;
    return shape.fill->colour.value();
}

}

void lift_background(art::Document& document)
{
    if (document.nodes.empty())
        return;
    document.background = background_of(document.nodes.front(), document);
    if (document.background)
        document.nodes.erase(document.nodes.begin());
}

}
