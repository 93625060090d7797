#include "core/raster/outline/stroke_outline.hpp"

#include "core/bytes/function_ref.hpp"
#include "core/bytes/op_counter.hpp"
#include "core/math/angle.hpp"
#include "core/math/flatten.hpp"
#include "core/math/point.hpp"
#include "core/raster/outline/grid.hpp"
#include "core/raster/outline/pen_arc.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>

namespace kfast {
namespace {

constexpr std::int32_t shortest_step = Fixed::one / 256;

using pen_arc::arc_step;
using pen_arc::cosine_q15;
using pen_arc::first_angle;
using pen_arc::quarter_turn;
using pen_arc::sine_q15;

Point scaled(Point vector, std::int32_t factor_q15)
{
    return {Fixed::from_raw(multiply_q16(vector.x.raw(), 2 * factor_q15)),
            Fixed::from_raw(multiply_q16(vector.y.raw(), 2 * factor_q15))};
}

Fixed held_on_panel(Fixed at)
{
    constexpr std::int32_t farthest = Fixed::pixels(max_coordinate).raw();
    return Fixed::from_raw(std::clamp(at.raw(), -farthest, farthest));
}

/// A rotation by 90 degrees, from the right of a direction, or from the left of its opposite.
Point turned(Point side) { return {side.y, -side.x}; }

/// Where the lines meet that pass along the ends of two sides.
Point slight_meeting(Point a, Point b, std::int32_t versine_q30)
{
    // 1 / (1 + cos) = 1 / (2 - versine), about (1 + versine / 2) / 2
    const auto of = [versine = versine_q30 >> 15](Fixed p, Fixed q) {
        const std::int32_t mean = (p + q).raw() >> 1;
        return Fixed::from_raw(mean + (mean * versine >> 16));
    };
    return {of(a.x, b.x), of(a.y, b.y)};
}

/// The same for any bend; `rest` is 1 + cos, in Q30, 2^21 or more.
Point meeting(Point a, Point b, std::uint32_t rest)
{
    const int zeros = std::countl_zero(rest);
    const auto factor = static_cast<std::int32_t>((1U << 31) / (rest << zeros >> 16));
    const auto of = [&](Fixed p, Fixed q) {
        return Fixed::from_raw(multiply((p + q).raw(), factor, 17 - zeros));
    };
    return {of(a.x, b.x), of(a.y, b.y)};
}

std::int32_t cosine_between(Direction a, Direction b) { return a.x * b.x + a.y * b.y; }
std::int32_t sine_between(Direction a, Direction b) { return a.x * b.y - a.y * b.x; }

/// 1 + cos of the angle between two headings, in Q30. Near a reversal the cosine is too coarse; 1 + cos
/// is half the square of the sum of the vectors.
std::uint32_t rest_of_turn(Direction a, Direction b, std::int32_t cosine)
{
    if (cosine >= 0)
        return static_cast<std::uint32_t>(one_q30) + static_cast<std::uint32_t>(cosine);
    const auto x = static_cast<std::uint32_t>(a.x + b.x);
    const auto y = static_cast<std::uint32_t>(a.y + b.y);
    return (x * x + y * y) / 2;
}

}

int max_corners_of_half_turn(Fixed half_width)
{
    const int step = arc_step(half_width, 0);
    return (2 * quarter_turn - 1 - first_angle(step)) / step + 1;
}

/// The bend between two pieces: where their inner sides end, and the angle between them.
struct StrokeOutline::Bend {
    Side inner;
    Point from;
    Point to;
    std::int32_t cosine; ///< Q30, as the next one
    std::uint32_t rest;  ///< 1 + cosine

    /// Whether the inner sides cross between the ends of both pieces, the shorter of which is `length` long;
    /// the far halves are left to what the other ends may need. They cross |to - from| / 2 / cos(a/2) before
    /// the bend, for a bend by a.
    bool crosses_within(std::uint32_t length, bool is_slight) const
    {
        const Point apart = to - from;
        const std::int32_t gap = rough_length(apart.x.raw(), apart.y.raw());
        const std::int32_t needed = is_slight ? gap + gap / 8 : 2 * gap;
        return cosine >= -one_q30 / 2 && static_cast<std::uint32_t>(needed) <= length;
    }
};

const StrokeOutline::Code StrokeOutline::code{.begin = plain_function<&StrokeOutline::begin_stroke>,
                                              .add = plain_function<&StrokeOutline::add_segment>,
                                              .end = plain_function<&StrokeOutline::end_stroke>};

void emplace_stroke_outline(std::optional<StrokeOutline>& outline, raster::OutlineStore& outlines,
                            const Pen& pen, int coarseness)
{
    outline.emplace(outlines, pen, coarseness);
}

// A single corner on either side will do where a tip is no more than 1/64 px longer than the round of the
// pen, that is half_width (1 - cos) / 4, and the angle below 29 degrees: then slight_meeting() is as near.
StrokeOutline::StrokeOutline(raster::OutlineStore& outlines, const Pen& pen, int coarseness)
    : outlines_{outlines},
      pen_{pen},
      slight_bend_{static_cast<std::int32_t>(
          (1U << 31) /
              std::max<std::uint32_t>(static_cast<std::uint32_t>(pen.half_width.raw()), Fixed::one / 2)
          << 11)},
      arc_step_{arc_step(pen.half_width, coarseness)}
{
}

void StrokeOutline::begin_stroke(Point at)
{
    first_ = last_ = at;
    has_piece_ = false;
    has_tangent_ = false;
    is_at_begin_ = true;
    end_tangent_ = {};
}

void StrokeOutline::add_segment(const Segment& segment, int pieces, const ViewProjection& view)
{
    const bool is_curve = segment.kind == Segment::Kind::cubic;
    if (is_curve && is_at_begin_)
        set_tangent(view(after_begin(segment)) - view(segment.from));
    is_at_begin_ = false;
    flatten(segment, pieces_of_rims(pieces), [&](Point to) { line_to(view(to)); });
    end_tangent_ = is_curve ? view(segment.to) - view(before_end(segment)) : Point{};
}

void StrokeOutline::line_to(Point to)
{
    const Point step = to - last_;
    if (std::max(std::abs(step.x.raw()), std::abs(step.y.raw())) < shortest_step)
        return;
    const Piece piece = piece_along(step);
    if (has_piece_) {
        join(piece);
    } else {
        if (!has_tangent_ || !can_begin_across(first_piece_, piece))
            first_piece_ = piece;
        first_piece_.length = piece.length;
        add(Side::right, last_ + first_piece_.side);
        add(Side::left, last_ - first_piece_.side);
    }
    last_ = to;
    last_piece_ = piece;
    has_piece_ = true;
}

/// The curve begins or ends at the last point in this direction: the stroke is cut across it, and not across
/// a chord, where the chord is long enough.
void StrokeOutline::set_tangent(Point tangent)
{
    if (rough_length(tangent.x.raw(), tangent.y.raw()) < shortest_step)
        return;
    const Piece piece = piece_along(tangent);
    if (!has_piece_) {
        first_piece_ = piece;
        has_tangent_ = true;
    } else if (can_begin_across(piece, last_piece_)) {
        last_piece_.side = piece.side;
    }
}

/// As where sides cross at bends, the far half of the chord is left to its other end.
bool StrokeOutline::can_begin_across(const Piece& tangent, const Piece& chord)
{
    const Point apart = tangent.side - chord.side;
    return 2 * static_cast<std::uint32_t>(rough_length(apart.x.raw(), apart.y.raw())) <= chord.length;
}

void StrokeOutline::end_stroke(bool is_closed)
{
    if (is_closed)
        line_to(first_);
    if (!has_piece_) {
        dot();
        return;
    }
    if (is_closed) {
        last_ = first_;
        join(first_piece_);
        last_piece_ = first_piece_;
    }
    if (!is_closed) {
        set_tangent(end_tangent_);
        return cap_end(), cap_beginning();
    }
    add(Side::right, last_ + last_piece_.side);
    add(Side::left, last_ - last_piece_.side);
    outlines_.close();
}

/// Closes the contour with a cap at its end.
void StrokeOutline::cap_end()
{
    add(Side::right, last_ + last_piece_.side);
    cap(last_, last_piece_.side);
    add(Side::left, last_ - last_piece_.side);
    outlines_.close();
}

/// Adds the cap of the beginning, as a contour of its own.
void StrokeOutline::cap_beginning()
{
    if (pen_.cap == Cap::butt)
        return;
    add(Side::right, first_ - first_piece_.side);
    cap(first_, -first_piece_.side);
    add(Side::right, first_ + first_piece_.side);
    outlines_.close();
}

/// Both pieces have their edges at the seam where the other one has its own, so that there is no line between
/// them; what joins them is part of the last one.
void StrokeOutline::end_after_seam()
{
    seam_piece_ = {};
    if (!has_piece_)
        return;
    seam_piece_ = first_piece_;
    set_tangent(end_tangent_);
    cap_end();
}

void StrokeOutline::end_at_seam()
{
    if (!has_piece_)
        return;
    if (seam_piece_.length == 0)
        return cap_end(), cap_beginning();
    join(seam_piece_);
    last_piece_ = seam_piece_;
    add(Side::right, last_ + last_piece_.side);
    add(Side::left, last_ - last_piece_.side);
    outlines_.close();
    cap_beginning();
}

StrokeOutline::Piece StrokeOutline::piece_along(Point step) const
{
    count_op(Op::pen_piece);
    const auto [direction, length] = to_polar(step);
    const auto half_width_times = [this](std::int32_t unit) {
        return Fixed::from_raw(multiply_q16(pen_.half_width.raw(), 2 * unit));
    };
    return {direction, length, {half_width_times(-direction.y), half_width_times(direction.x)}};
}

/// Tips, and sides of strokes at the border of the range, would be further out than Fixed can subtract.
void StrokeOutline::add(Side side, Point at)
{
    const raster::Corner corner = raster::corner_at({held_on_panel(at.x), held_on_panel(at.y)});
    if (side == Side::right)
        outlines_.add(corner);
    else
        outlines_.add_behind(corner);
}

void StrokeOutline::join(const Piece& after)
{
    const Piece& before = last_piece_;
    const std::int32_t cosine =
        std::clamp(cosine_between(before.direction, after.direction), -one_q30, one_q30);
    const std::int32_t sine = sine_between(before.direction, after.direction);
    if (sine == 0 && cosine > 0)
        return;
    const bool turns_right = sine >= 0;
    const Bend bend{.inner = turns_right ? Side::right : Side::left,
                    .from = turns_right ? before.side : -before.side,
                    .to = turns_right ? after.side : -after.side,
                    .cosine = cosine,
                    .rest = rest_of_turn(before.direction, after.direction, cosine)};
    const bool is_slight = cosine >= one_q30 - slight_bend_;
    const bool sides_meet = bend.crosses_within(std::min(before.length, after.length), is_slight);
    const bool has_tip = is_slight || has_miter(bend.rest);
    Point tip;
    if (is_slight)
        tip = slight_meeting(bend.from, bend.to, one_q30 - cosine);
    else if (sides_meet || has_tip)
        tip = meeting(bend.from, bend.to, bend.rest);
    count_op(is_slight ? Op::slight_bend : Op::bend);
    if (sides_meet)
        add(bend.inner, last_ + tip);
    else
        add_pivot(bend);
    if (has_tip)
        add(opposite(bend.inner), last_ - tip);
    else
        add_outer(bend);
}

/// Where the inner sides do not meet, the inner side goes through the corner itself: then every part of the
/// outline turns in the same direction, however short the pieces are.
void StrokeOutline::add_pivot(const Bend& bend)
{
    add(bend.inner, last_ + bend.from);
    add(bend.inner, last_);
    add(bend.inner, last_ + bend.to);
}

void StrokeOutline::add_outer(const Bend& bend)
{
    const Side outer = opposite(bend.inner);
    add(outer, last_ - bend.from);
    if (pen_.join == Join::round)
        arc(outer, last_, -bend.from, turned(last_piece_.side), bend.cosine);
    add(outer, last_ - bend.to);
}

/// A miter is 1 / cos(a/2) half widths long, for a bend by a, and 2 cos^2(a/2) is 1 + cos(a). Its tip
/// stays in the range of Fixed: corners are within 16383 px.
bool StrokeOutline::has_miter(std::uint32_t rest) const
{
    if (pen_.join != Join::miter)
        return false;
    const auto limit = static_cast<std::uint32_t>(pen_.miter_limit);
    const auto pixels = static_cast<std::uint32_t>(pen_.half_width.raw() >> 16);
    return (rest >> 15) * limit * limit >= 128U << 15 && pixels * pixels <= rest >> 15 << 12;
}

/// Adds the corners between `from` and the end of an arc, towards `ahead`. They are beyond the circle by 2/3
/// of what it rises above its chords, r a^2 / 8 for chords over the angle a: the chords enclose its area.
void StrokeOutline::arc(Side side, Point centre, Point from, Point ahead, std::int32_t cosine)
{
    constexpr std::int32_t beyond_of_step = 3; // (pi / 96)^2 / 12, in Q15
    const std::int32_t beyond = beyond_of_step * arc_step_ * arc_step_;
    from = from + scaled(from, beyond);
    ahead = ahead + scaled(ahead, beyond);
    for (int angle = first_angle(arc_step_);
         angle < 2 * quarter_turn && cosine_q15(angle) * (1 << 15) > cosine; angle += arc_step_)
        add(side, centre + scaled(from, cosine_q15(angle)) + scaled(ahead, sine_q15(angle)));
}

/// Adds the corners between the right and the left end of a stroke that ends at `at`.
void StrokeOutline::cap(Point at, Point side)
{
    const Point ahead = turned(side);
    if (pen_.cap == Cap::round) {
        arc(Side::right, at, side, ahead, -one_q30);
    } else if (pen_.cap == Cap::square) {
        add(Side::right, at + side + ahead);
        add(Side::right, at - side + ahead);
    }
}

/// Draws a stroke without length: a disc or a square, as in SVG.
void StrokeOutline::dot()
{
    if (pen_.cap == Cap::butt)
        return;
    for (const Point side : {Point{{}, pen_.half_width}, Point{{}, -pen_.half_width}}) {
        add(Side::right, first_ + side);
        cap(first_, side);
    }
    outlines_.close();
}

}
