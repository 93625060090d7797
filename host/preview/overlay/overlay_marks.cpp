#include "host/preview/overlay/overlay_marks.hpp"

#include "host/preview/painter/painter.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace kfast {

bool LabelPlaces::take(PanelSpot at, const std::string& text)
{
    if (count_ == max)
        return false;
    // A text takes the cells that it touches: one more than it has letters, in two rows.
    const int column = static_cast<int>(std::floor(at.x * scale_ / Painter::letter.width));
    const int row = static_cast<int>(std::floor(at.y * scale_ / Painter::letter.height));
    const int end = column + static_cast<int>(text.size()) + 1;
    for (int x = column; x < end; ++x)
        for (int y = row; y < row + 2; ++y)
            if (cells_.contains({x, y}))
                return false;
    for (int x = column; x < end; ++x)
        for (int y = row; y < row + 2; ++y)
            cells_.emplace(x, y);
    ++count_;
    return true;
}

namespace {

/// The middle of the points' bounding box.
PanelSpot middle_of(const std::vector<PanelSpot>& spots)
{
    PanelSpot min = spots.front();
    PanelSpot max = spots.front();
    for (const PanelSpot& spot : spots) {
        min = {std::min(min.x, spot.x), std::min(min.y, spot.y)};
        max = {std::max(max.x, spot.x), std::max(max.y, spot.y)};
    }
    return {(min.x + max.x) / 2, (min.y + max.y) / 2};
}

}

void OverlayMarks::add_bones(const SeenLeaf& leaf)
{
    if (leaf.item.kind != ItemKind::object)
        return;
    if (leaf.item.object.deformer == Deformer::bones)
        add_bones(leaf.item.object.skeleton, leaf.space);
    for (const SeenBackbone& backbone : seen_backbones(scene_, leaf)) {
        add_lines(backbone.nodes, MarkKind::backbone);
        add_lines(backbone.left, MarkKind::outline);
        add_lines(backbone.right, MarkKind::outline);
        for (const Point node : backbone.nodes)
            add_dot(node, MarkKind::backbone);
    }
}

void OverlayMarks::add_other_bones()
{
    std::uint32_t skeleton = 0;
    for (SkeletonCursor all = viewport_.scene.skeletons(); !all.at_end(); ++skeleton) {
        all.skip();
        if (!deformers_.contains(skeleton))
            add_bones(skeleton, scene_.on_panel().canvas);
    }
}

void OverlayMarks::add_bones(std::uint32_t skeleton, const Space& space)
{
    deformers_.insert(skeleton);
    const std::vector<SeenBone> bones = seen_bones(scene_, skeleton, space);
    const auto& [origin, tip] = bones.front(); // a skeleton has at least one
    if (!skeletons_.emplace(skeleton, origin.x, origin.y, tip.x, tip.y).second)
        return;
    for (const SeenBone& bone : bones) {
        add_line(bone.origin, bone.tip, MarkKind::bone);
        add_dot(bone.origin, MarkKind::bone);
    }
}

void OverlayMarks::add_outline(const std::vector<SeenStroke>& strokes)
{
    for (const SeenStroke& stroke : strokes)
        add_lines(stroke.line, MarkKind::outline);
}

void OverlayMarks::add_numbers(const SeenLeaf& leaf)
{
    const std::vector<SeenStroke> strokes = matched_strokes(scene_, leaf);
    add_outline(strokes);
    for (std::size_t i = 0; i < strokes.size(); ++i)
        add_number(strokes[i], i + 1);
    for (const SeenStroke& stroke : strokes)
        add_points(stroke);
}

void OverlayMarks::add_number(const SeenStroke& stroke, std::size_t number)
{
    std::vector<PanelSpot> spots;
    for (const Point point : stroke.points)
        spots.push_back(viewport_.spot(point));
    if (!add_label(middle_of(spots), number, MarkKind::stroke))
        add_label(spots.front(), number, MarkKind::stroke);
}

void OverlayMarks::add_points(const SeenStroke& stroke)
{
    for (const auto& [from, to] : stroke.controls)
        add_line(from, to, MarkKind::control);
    std::size_t number = 0;
    for (const Point point : stroke.points) {
        add_dot(point, MarkKind::point);
        add_label(viewport_.spot(point), ++number, MarkKind::point);
    }
}

void OverlayMarks::add_lines(const std::vector<Point>& points, MarkKind kind)
{
    for (std::size_t i = 1; i < points.size(); ++i)
        add_line(points[i - 1], points[i], kind);
}

void OverlayMarks::add_line(Point from, Point to, MarkKind kind)
{
    if (overlay_.lines.size() < max_lines)
        overlay_.lines.push_back({viewport_.spot(from), viewport_.spot(to), kind});
}

void OverlayMarks::add_dot(Point at, MarkKind kind)
{
    if (overlay_.dots.size() < max_dots)
        overlay_.dots.push_back({viewport_.spot(at), kind});
}

bool OverlayMarks::add_label(PanelSpot at, std::size_t number, MarkKind kind)
{
    std::string text = std::to_string(number);
    const bool fits = places_.take(at, text);
    if (fits)
        overlay_.labels.push_back({at, std::move(text), kind});
    return fits;
}

}
