#include "host/art/prepare/merged_curves.hpp"

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

bool has_edge(const std::optional<Line>& line, bool closed)
{
    return line && (line->join != Join::round || (!closed && line->cap != Cap::round));
}

OutlineEdge edge_of(const Line& line, double tolerance)
{
    const double longest = line.join == Join::miter ? std::max(1.0, line.miter_limit) : 1;
    return {greatest(line.width) / 2, longest * longest, tolerance};
}

}

void merge_curves(Figure& figure, double tolerance)
{
    if (figure.skin || !all_same_form(figure.drawing))
        return;
    const auto tweens = tweens_of(figure.drawing);
    auto& keys = figure.drawing.keys;
    for (std::size_t i = 0; i < keys.front().value.outlines.size(); ++i) {
        std::vector<scene::Outline*> outlines;
        outlines.reserve(keys.size());
        for (auto& key : keys)
            outlines.push_back(&key.value.outlines[i]);
        // What corners and ends of a line show of turns comes on top of what points move.
        if (has_edge(figure.line, outlines.front()->closed))
            MergedOutline{outlines, tweens, tolerance / 2, edge_of(*figure.line, tolerance / 2)}.write();
        else
            MergedOutline{outlines, tweens, tolerance, {}}.write();
    }
}

}
