#include "host/svg/parts/clipped_part.hpp"

#include "host/svg/parts/clip_cover.hpp"
#include "host/svg/parts/clip_cut.hpp"
#include "host/svg/parts/motion.hpp"

#include <algorithm>
#include <array>

namespace kfast::svg {
namespace {

using art::Affine;
using scene::Vec2;

bool has_curves(const art::Drawing& drawing)
{
    return std::ranges::any_of(drawing.outlines, [](const scene::Outline& outline) {
        return std::ranges::any_of(outline.curves, &scene::Curve::cubic);
    });
}

std::size_t curves_in(const art::Drawing& drawing)
{
    std::size_t count = 0;
    for (const scene::Outline& outline : drawing.outlines)
        count += 1 + outline.curves.size();
    return count;
}

/// What both have in common. Where one of them has to be made of lines, it is the one that is so already.
art::Drawing common(const art::Drawing& drawing, const art::Drawing& area, art::Budget& budget)
{
    const auto straight = has_curves(drawing) ? std::nullopt : convex_corners(drawing);
    const auto& cut_one = straight ? area : drawing;
    const auto corners = straight ? straight : convex_corners(area);
    if (!corners)
        return drawing;
    budget.take_computed_points(16 * curves_in(cut_one) * corners->size());
    return cut(cut_one, *corners);
}

}

bool Clip::apply(Part& part, const Affine& affine)
{
    const auto box = box_with_lines(part, affine);
    if (!box || covers(area_, corners_of(*box)))
        return true;
    if (cut(outline_of(*box), *convex_corners(area_)).outlines.empty())
        return false;
    if (part.fill && part.pen) {
        budget_.take_node();
        split_line(part, part.drawing, false);
    }
    if (part.is_group) {
        std::erase_if(part.parts, [&](Part& inner) { return !apply(inner, affine * inner.own); });
        return !part.parts.empty();
    }
    if (part.fill)
        return cut_fill(part, affine);
    whole_lines_.push_back(part.layer);
    return true;
}

bool Clip::cut_fill(Part& part, const Affine& affine)
{
    const auto inwards = affine.inverse();
    if (!inwards)
        return true; // it has no area
    part.drawing = common(part.drawing, seen_through(*inwards, area_), budget_);
    budget_.take_points(curves_in(part.drawing));
    return !part.drawing.outlines.empty();
}

}
