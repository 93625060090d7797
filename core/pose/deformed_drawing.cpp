#include "core/pose/deformed_drawing.hpp"

#include "core/bytes/function_ref.hpp"
#include "core/math/point.hpp"

namespace kfast {
namespace {

/// Rounded to 1/65536 px. Products with the bits above and below 1/256 px fit in 32 bits.
Point deformed_by(std::span<const PosedBone> bones, Point point, const Binding& binding)
{
    if (binding.count() == 1)
        return bones[binding.last()](point);
    Point whole;
    Point rest{Fixed::from_raw(128), Fixed::from_raw(128)};
    binding.each([&](BoneInfluence share) {
        const Point part = bones[share.bone](point);
        const auto times = [weight = share.weight](std::int32_t raw) {
            return Fixed::from_raw(raw * weight);
        };
        whole = whole + Point{times(part.x.raw() >> 8), times(part.y.raw() >> 8)};
        rest = rest + Point{times(part.x.raw() & 255), times(part.y.raw() & 255)};
    });
    return {whole.x + Fixed::from_raw(rest.x.raw() >> 8), whole.y + Fixed::from_raw(rest.y.raw() >> 8)};
}

}

const DeformedDrawing::Code DeformedDrawing::code{.begin_stroke =
                                                      plain_function<&DeformedDrawing::begin_deformed_stroke>,
                                                  .deform = plain_function<&DeformedDrawing::deform>};

DeformedDrawing::DeformedDrawing(const PackedDrawing& drawing, const PackedDrawing& at_rest,
                                 const SkinReader& skin, std::span<const PosedBone> bones)
    : code_{&code}, drawing_{drawing}, at_rest_{at_rest}, skin_{skin}, bones_{bones}
{
}

std::uint32_t DeformedDrawing::next_stroke()
{
    const std::uint32_t segments = drawing_.next_stroke();
    start_ = drawing_.start();
    if (is_deformed())
        code_->begin_stroke(*this);
    return segments;
}

Segment DeformedDrawing::next_segment()
{
    Segment segment = drawing_.next_segment();
    if (is_deformed())
        code_->deform(*this, segment);
    return segment;
}

void DeformedDrawing::begin_deformed_stroke()
{
    at_rest_.next_stroke();
    start_ = deformed(start_, at_rest_.start(), skin_.next());
    at_ = start_;
}

void DeformedDrawing::deform(Segment& segment)
{
    const Segment at_rest = at_rest_.next_segment();
    segment.from = at_;
    if (segment.kind == Segment::Kind::cubic)
        segment.c1 = deformed(segment.c1, at_rest.c1, skin_.binding());
    const Binding& binding = skin_.next();
    if (segment.kind == Segment::Kind::cubic)
        segment.c2 = deformed(segment.c2, at_rest.c2, binding);
    segment.to = deformed(segment.to, at_rest.to, binding);
    at_ = segment.to;
}

Point DeformedDrawing::deformed(Point point, Point at_rest, const Binding& binding) const
{
    const Point moved = deformed_by(bones_, at_rest, binding);
    return clamped_point(std::int64_t{point.x.raw()} + moved.x.raw() - at_rest.x.raw(),
                         std::int64_t{point.y.raw()} + moved.y.raw() - at_rest.y.raw(), farthest_tweened);
}

}
