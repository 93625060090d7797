#include "core/pose/posed_bones.hpp"

#include "core/bytes/function_ref.hpp"
#include "core/bytes/op_counter.hpp"
#include "core/math/fixed.hpp"
#include "core/math/point.hpp"
#include "core/time/track.hpp"

#include <algorithm>
#include <array>

namespace kfast {

namespace {

using FineValues = std::array<std::int32_t, bone_quantity_count>;

constexpr std::int64_t max_stretch = 64 * std::int64_t{Fixed::one};

std::int32_t of(std::span<const std::int32_t, bone_quantity_count> values, BoneQuantity quantity)
{
    return values[static_cast<std::size_t>(quantity)];
}

/// The point at (x, y) in the frame of `parent`, on the canvas.
Point on_canvas(const BoneFrame& parent, Fixed x, Fixed y)
{
    const std::int64_t cosine = parent.direction.cosine;
    const std::int64_t sine = parent.direction.sine;
    return clamped_point(parent.origin.x.raw() + rounded_shift(cosine * x.raw() - sine * y.raw(), 30),
                         parent.origin.y.raw() + rounded_shift(sine * x.raw() + cosine * y.raw(), 30));
}

BoneFrame frame_in(const BoneFrame& parent, std::span<const std::int32_t, bone_quantity_count> fine,
                   Fixed shift)
{
    const FineAngle angle = parent.angle + FineAngle::of_fine(of(fine, BoneQuantity::angle));
    return {.origin = on_canvas(parent, fine_pixels(of(fine, BoneQuantity::x)) + shift,
                                fine_pixels(of(fine, BoneQuantity::y))),
            .angle = angle,
            .direction = {cosine(angle), sine(angle)}};
}

FineValues values_at_rest(const BoneSetUp& bone)
{
    FineValues fine;
    std::ranges::transform(bone.set_up, fine.begin(), [](std::int32_t value) { return to_fine(value); });
    return fine;
}

/// The length relative to that as set up, at most 64; Q16.
std::int64_t stretch_factor(std::int64_t length, std::uint32_t set_up_length)
{
    if (length == set_up_length) // mostly
        return Fixed::one;
    return std::min(quotient((length << 16) + set_up_length / 2, set_up_length), max_stretch);
}

/// stretch * a + b of Q30 numbers, as a Q16 factor; a + b is a component of a unit vector.
std::int32_t factor(std::int64_t stretch, std::int32_t a, std::int32_t b)
{
    if (stretch == Fixed::one) // mostly
        return q16_of_q30(a + b);
    return static_cast<std::int32_t>(rounded_shift(((stretch * a) >> 16) + b, 14));
}

BoneSetUp set_up_of(const SceneView& scene, const BoneNode& bone)
{
    ByteReader bytes = scene.at(bone.place);
    return BoneSetUp::take(bytes);
}

/// The values of the quantities of a bone. Tracks have differences from the set-up.
FineValues values_of(const PreparedScene& prepared, const BoneNode& node, const BoneSetUp& bone)
{
    FineValues fine = values_at_rest(bone);
    for (const TrackState& track : prepared.tracks(node)) {
        const auto quantity = static_cast<BoneQuantity>(track.property);
        KeySpan key_span = prepared.key_span(track, quantity == BoneQuantity::y ? LawAxis::y : LawAxis::x);
        key_span.from += bone.at_rest(quantity);
        key_span.to += bone.at_rest(quantity);
        if (quantity == BoneQuantity::angle && !bone.turns_as_written)
            key_span.to = key_span.from + shortest_turn(BinaryAngle::from_raw(key_span.from),
                                                        BinaryAngle::from_raw(key_span.to));
        fine[track.property] = fine_value(key_span);
    }
    return fine;
}

const PosedBone* parent_of(const BoneNode& bone, std::span<const PosedBone> live)
{
    return bone.parent == 0 ? nullptr : &live[bone.parent - 1U];
}

}

void PosedBone::set_up(const BoneSetUp& bone, const PosedBone* parent)
{
    rest_ = frame_in(parent == nullptr ? BoneFrame{} : parent->rest_, values_at_rest(bone), {});
}

void PosedBone::pose(const BoneSetUp& bone, const PosedBone* parent,
                     std::span<const std::int32_t, bone_quantity_count> fine)
{
    count_op(Op::bone);
    const Fixed shift = parent != nullptr && bone.is_at_tip ? parent->extension_ : Fixed{};
    posed_ = frame_in(parent == nullptr ? BoneFrame{} : parent->posed_, fine, shift);
    const std::int64_t set_up_length = std::int64_t{bone.at_rest(BoneQuantity::length)} << fine_bits;
    const std::int64_t length = std::max<std::int32_t>(of(fine, BoneQuantity::length), 0);
    extension_ = fine_pixels(static_cast<std::int32_t>(length - set_up_length));
    const std::int64_t stretch = stretch_factor(length, static_cast<std::uint32_t>(set_up_length));
    const auto [c, s] = rest_.direction;
    const auto [posed_c, posed_s] = posed_.direction;
    xx_ = factor(stretch, product_q30_down(posed_c, c), product_q30_down(posed_s, s));
    xy_ = factor(stretch, product_q30_down(posed_c, s), -product_q30_down(posed_s, c));
    yx_ = factor(stretch, product_q30_down(posed_s, c), -product_q30_down(posed_c, s));
    yy_ = factor(stretch, product_q30_down(posed_s, s), product_q30_down(posed_c, c));
}

Point PosedBone::operator()(Point point) const
{
    count_op(Op::carried_point);
    const Point from = point - rest_.origin;
    const std::int32_t x = from.x.raw();
    const std::int32_t y = from.y.raw();
    if (is_small_distance(x) && is_small_distance(y) && is_small_factor(xx_) && is_small_factor(xy_) &&
        is_small_factor(yx_) && is_small_factor(yy_)) // mostly
        return {clamped(posed_.origin.x.raw() + short_sum_of_products(xx_, x, xy_, y)),
                clamped(posed_.origin.y.raw() + short_sum_of_products(yx_, x, yy_, y))};
    return clamped_point(posed_.origin.x.raw() + sum_of_products(xx_, x, xy_, y),
                         posed_.origin.y.raw() + sum_of_products(yx_, x, yy_, y));
}

Affine PosedBone::map() const
{
    const std::int32_t x = rest_.origin.x.raw();
    const std::int32_t y = rest_.origin.y.raw();
    return {.xx = xx_,
            .xy = xy_,
            .yx = yx_,
            .yy = yy_,
            .x0 = posed_.origin.x.raw() - sum_of_products(xx_, x, xy_, y),
            .y0 = posed_.origin.y.raw() - sum_of_products(yx_, x, yy_, y)};
}

void set_up_bones(const SceneView& scene, const PreparedScene& prepared, std::span<PosedBone> live)
{
    std::size_t number = 0;
    for (const BoneNode& bone : prepared.bones()) {
        live[number] = {};
        live[number++].set_up(set_up_of(scene, bone), parent_of(bone, live));
    }
}

void pose_bones(const SceneView& scene, const PreparedScene& prepared, std::span<PosedBone> live)
{
    std::size_t number = 0;
    for (const BoneNode& bone : prepared.bones()) {
        const BoneSetUp set_up = set_up_of(scene, bone);
        live[number++].pose(set_up, parent_of(bone, live), values_of(prepared, bone, set_up));
    }
}

namespace {

/// A sum of weighted coordinates, rounded to 1/65536 px. Products of what is above and below 1/256 px with
/// the high and the low byte of a weight fit in 32 bits; what is lost of the smallest ones is less than 1/64
/// of the unit.
class WeightedSum {
public:
    void add(Fixed coordinate, std::int32_t weight)
    {
        const std::int32_t above = coordinate.raw() >> 8;
        const std::int32_t below = coordinate.raw() & 255;
        const std::int32_t high = weight >> 8;
        const std::int32_t low = weight & 255;
        const std::int32_t cross = above * low;
        whole_ += above * high + (cross >> 8);
        rest_ += below * high + (cross & 255) + ((below * low) >> 8);
    }

    Fixed rounded() const { return Fixed::from_raw(whole_ + (rest_ >> 8)); }

private:
    std::int32_t whole_ = 0;
    std::int32_t rest_ = 128; ///< in 1/256 of its unit
};

Point deformed_by(std::span<const PosedBone> bones, Point point, const Binding& binding)
{
    if (binding.count() == 1)
        return bones[binding.last()](point);
    WeightedSum x;
    WeightedSum y;
    binding.each([&](BoneInfluence share) {
        const Point part = bones[share.bone](point);
        x.add(part.x, share.weight);
        y.add(part.y, share.weight);
    });
    return {x.rounded(), y.rounded()};
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
                         std::int64_t{point.y.raw()} + moved.y.raw() - at_rest.y.raw(),
                         max_tweened_coordinate);
}

}
