#include "core/scene/packed_drawing.hpp"

#include "core/bytes/op_counter.hpp"

#include <algorithm>

namespace kfast {

PackedValues PackedValues::take(ByteReader& bytes, std::uint32_t count, std::int32_t more)
{
    PackedValues values;
    values.place_ = bytes.rest().data();
    values.more_ = static_cast<std::uint32_t>(more);
    if (count > 1) {
        const std::uint32_t form = bytes.u8();
        values.width_ = static_cast<std::uint8_t>(kfb::values::width.get(form));
        values.unit_ = static_cast<std::uint8_t>(kfb::values::unit.get(form));
    }
    values.min_ = static_cast<std::uint32_t>(bytes.signed_varint());
    values.bits_ = BitReader::take(bytes, count, values.width_);
    return values;
}

std::int32_t PackedValues::operator[](std::uint32_t index) const
{
    BitReader bits = bits_;
    bits.skip(index * width_);
    const std::int32_t stored = in_unit(min_ + bits.number(width_), unit_);
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(stored) + more_);
}

namespace {

/// a - b, or 0 if `b` is more.
constexpr std::uint32_t more(std::uint32_t a, std::uint32_t b) { return a > b ? a - b : 0; }

constexpr std::uint8_t bits_within(std::uint32_t bits)
{
    return static_cast<std::uint8_t>(std::clamp<std::uint32_t>(bits, 1, StrokeForm::max_bits));
}

}

StrokeForm StrokeForm::unpacked(std::uint32_t head)
{
    StrokeForm form;
    form.mix = static_cast<SegmentMix>(kfb::form::mix.get(head));
    form.end = static_cast<StrokeEnd>(std::min<std::uint32_t>(kfb::form::end.get(head), 2));
    const std::uint32_t bits = kfb::form::end_width.get(head);
    form.ends = {bits_within(bits), kfb::form::has_sparse_ends.get(head)};
    if (form.mix == SegmentMix::lines)
        return form;
    const std::uint32_t fewer = kfb::form::less_control_width.get(head);
    form.controls = {bits_within(bits > fewer ? bits - fewer : 0), kfb::form::has_sparse_controls.get(head)};
    form.smooth = static_cast<std::uint8_t>(kfb::form::smoothness.get(head));
    return form;
}

std::uint32_t StrokeForm::packed() const
{
    const std::uint32_t head = kfb::form::mix.put(mix) | kfb::form::end.put(end) |
                               kfb::form::has_sparse_ends.put(ends.is_sparse) |
                               kfb::form::end_width.put(ends.bits);
    if (mix == SegmentMix::lines)
        return head;
    return head | kfb::form::has_sparse_controls.put(controls.is_sparse) | kfb::form::smoothness.put(smooth) |
           kfb::form::less_control_width.put(more(ends.bits, controls.bits));
}

void StrokeForm::predict(std::uint32_t byte)
{
    predicted = bits_within(kfb::predicted_cubics::first_control_width.get(byte));
    controls.bits = bits_within(controls.bits + kfb::predicted_cubics::more_control_width.get(byte));
}

std::uint32_t StrokeForm::predicting() const
{
    return kfb::predicted_cubics::first_control_width.put(predicted) |
           kfb::predicted_cubics::more_control_width.put(more(controls.bits, ends.bits));
}

namespace {

constexpr SegmentMix mix_of(std::uint32_t head) { return static_cast<SegmentMix>(kfb::form::mix.get(head)); }

/// Wraps around, does not overflow.
constexpr Fixed moved(Fixed from, std::int32_t sixteenths)
{
    const std::uint32_t shift = static_cast<std::uint32_t>(sixteenths) * (Fixed::one / 16);
    return Fixed::from_raw(static_cast<std::int32_t>(static_cast<std::uint32_t>(from.raw()) + shift));
}

constexpr Fixed predicted_end(Fixed out, Fixed in)
{
    constexpr std::int32_t sixteenth = Fixed::one / 16;
    return Fixed::sixteenths(kfast::predicted_end(out.raw() / sixteenth, in.raw() / sixteenth));
}

constexpr Point predicted_end(Point out, Point in)
{
    return {predicted_end(out.x, in.x), predicted_end(out.y, in.y)};
}

/// The highest `count` bits as a signed number.
constexpr std::int32_t top(std::uint32_t bits, std::uint32_t count)
{
    return static_cast<std::int32_t>(bits) >> (32 - count);
}

}

PackedDrawing::PackedDrawing(std::span<const std::byte> drawings, std::uint32_t offset, Point origin)
    : drawings_{drawings}, bytes_{drawings.subspan(offset)}, strokes_{bytes_.varint()}, start_{origin}
{
}

std::uint32_t PackedDrawing::next_stroke()
{
    if (!is_elsewhere_)
        bytes_ = ByteReader{bits_.rest()};
    move_start();
    flip_x_ = flip_y_ = 0;
    const std::uint32_t head = bytes_.u8();
    is_elsewhere_ = mix_of(head) == SegmentMix::repeat;
    if (is_elsewhere_) {
        ByteReader form = form_elsewhere(head);
        begin(form.u8(), form);
    } else {
        begin(head, bytes_);
    }
    return left_;
}

void PackedDrawing::move_start()
{
    const std::int32_t x = bytes_.signed_varint();
    start_ = at_ = {moved(start_.x, x), moved(start_.y, bytes_.signed_varint())};
}

ByteReader PackedDrawing::form_elsewhere(std::uint32_t head)
{
    flip_x_ = -static_cast<std::int32_t>(kfb::repeated_form::mirrors_x.get(head));
    flip_y_ = -static_cast<std::int32_t>(kfb::repeated_form::mirrors_y.get(head));
    const std::size_t offset = bytes_.varint();
    is_known_ = is_known_ && kfb::repeated_form::unused.get(head) == 0 && offset < drawings_.size();
    return is_known_ ? ByteReader{drawings_.subspan(offset)} : ByteReader{};
}

/// `form` continues after the first byte.
void PackedDrawing::begin(std::uint32_t head, ByteReader form)
{
    head |= form.u8() << 8;
    form_ = StrokeForm::unpacked(head);
    const std::uint32_t count = form.varint();
    left_ = kfb::segments::count.get(count);
    if (kfb::segments::are_predicted.get(count))
        predict(form.u8());
    half_ = form_.end == StrokeEnd::turned ? left_ / 2 : 0;
    is_known_ = is_known_ && !form.overrun() && form_.packed() == head && form_.mix != SegmentMix::repeat &&
                (half_ == 0 || left_ % 2 == 0);
    onwards_ = {};
    bits_ = BitReader{form.rest()};
}

void PackedDrawing::predict(std::uint32_t byte)
{
    form_.predict(byte);
    is_known_ = is_known_ && form_.predicting() == byte && form_.mix != SegmentMix::lines;
}

Segment PackedDrawing::next_segment()
{
    count_op(Op::segment);
    if (left_ == half_)
        turn();
    --left_;
    const bool is_cubic =
        form_.mix == SegmentMix::cubics || (form_.mix == SegmentMix::both && bits_.bits(1) != 0);
    const Point from = at_;
    if (is_cubic && form_.predicted != 0)
        return predicted_cubic(from);
    const Point to = closes() ? start_ : from + vector(form_.ends);
    at_ = to;
    if (!is_cubic) {
        onwards_ = {};
        return {.kind = Segment::Kind::line, .from = from, .c1 = {}, .c2 = {}, .to = to};
    }
    const Point c1 = from + first_control();
    const Point back = vector(form_.controls);
    onwards_ = -back;
    return {.kind = Segment::Kind::cubic, .from = from, .c1 = c1, .c2 = to + back, .to = to};
}

Segment PackedDrawing::predicted_cubic(Point from)
{
    const Point out = first_control();
    const Point in = out + vector(form_.controls);
    const Point to = closes() ? start_ : from + predicted_end(out, in) + vector(form_.ends);
    at_ = to;
    onwards_ = in;
    return {.kind = Segment::Kind::cubic, .from = from, .c1 = from + out, .c2 = to - in, .to = to};
}

/// Begins again with the first half, in the opposite direction.
void PackedDrawing::turn()
{
    bits_.go_to(0);
    flip_x_ = ~flip_x_;
    flip_y_ = ~flip_y_;
    onwards_ = {};
}

Point PackedDrawing::first_control()
{
    if (form_.smooth == 0)
        return vector(form_.first_controls());
    const std::uint32_t ahead = bits_.ahead();
    bits_.skip(1);
    if (ahead >> 31 == 0)
        return vector(form_.first_controls());
    if (form_.smooth == 1)
        return onwards_;
    const std::uint32_t width = form_.smooth;
    bits_.skip(2 * width);
    return onwards_ + flipped(top(ahead << 1, width), top(ahead << (1 + width), width));
}

Point PackedDrawing::vector(const VectorForm& form)
{
    const std::uint32_t width = form.bits;
    if (width > (BitReader::max - 2) / 2)
        return wide_vector(form);
    std::uint32_t ahead = bits_.ahead();
    if (!form.is_sparse) {
        bits_.skip(2 * width);
        return flipped(top(ahead, width), top(ahead << width, width));
    }
    const std::uint32_t given = ahead >> 30;
    ahead <<= 2;
    if (given == 3) {
        bits_.skip(2 + 2 * width);
        return flipped(top(ahead, width), top(ahead << width, width));
    }
    bits_.skip(given == 0 ? 2 : 2 + width);
    const std::int32_t value = top(ahead, width);
    return flipped(given == 2 ? value : 0, given == 1 ? value : 0);
}

Point PackedDrawing::wide_vector(const VectorForm& form)
{
    const std::uint32_t given = form.is_sparse ? bits_.bits(kfb::sparse_vector::bits) : 3;
    const std::int32_t x = kfb::sparse_vector::has_x.get(given) ? bits_.signed_bits(form.bits) : 0;
    const std::int32_t y = kfb::sparse_vector::has_y.get(given) ? bits_.signed_bits(form.bits) : 0;
    return flipped(x, y);
}

inline Point PackedDrawing::flipped(std::int32_t x, std::int32_t y) const
{
    return {Fixed::sixteenths((x ^ flip_x_) - flip_x_), Fixed::sixteenths((y ^ flip_y_) - flip_y_)};
}

}
