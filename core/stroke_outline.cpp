#include "core/stroke_outline.hpp"

#include "core/square_root.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>

namespace kfast {
namespace {

constexpr std::int32_t shortest_step = Fixed::one / 256;

/// Turns of less than 1/2048 turn need no arc and no wedge.
constexpr std::int32_t straight_turn = BinaryAngle::turn / 2048;

Point scaled(std::int32_t x_q30, std::int32_t y_q30, Fixed length)
{
    return {Fixed::from_raw(multiply(x_q30, length.raw(), 30)),
            Fixed::from_raw(multiply(y_q30, length.raw(), 30))};
}

/// Tips stay where Fixed can hold them: corners are within 16383 px.
Fixed tip_distance(std::int64_t raw)
{
    return Fixed::from_raw(
        static_cast<std::int32_t>(std::min<std::int64_t>(raw, Fixed::pixels(16384).raw())));
}

}

void StrokeOutline::begin(Point at)
{
    first_ = last_ = at;
    has_segment_ = false;
}

void StrokeOutline::line_to(Point to)
{
    const Point step = to - last_;
    if (std::max(std::abs(step.x.raw()), std::abs(step.y.raw())) < shortest_step)
        return;
    const Heading heading = heading_of(step);
    if (has_segment_)
        join(last_, last_heading_, heading);
    else
        first_heading_ = heading;
    const Point side = aside(heading);
    line(last_ + side, to + side);
    line(to - side, last_ - side);
    last_ = to;
    last_heading_ = heading;
    has_segment_ = true;
}

void StrokeOutline::end(bool is_closed)
{
    spare_pieces_ = unlimited;
    if (is_closed)
        line_to(first_);
    if (!has_segment_) {
        dot();
    } else if (is_closed) {
        join(first_, last_heading_, first_heading_);
    } else {
        cap(last_, last_heading_);
        const BinaryAngle back = BinaryAngle::from_raw(first_heading_.angle.raw + BinaryAngle::half_turn);
        cap(first_, {-first_heading_.x, -first_heading_.y, back});
    }
}

// The vector is brought to 15 bits, so that its square fits in 32; the direction is then within 1/15000 rad,
// 1/750 px at the edge of a stroke 40 px wide.
StrokeOutline::Heading StrokeOutline::heading_of(Point vector)
{
    const std::int32_t x = vector.x.raw();
    const std::int32_t y = vector.y.raw();
    const auto longest = static_cast<std::uint32_t>(std::max(std::abs(x), std::abs(y)));
    const int shift = 17 - std::countl_zero(longest);
    const auto shifted = [shift](std::int32_t value) {
        return shift > 0 ? (value + (1 << (shift - 1))) >> shift : value * (1 << -shift);
    };
    const std::int32_t short_x = shifted(x);
    const std::int32_t short_y = shifted(y);
    const auto square_of = [](std::int32_t value) { return static_cast<std::uint32_t>(value * value); };
    const auto length = static_cast<std::int32_t>(square_root(square_of(short_x) + square_of(short_y)));
    return {short_x * 32768 / length, short_y * 32768 / length, direction(x, y)};
}

/// Half a width in the direction of `heading`.
Point StrokeOutline::ahead(Heading heading) const
{
    return {Fixed::from_raw(multiply(heading.x, pen_.half_width.raw(), 15)),
            Fixed::from_raw(multiply(heading.y, pen_.half_width.raw(), 15))};
}

/// Half a width to the right of `heading`.
Point StrokeOutline::aside(Heading heading) const
{
    const Point along = ahead(heading);
    return {-along.y, along.x};
}

/// The inner side goes through the corner itself: then every part of the outline turns the same way, however
/// short the segments are.
void StrokeOutline::join(Point at, Heading before, Heading after)
{
    const Point side_before = aside(before);
    const Point side_after = aside(after);
    const std::int32_t turn = shortest_turn(before.angle, after.angle);
    if (std::abs(turn) < straight_turn) {
        line(at + side_before, at + side_after);
        line(at - side_after, at - side_before);
        return;
    }
    const bool turns_right = turn > 0;
    const Point inner_from = turns_right ? side_before : -side_after;
    const Point inner_to = turns_right ? side_after : -side_before;
    line(at + inner_from, at);
    line(at, at + inner_to);
    if (turns_right)
        outer_join(at, -side_after, -side_before,
                   BinaryAngle::from_raw(after.angle.raw - BinaryAngle::quarter_turn), -turn);
    else
        outer_join(at, side_before, side_after,
                   BinaryAngle::from_raw(before.angle.raw + BinaryAngle::quarter_turn), turn);
}

void StrokeOutline::outer_join(Point at, Point from, Point to, BinaryAngle from_angle, std::int32_t turn)
{
    if (pen_.join == Join::round) {
        arc(at, from, to, from_angle, turn);
        return;
    }
    // The miter is 1 / cos(turn / 2) half widths long.
    const std::int32_t half_cosine = cosine(BinaryAngle::from_raw(turn / 2));
    if (pen_.join == Join::miter && half_cosine >= one_q30 / pen_.miter_limit * 8) {
        const BinaryAngle middle = BinaryAngle::from_raw(from_angle.raw + turn / 2);
        const std::int64_t length = (std::int64_t{pen_.half_width.raw()} << 30) / half_cosine;
        const Point tip = at + scaled(cosine(middle), sine(middle), tip_distance(length));
        line(at + from, tip);
        line(tip, at + to);
    } else {
        line(at + from, at + to);
    }
}

void StrokeOutline::arc(Point centre, Point from, Point to, BinaryAngle from_angle, std::int32_t turn)
{
    const std::int32_t wanted =
        (std::abs(turn) * pen_.arc_pieces + BinaryAngle::half_turn - 1) / BinaryAngle::half_turn;
    const std::int32_t pieces = std::min(wanted - 1, spare_pieces_) + 1;
    spare_pieces_ -= pieces - 1;
    Point last = centre + from;
    for (std::int32_t piece = 1; piece < pieces; ++piece) {
        const BinaryAngle angle = BinaryAngle::from_raw(from_angle.raw + turn * piece / pieces);
        const Point next = centre + scaled(cosine(angle), sine(angle), pen_.half_width);
        line(last, next);
        last = next;
    }
    line(last, centre + to);
}

void StrokeOutline::cap(Point at, Heading outwards)
{
    const Point side = aside(outwards);
    if (pen_.cap == Cap::round) {
        arc(at, side, -side, BinaryAngle::from_raw(outwards.angle.raw + BinaryAngle::quarter_turn),
            -BinaryAngle::half_turn);
        return;
    }
    const Point front = pen_.cap == Cap::square ? at + ahead(outwards) : at;
    line(at + side, front + side);
    line(front + side, front - side);
    line(front - side, at - side);
}

/// A stroke without length: a disc or a square, as in SVG.
void StrokeOutline::dot()
{
    if (pen_.cap == Cap::butt)
        return;
    cap(first_, {32768, 0, {}});
    cap(first_, {-32768, 0, BinaryAngle::from_raw(BinaryAngle::half_turn)});
}

}
