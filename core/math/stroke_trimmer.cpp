#include "core/math/stroke_trimmer.hpp"

#include "core/bytes/op_counter.hpp"
#include "core/math/angle.hpp"

#include <algorithm>
#include <limits>

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
        else if (is_drawing_)
            end_piece();
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
    windows_ = {};
    window_count_ = 0;
    if (end > Trim::whole)
        add_window(0, share_of(all, end - Trim::whole));
    add_window(share_of(all, trim_.begin), share_of(all, std::min<std::uint64_t>(end, Trim::whole)));
    const Window& first = windows_.front();
    const Window& last = windows_[window_count_ == 2 ? 1 : 0];
    const bool reaches_both_ends = window_count_ != 0 && first.begin == 0 && last.end == length;
    is_whole_ = length == 0 ? window_count_ != 0 || !is_together : window_count_ == 1 && reaches_both_ends;
    crosses_seam_ = window_count_ == 2 && measured().is_closed && reaches_both_ends;
    pattern_begins_ = {crosses_seam_ ? last.end - last.begin : 0, 0};
    is_dashed_ = length != 0 && trim_.dashes.count != 0 && dashes_ < trim_.dashes.max;
    begin_window();
    if (is_dashed_)
        look_at_ends(reaches_both_ends);
    next_part();
}

void StrokeTrimmer::begin_window()
{
    dash_begin_ = windows_[window_].begin;
    dash_ = is_dashed_ ? trim_.dashes.at(pattern_begins_[window_]) : Dashes::Place{0, max_length};
}

/// Whether a dash goes on across the seam, or is all there is.
void StrokeTrimmer::look_at_ends(bool reaches_both_ends)
{
    const std::size_t last = window_count_ == 2 ? 1 : 0;
    const std::uint32_t end = pattern_begins_[last] + (windows_[last].end - windows_[last].begin);
    is_whole_ = is_whole_ && dash_.is_dash() && dash_.left >= measured().length;
    crosses_seam_ =
        reaches_both_ends && measured().is_closed && dash_.is_dash() && trim_.dashes.is_drawn_before(end);
}

/// Looks for what is drawn next of the current stroke.
void StrokeTrimmer::next_part()
{
    while (!(has_part_ = next_dash(windows_[window_])) && window_ + 1 < window_count_) {
        ++window_;
        begin_window();
    }
}

/// Whether there is one in the rest of the window. The last one that an object may have takes all of it, as
/// the only one of what is not dashed does. A whole pattern in which nothing is drawn is the last.
bool StrokeTrimmer::next_dash(const Window& window)
{
    for (std::uint32_t i = 0; dash_begin_ < window.end && i <= Dashes::max_lengths; ++i) {
        const bool is_drawn = dash_.is_dash() && dash_.left != 0;
        const bool is_last = is_drawn && dashes_ >= trim_.dashes.max;
        const std::uint32_t rest = window.end - dash_begin_;
        part_ = {dash_begin_, dash_begin_ + (is_last ? rest : std::min(dash_.left, rest))};
        dash_begin_ = part_.end;
        if (is_dashed_) {
            dashes_ += is_drawn ? 1 : 0;
            dash_.index = (dash_.index + 1) % trim_.dashes.count;
            dash_.left = trim_.dashes.lengths[dash_.index];
        }
        if (is_drawn)
            return true;
    }
    return false;
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

Segment StrokeTrimmer::placed(const Segment& segment) const
{
    Segment result{.kind = segment.kind, .from = place_(segment.from), .to = place_(segment.to)};
    if (segment.kind == Segment::Kind::cubic) {
        result.c1 = place_(segment.c1);
        result.c2 = place_(segment.c2);
    }
    return result;
}

/// Walks along its chords, and draws between the borders of parts that lie on them.
void StrokeTrimmer::cut(const Segment& segment)
{
    if (has_no_length(segment))
        return;
    ChordPlace place{.chords = static_cast<std::uint32_t>(pieces_of(segment))};
    each_chord(segment, [&](std::uint32_t chord) { cut_chord(segment, chord, place); });
    if (is_drawing_)
        add(segment, place.begin, {Fraction::one});
}

void StrokeTrimmer::cut_chord(const Segment& segment, std::uint32_t chord, ChordPlace& place)
{
    while (has_part_) {
        const std::uint32_t left = (is_drawing_ ? part_.end : part_.begin) - position_;
        if (is_drawing_ ? left > chord : left >= chord)
            break;
        const Fraction rest = left == 0 ? Fraction{} : Fraction::ratio(left, chord);
        const Fraction at{std::min((place.number * Fraction::one + rest.raw) / place.chords, Fraction::one)};
        if (is_drawing_) {
            add(segment, place.begin, at);
            end_piece();
        } else {
            begin_piece(point_at(segment, at));
        }
        place.begin = at;
    }
    position_ += chord;
    ++place.number;
}

void StrokeTrimmer::begin_piece(Point at)
{
    const Point placed = place_(at);
    is_drawing_ = true;
    if (trim_.mode == TrimMode::sector && !crosses_seam_) {
        sink_.begin(last_ = place_(start_));
        piece_start_ = last_;
        return line_to(placed);
    }
    if (trim_.mode == TrimMode::sector && part_.begin != 0)
        return line_to(placed); // from the centre
    sink_.begin(placed);
    piece_start_ = last_ = placed;
}

/// Draws the part of a segment between two shares of its parameter.
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
    const bool is_behind_seam = crosses_seam_ && part_.begin == 0;
    const bool is_before_seam = crosses_seam_ && part_.end == measured().length;
    next_part();
    if (trim_.mode == TrimMode::sector) {
        if (!is_before_seam)
            line_to(place_(start_));
        if (!is_behind_seam)
            sink_.end(piece_start_, PieceEnd::closed);
        return;
    }
    if (is_behind_seam)
        first_piece_end_ = last_;
    sink_.end(is_before_seam ? first_piece_end_ : piece_start_, is_behind_seam   ? PieceEnd::after_seam
                                                                : is_before_seam ? PieceEnd::at_seam
                                                                                 : PieceEnd::open);
}

}
