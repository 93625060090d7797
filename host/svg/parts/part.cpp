#include "host/svg/parts/part.hpp"

#include "host/art/geometry/curves.hpp"
#include "host/geometry/shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kfast::svg {
namespace {

using scene::Vec2;

class GrowingBox {
public:
    explicit GrowingBox(bool with_lines) : with_lines_{with_lines} {}

    void add(Vec2 spot, double margin)
    {
        const Vec2 min{spot.x - margin, spot.y - margin};
        const Vec2 max{spot.x + margin, spot.y + margin};
        if (!box_)
            box_ = Box{min, max};
        box_->min = {std::min(box_->min.x, min.x), std::min(box_->min.y, min.y)};
        box_->max = {std::max(box_->max.x, max.x), std::max(box_->max.y, max.y)};
    }

    /// Cubics by some of their points: they reach at most a hundredth of their size beyond these.
    void add(const scene::Outline& outline, double margin)
    {
        constexpr int steps = 16;
        add(outline.from, margin);
        Vec2 from = outline.from;
        for (const scene::Curve& curve : outline.curves) {
            for (int step = curve.cubic ? 1 : steps; step <= steps; ++step)
                add(art::spot_on(from, curve, static_cast<double>(step) / steps), margin);
            from = curve.to;
        }
    }

    void add(const Part& part, const art::Affine& affine)
    {
        for (const Part& inner : part.parts)
            add(inner, affine * inner.own);
        const double scale_factor =
            part.pen && !part.pen->keeps_width ? std::sqrt(std::abs(affine.determinant())) : 1;
        for (const scene::Outline& outline : part.drawing.outlines)
            add(affine.of(outline), part.pen && with_lines_ ? scale_factor * part.pen->width / 2 : 0);
    }

    const std::optional<Box>& box() const { return box_; }

private:
    bool with_lines_;
    std::optional<Box> box_;
};

}

std::array<Vec2, 4> corners_of(const Box& box)
{
    return {box.min, Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}};
}

art::Drawing outline_of(const Box& box) { return {{scene::polyline(corners_of(box), true)}}; }

art::Drawing seen_through(const art::Affine& affine, const art::Drawing& drawing)
{
    art::Drawing result;
    for (const scene::Outline& outline : drawing.outlines)
        result.outlines.push_back(affine.of(outline));
    return result;
}

std::optional<Box> box_of(const Part& part, const art::Affine& affine)
{
    GrowingBox box{false};
    box.add(part, affine);
    return box.box();
}

std::optional<Box> box_with_lines(const Part& part, const art::Affine& affine)
{
    GrowingBox box{true};
    box.add(part, affine);
    return box.box();
}

void split_line(Part& part, const art::Drawing& line, bool below)
{
    Part fill = part;
    fill.pen.reset();
    fill.own = {};
    fill.opacity = 1;
    Part stroke = fill;
    fill.kind += " fill";
    stroke.kind += " line";
    stroke.name += " line";
    stroke.id = stroke.id.empty() ? "" : stroke.id + " line";
    stroke.label = stroke.label.empty() ? "" : stroke.label + " line";
    stroke.fill.reset();
    stroke.pen = std::exchange(part.pen, std::nullopt);
    stroke.drawing = line;
    part.fill.reset();
    part.drawing = {};
    part.is_group = true;
    part.parts = below ? std::vector{stroke, fill} : std::vector{fill, stroke};
}

bool looks_like(const Part& left, const Part& right)
{
    return left.own == right.own && left.opacity == right.opacity && left.is_group == right.is_group &&
           left.drawing == right.drawing && left.rule == right.rule && left.fill == right.fill &&
           left.pen == right.pen && std::ranges::equal(left.parts, right.parts, looks_like);
}

}
