#include "core/beam/beam_pen.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace kfast {
namespace {

/// Lines are cut at a square that is centred on (0, 0). What is on its far borders is clamped to the
/// field, a unit nearer.
constexpr std::int32_t border = field_side / 2;

/// Corners within 1/16 px, the precision of curves, can be merged.
constexpr int merging_bits = 4;

FieldPoint clamped(std::int32_t x, std::int32_t y)
{
    return {static_cast<std::int16_t>(std::min(x, field_max)),
            static_cast<std::int16_t>(std::min(y, field_max))};
}

}

bool BeamPen::Place::is_in_field() const
{
    return x >= -border && x <= border && y >= -border && y <= border;
}

BeamPen::BeamPen(BeamLines& lines, const ViewProjection& view, int resolution, BeamInk ink, Colour colour,
                 std::uint32_t item)
    : lines_{lines},
      view_{view},
      shift_{static_cast<int>(std::bit_width(static_cast<unsigned>(resolution))) - 2},
      merging_{view.coarseness() == 0 ? 0 : (field_side / resolution >> merging_bits) << view.coarseness()},
      ink_{ink},
      colour_{colour},
      item_{item}
{
}

void BeamPen::begin(Point from)
{
    first_ = last_ = place(view_(from));
    skipped_.reset();
    is_cut_ = !first_.is_in_field();
    if (!is_cut_)
        add_point(first_);
}

void BeamPen::add(const Segment& segment)
{
    flatten(segment, view_.pieces_of(segment), [this](Point to) { line_to(place(view_(to))); });
}

void BeamPen::end(Point, bool is_closed)
{
    if (is_closed || ink_ == BeamInk::outline)
        line_to(first_);
    end_stroke();
}

void BeamPen::end_part() { end_stroke(); }

/// Pieces at a seam go on in each other; what closes both, for the border of a fill, is drawn apart.
void BeamPen::end_piece(Point hub, PieceEnd end)
{
    if (end == PieceEnd::open || end == PieceEnd::closed)
        return this->end(hub, end == PieceEnd::closed);
    const Place start = first_;
    end_stroke();
    if (end == PieceEnd::after_seam || ink_ != BeamInk::outline)
        return;
    begin(hub);
    line_to(start);
    end_stroke();
}

/// In pixels the origin is the upper left corner of the field.
BeamPen::Place BeamPen::place(Point seen) const
{
    const auto units = [this](Fixed pixels) { return ((pixels.raw() >> shift_) + 1) >> 1; };
    return {units(seen.x) - border, border - units(seen.y)};
}

bool BeamPen::is_near_last(Place to) const
{
    return std::abs(to.x - last_.x) < merging_ && std::abs(to.y - last_.y) < merging_;
}

void BeamPen::line_to(Place to)
{
    skipped_.reset();
    if (is_near_last(to))
        skipped_ = to;
    else
        move_to(to);
}

void BeamPen::move_to(Place to)
{
    if (is_drawing_ && to.is_in_field())
        add_point(to);
    else
        add_cut(to);
    last_ = to;
}

/// Adds the part in the field of a line that is not wholly in it.
void BeamPen::add_cut(Place to)
{
    const bool leaves = !to.is_in_field();
    is_cut_ = true;
    if (is_outside_one_side(last_, to))
        return;
    const std::optional<Place> begin = is_drawing_ ? last_ : crossing(last_, to);
    if (!begin)
        return;
    add_point(*begin);
    add_point(leaves ? *crossing(to, last_) : to);
    if (leaves)
        end_line();
}

bool BeamPen::is_outside_one_side(Place a, Place b)
{
    return (a.x < -border && b.x < -border) || (a.x > border && b.x > border) ||
           (a.y < -border && b.y < -border) || (a.y > border && b.y > border);
}

/// Where the line from a place outside to another enters the field. They are not both beyond one side of it.
std::optional<BeamPen::Place> BeamPen::crossing(Place outside, Place other)
{
    const std::int32_t side_x = std::clamp(outside.x, -border, border);
    if (side_x != outside.x)
        if (const auto y = crossing(side_x, outside, other))
            return Place{side_x, *y};
    const std::int32_t side_y = std::clamp(outside.y, -border, border);
    if (side_y != outside.y)
        if (const auto x = crossing(side_y, {outside.y, outside.x}, {other.y, other.x}))
            return Place{*x, side_y};
    return std::nullopt;
}

/// y where the line between two places crosses x = `at`, if it does so within the field. Places are within
/// 2^26, so that twice a product of differences fits in 64 bits.
std::optional<std::int32_t> BeamPen::crossing(std::int32_t at, Place from, Place to)
{
    if (from.x > to.x)
        std::swap(from, to);
    const std::int64_t width = to.x - from.x;
    const std::int64_t rise = std::int64_t{to.y - from.y} * (at - from.x);
    if (rise < (-border - from.y) * width || rise > (border - from.y) * width)
        return std::nullopt;
    const std::int64_t doubled = 2 * rise + width; // halves up
    const std::int64_t whole = doubled / (2 * width) - (doubled % (2 * width) < 0 ? 1 : 0);
    return from.y + static_cast<std::int32_t>(whole);
}

void BeamPen::add_point(Place at)
{
    if (!is_drawing_)
        lines_.begin(colour_, item_);
    is_drawing_ = true;
    lines_.add(clamped(at.x, at.y));
}

void BeamPen::end_stroke()
{
    if (skipped_)
        move_to(*skipped_);
    if (is_drawing_)
        end_line();
}

/// A line that touches the border from outside, or is cut there at its end, is no dot.
void BeamPen::end_line()
{
    is_drawing_ = false;
    const bool can_be_dot = ink_ == BeamInk::stroke && !is_cut_;
    if (can_be_dot || lines_.open_points() > 1)
        lines_.end();
    else
        lines_.drop();
}

}
