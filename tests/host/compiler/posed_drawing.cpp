#include "tests/host/compiler/posed_drawing.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::test {
namespace {

using scene::Vec2;

/// As far out as the player lets points of carried drawings be.
constexpr double farthest = 4095;

Vec2 spot_of(scene::Point point) { return {point.x / 16.0, point.y / 16.0}; }

Fixed fixed(double pixels)
{
    return Fixed::from_raw(
        static_cast<std::int32_t>(std::lround(std::clamp(pixels, -farthest, farthest) * Fixed::one)));
}

/// Moves the points of a drawing, in their order.
class Deformer {
public:
    Deformer(const std::vector<scene::Binding>& bindings, const std::vector<scene::BoneMotion>& motions)
        : next_{bindings.data()}, motions_{motions}
    {
    }

    /// The next points follow the next vertex.
    void next_vertex() { binding_ = next_++; }

    Point operator()(scene::Point point, scene::Point at_rest) const
    {
        const Vec2 rest = spot_of(at_rest);
        Vec2 moved = spot_of(point) - rest;
        for (const scene::BoneWeight& share : *binding_)
            moved = moved + share.weight / 65536.0 * motions_[share.bone](rest);
        return {fixed(moved.x), fixed(moved.y)};
    }

private:
    const scene::Binding* next_;
    const scene::Binding* binding_ = nullptr;
    const std::vector<scene::BoneMotion>& motions_;
};

Segment deformed(const scene::Segment& own, const scene::Segment& rest, Point from, Deformer& deformer)
{
    Segment segment{.kind = own.cubic ? Segment::Kind::cubic : Segment::Kind::line, .from = from};
    if (own.cubic)
        segment.c1 = deformer(own.c1, rest.c1);
    deformer.next_vertex();
    if (own.cubic)
        segment.c2 = deformer(own.c2, rest.c2);
    segment.to = deformer(own.to, rest.to);
    return segment;
}

}

PosedDrawing::PosedDrawing(const SkinnedDrawing& skinned, const std::vector<scene::BoneMotion>& motions)
{
    Deformer deformer{skinned.bindings, motions};
    for (std::size_t i = 0; i < skinned.drawing.strokes.size(); ++i) {
        const scene::Stroke& own = skinned.drawing.strokes[i];
        const scene::Stroke& rest = skinned.rest().strokes[i];
        Stroke& stroke = strokes_.emplace_back();
        deformer.next_vertex();
        stroke.start = deformer(own.from, rest.from);
        Point at = stroke.start;
        for (std::size_t segment = 0; segment < own.segments.size(); ++segment) {
            stroke.segments.push_back(deformed(own.segments[segment], rest.segments[segment], at, deformer));
            at = stroke.segments.back().to;
        }
    }
}

}
