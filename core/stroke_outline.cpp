#include "core/stroke_outline.hpp"

#include "core/corner_at.hpp"
#include "core/flatten.hpp"
#include "core/work.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>

namespace kfast {
namespace {

constexpr std::int32_t shortest_step = Fixed::one / 256;
constexpr std::int32_t one_q30 = 1 << 30;

/// sin(i / 48 of a quarter turn) in Q15.
constexpr std::array<std::uint16_t, 49> sines{
    0,     1072,  2143,  3212,  4277,  5338,  6393,  7441,  8481,  9512,  10533, 11543, 12540,
    13524, 14493, 15447, 16384, 17304, 18205, 19087, 19948, 20788, 21605, 22400, 23170, 23916,
    24636, 25330, 25997, 26635, 27246, 27827, 28378, 28899, 29389, 29847, 30274, 30668, 31029,
    31357, 31651, 31912, 32138, 32330, 32488, 32610, 32698, 32750, 32768};
constexpr int quarter_turn = 48;

std::int32_t sine_q15(int angle)
{
    return sines[static_cast<std::size_t>(angle <= quarter_turn ? angle : 2 * quarter_turn - angle)];
}

std::int32_t cosine_q15(int angle)
{
    return angle <= quarter_turn ? sine_q15(quarter_turn - angle) : -sine_q15(angle - quarter_turn);
}

/// The widest step in 1/48 quarter turn with which arcs stay within `flatness`. A chord over the angle a of a
/// circle of radius r stays within r (1 - cos(a/2)), about r a^2 / 8; of pens wider than 600 px it is more.
int arc_step(Fixed half_width, int coarseness)
{
    constexpr std::array<std::uint8_t, 10> pieces{1, 2, 3, 4, 6, 8, 12, 16, 24, 48}; // of a quarter turn
    constexpr std::int32_t radius_of_one = flatness.raw() * 16 / 5;                  // 32 / pi^2
    const std::int32_t radius = half_width.raw() >> 2 * coarseness;
    std::size_t chosen = 0;
    while (chosen + 1 < pieces.size() && pieces[chosen] * pieces[chosen] * radius_of_one < radius)
        ++chosen;
    return quarter_turn / pieces[chosen];
}

Point scaled(Point vector, std::int32_t factor_q15)
{
    return {Fixed::from_raw(multiply_q16(vector.x.raw(), 2 * factor_q15)),
            Fixed::from_raw(multiply_q16(vector.y.raw(), 2 * factor_q15))};
}

/// A quarter turn from the right of a heading, or from the left of its opposite.
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

/// Likewise for any bend; `rest` is 1 + cos, in Q30, 2^21 or more.
Point meeting(Point a, Point b, std::uint32_t rest)
{
    const int zeros = std::countl_zero(rest);
    const auto factor = static_cast<std::int32_t>((1U << 31) / (rest << zeros >> 16));
    const auto of = [&](Fixed p, Fixed q) {
        return Fixed::from_raw(multiply((p + q).raw(), factor, 17 - zeros));
    };
    return {of(a.x, b.x), of(a.y, b.y)};
}

}

struct StrokeOutline::Bend {
    Point at;
    const Piece& before;
    const Piece& after;
    std::int32_t cosine; ///< Q30, as the next one
    std::int32_t sine;
    std::uint32_t rest; ///< 1 + cosine

    Bend(Point where, const Piece& from, const Piece& to)
        : at{where}, before{from}, after{to}, cosine{std::clamp(from.heading.x * to.heading.x +
                                                                    from.heading.y * to.heading.y,
                                                                -one_q30, one_q30)},
          sine{from.heading.x * to.heading.y - from.heading.y * to.heading.x}, rest{rest_of()}
    {
    }

    Side inner() const { return sine >= 0 ? Side::right : Side::left; }
    Side outer() const { return sine >= 0 ? Side::left : Side::right; }
    Point inner_before() const { return sine >= 0 ? before.side : -before.side; }
    Point inner_after() const { return sine >= 0 ? after.side : -after.side; }
    Point tip() const { return meeting(inner_before(), inner_after(), rest); }

    /// Where the inner sides meet lies between the ends of both pieces, and the far halves are left to what
    /// the other ends may need. They meet |after - before| / 2 / cos(a/2) before the bend, for a turn by a.
    bool is_roomy(bool is_slight) const
    {
        const Point apart = after.side - before.side;
        const std::int32_t across = rough_length(apart.x.raw(), apart.y.raw());
        const std::int32_t needed = is_slight ? across + across / 8 : across * 2;
        return static_cast<std::uint32_t>(needed) <= std::min(before.length, after.length);
    }

private:
    /// Near a full turn back the cosine is too coarse; 1 + cos is half the square of the sum of the vectors.
    std::uint32_t rest_of() const
    {
        if (cosine >= 0)
            return static_cast<std::uint32_t>(one_q30) + static_cast<std::uint32_t>(cosine);
        const auto x = static_cast<std::uint32_t>(before.heading.x + after.heading.x);
        const auto y = static_cast<std::uint32_t>(before.heading.y + after.heading.y);
        return (x * x + y * y) / 2;
    }
};

// A single corner on either side will do where a tip is no more than 1/64 px longer than the round of the
// pen, that is half_width (1 - cos) / 4, and the turn less than 29 degrees: then slight_meeting() is as near.
StrokeOutline::StrokeOutline(OutlineStore& outlines, const Pen& pen, int coarseness)
    : outlines_{outlines}, pen_{pen}, slight_bend_{static_cast<std::int32_t>(
                                          (1U << 31) / std::max<std::uint32_t>(
                                                           static_cast<std::uint32_t>(pen.half_width.raw()),
                                                           Fixed::one / 2)
                                          << 11)},
      arc_step_{arc_step(pen.half_width, coarseness)}
{
}

void StrokeOutline::begin(Point at)
{
    first_ = last_ = at;
    has_piece_ = false;
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
        first_piece_ = piece;
        add(Side::right, last_ + piece.side);
        add(Side::left, last_ - piece.side);
    }
    last_ = to;
    last_piece_ = piece;
    has_piece_ = true;
}

void StrokeOutline::end(bool is_closed)
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
    add(Side::right, last_ + last_piece_.side);
    if (!is_closed)
        cap(last_, last_piece_.side);
    add(Side::left, last_ - last_piece_.side);
    outlines_.close();
    if (is_closed || pen_.cap == Cap::butt)
        return;
    add(Side::right, first_ - first_piece_.side);
    cap(first_, -first_piece_.side);
    add(Side::right, first_ + first_piece_.side);
    outlines_.close();
}

StrokeOutline::Piece StrokeOutline::piece_along(Point step) const
{
    did(Work::pen_piece);
    const auto [heading, length] = stride_along(step);
    const auto half_width_times = [this](std::int32_t unit) {
        return Fixed::from_raw(multiply_q16(pen_.half_width.raw(), 2 * unit));
    };
    return {heading, length, {half_width_times(-heading.y), half_width_times(heading.x)}};
}

void StrokeOutline::add(Side side, Point at)
{
    if (side == Side::right)
        outlines_.add(corner_at(at));
    else
        outlines_.add_behind(corner_at(at));
}

void StrokeOutline::join(const Piece& after)
{
    const Bend bend{last_, last_piece_, after};
    if (bend.sine == 0 && bend.cosine > 0)
        return;
    if (bend.cosine >= one_q30 - slight_bend_ && bend.is_roomy(true)) {
        const Point tip = slight_meeting(last_piece_.side, after.side, one_q30 - bend.cosine);
        add(Side::right, last_ + tip);
        add(Side::left, last_ - tip);
        return;
    }
    add_inner(bend);
    add_outer(bend);
}

/// Where the inner sides do not meet, the inner side goes through the corner itself: then every part of the
/// outline turns the same way, however short the pieces are.
void StrokeOutline::add_inner(const Bend& bend)
{
    did(Work::bend);
    const Side side = bend.inner();
    if (bend.cosine >= -one_q30 / 2 && bend.is_roomy(false)) {
        add(side, bend.at + bend.tip());
        return;
    }
    add(side, bend.at + bend.inner_before());
    add(side, bend.at);
    add(side, bend.at + bend.inner_after());
}

void StrokeOutline::add_outer(const Bend& bend)
{
    const Side side = bend.outer();
    if (has_miter(bend)) {
        add(side, bend.at - bend.tip());
        return;
    }
    const Point from = -bend.inner_before();
    add(side, bend.at + from);
    if (pen_.join == Join::round)
        arc(side, bend.at, from, turned(bend.before.side), bend.cosine);
    add(side, bend.at - bend.inner_after());
}

/// A miter is 1 / cos(a/2) half widths long, for a turn by a, and 2 cos^2(a/2) is 1 + cos(a). Its tip stays
/// where Fixed can hold it: corners are within 16383 px.
bool StrokeOutline::has_miter(const Bend& bend) const
{
    if (pen_.join != Join::miter)
        return false;
    const auto limit = static_cast<std::uint32_t>(pen_.miter_limit);
    const auto pixels = static_cast<std::uint32_t>(pen_.half_width.raw() >> 16);
    return (bend.rest >> 15) * limit * limit >= 128U << 15 && pixels * pixels <= bend.rest >> 15 << 12;
}

/// The corners between `from` and the end of a turn, towards `ahead`.
void StrokeOutline::arc(Side side, Point centre, Point from, Point ahead, std::int32_t cosine)
{
    for (int angle = arc_step_; angle < 2 * quarter_turn && cosine_q15(angle) * (1 << 15) > cosine;
         angle += arc_step_)
        add(side, centre + scaled(from, cosine_q15(angle)) + scaled(ahead, sine_q15(angle)));
}

/// The corners between the right and the left end of a stroke that ends at `at`.
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

/// A stroke without length: a disc or a square, as in SVG.
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
