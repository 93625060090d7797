#include "core/math/stroke_trimmer.hpp"

#include "core/bytes/op_counter.hpp"
#include "core/math/angle.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace kfast {
namespace {

constexpr std::uint32_t max_length = std::numeric_limits<std::uint32_t>::max();

/// In 1/4096 px, within 1/4096 px and 1/10^7 of it. With the direction d, nearly a unit vector, the length of
/// s is s d / |d|; an error in the angle of d counts by its square.
std::uint32_t distance(Point from, Point to)
{
    const Point step = to - from;
    if (step == Point{})
        return 0;
    count_op(Op::pen_piece);
    const Direction along = to_polar(step).direction;
    const auto across =
        static_cast<std::uint32_t>(multiply_q16(step.x.raw(), 2 * along.x)); // neither below 0
    const auto down = static_cast<std::uint32_t>(multiply_q16(step.y.raw(), 2 * along.y));
    const auto projected = static_cast<std::int32_t>(rounded_shift(across + down, 4));
    const std::int32_t excess = along.x * along.x + along.y * along.y - one_q30; // 2^30 (|d|^2 - 1)
    return static_cast<std::uint32_t>(projected - multiply(projected, excess, 31));
}

std::uint32_t sum(std::uint32_t a, std::uint32_t b) { return a > max_length - b ? max_length : a + b; }

std::uint64_t share_of(std::uint32_t length, std::uint64_t share)
{
    return (length * share + Trim::whole / 2) >> 24;
}

}

Trim Trim::between(std::int32_t from, std::int32_t to, std::int32_t offset, TrimMode mode)
{
    const auto clamped = [](std::int32_t part) {
        return static_cast<std::uint32_t>(std::clamp<std::int32_t>(part, 0, whole));
    };
    const std::uint32_t begin = std::min(clamped(from), clamped(to));
    const std::uint32_t end = std::max(clamped(from), clamped(to));
    return {
        .begin = (begin + static_cast<std::uint32_t>(offset)) % whole, .share = end - begin, .mode = mode};
}

const StrokeTrimmer::Code StrokeTrimmer::code{.begin = plain_function<&StrokeTrimmer::begin_stroke>,
                                              .add = plain_function<&StrokeTrimmer::take>,
                                              .end = plain_function<&StrokeTrimmer::end_stroke>};

StrokeTrimmer::StrokeTrimmer(const Trim& trim, const Affine& placement, PieceSink sink)
    : trim_{trim}, place_{placement}, sink_{sink}
{
}

void StrokeTrimmer::run(FunctionRef<void(StrokeTrimmer&)> trace)
{
    const auto trace_for = [&](Pass pass) {
        pass_ = pass;
        stroke_ = 0;
        trace(*this);
    };
    if (trim_.mode == TrimMode::together)
        trace_for(Pass::measure_all);
    do {
        measured_ = {};
        trace_for(Pass::measure);
        trace_for(Pass::cut);
        first_ += batch;
    } while (first_ < stroke_);
}

void StrokeTrimmer::begin_stroke(Point at)
{
    start_ = curve_start_ = curve_end_ = at;
    if (pass_ != Pass::cut || !is_in_batch())
        return;
    position_ = 0;
    window_ = 0;
    is_drawing_ = false;
    set_windows();
    if (is_whole_)
        sink_.begin(place_(at));
}

void StrokeTrimmer::take(const Segment& segment)
{
    if (!is_in_batch() && pass_ != Pass::measure_all)
        return;
    if (pass_ == Pass::cut)
        return is_whole_ ? sink_.add(placed(segment)) : cut(segment);
    const std::uint32_t length = length_of(segment);
    if (pass_ == Pass::measure_all) {
        total_ = sum(total_, length);
        return;
    }
    if (length == 0)
        return;
    if (measured().length == 0)
        curve_start_ = segment.from;
    curve_end_ = segment.to;
    measured().length = sum(measured().length, length);
}

void StrokeTrimmer::end_stroke(Point hub, bool is_closed)
{
    if (is_in_batch() && pass_ == Pass::measure)
        measured().is_closed = trim_.mode == TrimMode::sector ? curve_start_ == curve_end_ : is_closed;
    if (is_in_batch() && pass_ == Pass::cut) {
        if (is_whole_)
            sink_.end(place_(hub), is_closed ? PieceEnd::closed : PieceEnd::open);
        before_ = sum(before_, measured().length);
    }
    ++stroke_;
}

/// The lines of a sector lead to its curves, whatever is left of them.
bool StrokeTrimmer::has_no_length(const Segment& segment) const
{
    return trim_.mode == TrimMode::sector && segment.kind == Segment::Kind::line;
}

/// What is drawn of the current stroke.
void StrokeTrimmer::set_windows()
{
    const std::uint32_t length = measured().length;
    const bool is_together = trim_.mode == TrimMode::together;
    const std::uint32_t all = is_together ? total_ : length;
    const std::uint64_t end = std::uint64_t{trim_.begin} + trim_.share;
    window_count_ = 0;
    if (end > Trim::whole)
        add_window(0, share_of(all, end - Trim::whole));
    add_window(share_of(all, trim_.begin), share_of(all, std::min<std::uint64_t>(end, Trim::whole)));
    const Window& first = windows_.front();
    const Window& last = windows_[window_count_ == 2 ? 1 : 0];
    is_whole_ = length == 0 ? window_count_ != 0 || !is_together
                            : window_count_ == 1 && first.begin == 0 && first.end == length;
    crosses_seam_ = window_count_ == 2 && measured().is_closed && first.begin == 0 && last.end == length;
}

/// Adds the part of it that is on the current stroke.
void StrokeTrimmer::add_window(std::uint64_t begin, std::uint64_t end)
{
    const std::uint32_t length = measured().length;
    const std::uint32_t before = trim_.mode == TrimMode::together ? before_ : 0;
    const auto within = [&](std::uint64_t at) {
        return static_cast<std::uint32_t>(at <= before ? 0 : std::min<std::uint64_t>(at - before, length));
    };
    const Window window{within(begin), within(end)};
    if (window.begin < window.end)
        windows_[window_count_++] = window;
    else if (length == 0 && begin <= before && before < end) // a dot
        windows_[window_count_++] = {};
}

/// Half as many again as are drawn, or more: what chords lack of narrow bends adds up along a stroke.
int StrokeTrimmer::pieces_of(const Segment& segment) const
{
    if (segment.kind == Segment::Kind::line)
        return 1;
    const int pieces = sink_.pieces_of(placed(segment));
    const int more = pieces + pieces / 2;
    if (more <= max_steps)
        return more;
    return std::min(2 * std::max(pieces, max_steps), max_pieces);
}

/// Passes the lengths of the straight pieces that replace a segment.
void StrokeTrimmer::each_chord(const Segment& segment, FunctionRef<void(std::uint32_t length)> take) const
{
    Point last = segment.from;
    flatten(segment, pieces_of(segment), [&](Point to) {
        take(distance(last, to));
        last = to;
    });
}

std::uint32_t StrokeTrimmer::length_of(const Segment& segment) const
{
    std::uint32_t length = 0;
    if (!has_no_length(segment))
        each_chord(segment, [&](std::uint32_t chord) { length = sum(length, chord); });
    return length;
}

/// The parameter at which a segment is as long as wanted, which is less than its length.
Fraction StrokeTrimmer::fraction_at(const Segment& segment, std::uint32_t wanted) const
{
    std::uint32_t pieces = 0;
    std::uint32_t whole_pieces = 0;
    Fraction rest; // of the piece after these
    each_chord(segment, [&](std::uint32_t chord) {
        if (whole_pieces == pieces && wanted >= chord) {
            wanted -= chord;
            ++whole_pieces;
        } else if (whole_pieces == pieces) {
            rest = Fraction::ratio(wanted, chord);
        }
        ++pieces;
    });
    return {std::min((whole_pieces * Fraction::one + rest.raw) / pieces, Fraction::one)};
}

Segment StrokeTrimmer::placed(const Segment& segment) const
{
    Segment result{.kind = segment.kind, .from = place_(segment.from), .to = place_(segment.to)};
    if (segment.kind == Segment::Kind::cubic) {
        result.c1 = place_(segment.c1);
        result.c2 = place_(segment.c2);
    }
    return result;
}

void StrokeTrimmer::cut(const Segment& segment)
{
    if (has_no_length(segment))
        return;
    const std::uint32_t length = length_of(segment);
    Fraction begin;
    while (window_ < window_count_) {
        const Window& window = windows_[window_];
        const std::uint32_t left = (is_drawing_ ? window.end : window.begin) - position_;
        if (is_drawing_ ? left > length : left >= length)
            break;
        const Fraction at = left == 0        ? Fraction{}
                            : left == length ? Fraction{Fraction::one}
                                             : fraction_at(segment, left);
        if (is_drawing_) {
            go_on(segment, length, begin, at, true);
            end_piece();
        } else {
            begin_piece(point_at(segment, at));
        }
        begin = at;
    }
    if (is_drawing_)
        go_on(segment, length, begin, {Fraction::one}, false);
    position_ += length;
}

void StrokeTrimmer::begin_piece(Point at)
{
    const Point placed = place_(at);
    is_drawing_ = is_at_beginning_ = true;
    if (trim_.mode == TrimMode::sector && !crosses_seam_) {
        sink_.begin(last_ = place_(start_));
        piece_start_ = last_;
        return line_to(placed);
    }
    if (trim_.mode == TrimMode::sector && window_ == 1)
        return line_to(placed); // from the centre
    sink_.begin(placed);
    piece_start_ = last_ = placed;
}

/// Draws the part of a segment, which is so long, between two shares of its parameter. Where a piece begins
/// or ends within a curve, a quarter of a pixel is apart, so that caps stand across the curve and not across
/// a long chord.
void StrokeTrimmer::go_on(const Segment& segment, std::uint32_t length, Fraction begin, Fraction end,
                          bool ends)
{
    const bool begins = std::exchange(is_at_beginning_, false);
    constexpr std::uint32_t tip_length = 1024; // in 1/4096 px
    if (segment.kind == Segment::Kind::cubic && length > tip_length) {
        const std::uint32_t tip = Fraction::ratio(tip_length, length).raw;
        if (begins && begin.raw + tip < end.raw) {
            add(segment, begin, {begin.raw + tip});
            begin.raw += tip;
        }
        if (ends && begin.raw + tip < end.raw) {
            add(segment, begin, {end.raw - tip});
            begin.raw = end.raw - tip;
        }
    }
    add(segment, begin, end);
}

void StrokeTrimmer::add(const Segment& segment, Fraction begin, Fraction end)
{
    if (begin == end)
        return;
    const bool is_all = begin.raw == 0 && end.raw == Fraction::one;
    Segment part = placed(is_all ? segment : subsegment(segment, begin, end));
    part.from = last_;
    sink_.add(part);
    last_ = part.to;
}

void StrokeTrimmer::line_to(Point to)
{
    sink_.add({.from = last_, .to = to});
    last_ = to;
}

void StrokeTrimmer::end_piece()
{
    is_drawing_ = false;
    const bool is_first = window_++ == 0;
    if (trim_.mode == TrimMode::sector) {
        if (is_first || !crosses_seam_)
            line_to(place_(start_));
        if (!is_first || !crosses_seam_)
            sink_.end(piece_start_, PieceEnd::closed);
        return;
    }
    if (!crosses_seam_)
        return sink_.end(piece_start_, PieceEnd::open);
    if (is_first)
        first_piece_end_ = last_;
    sink_.end(is_first ? piece_start_ : first_piece_end_,
              is_first ? PieceEnd::after_seam : PieceEnd::at_seam);
}

}
