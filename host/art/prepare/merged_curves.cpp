#include "host/art/prepare/prepare.hpp"

#include "host/art/document/extent.hpp"
#include "host/art/prepare/merged_outline.hpp"

#include <algorithm>

namespace kfast::art {
namespace {

bool all_same_form(const Animated<Drawing>& drawing)
{
    return std::ranges::all_of(
        drawing.keys, [&](const auto& key) { return same_form(drawing.keys.front().value, key.value); });
}

bool has_edge(const std::optional<StrokeStyle>& stroke, bool closed)
{
    return stroke && (stroke->join != Join::round || (!closed && stroke->cap != Cap::round));
}

OutlineEdge edge_of(const StrokeStyle& stroke, double tolerance)
{
    const double longest = stroke.join == Join::miter ? std::max(1.0, stroke.miter_limit) : 1;
    return {greatest(stroke.width) / 2, longest * longest, tolerance};
}

}

void merge_curves(Shape& shape, double tolerance)
{
    if (shape.skin || !all_same_form(shape.drawing))
        return;
    const auto tweens = tweens_of(shape.drawing);
    auto& keys = shape.drawing.keys;
    for (std::size_t i = 0; i < keys.front().value.outlines.size(); ++i) {
        std::vector<scene::Outline*> outlines;
        outlines.reserve(keys.size());
        for (auto& key : keys)
            outlines.push_back(&key.value.outlines[i]);
        // How far corners and ends of a line move by rotation adds to how far points move.
        if (has_edge(shape.stroke, outlines.front()->closed))
            MergedOutline{outlines, tweens, tolerance / 2, edge_of(*shape.stroke, tolerance / 2)}.write();
        else
            MergedOutline{outlines, tweens, tolerance, {}}.write();
    }
}

}
