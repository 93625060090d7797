#pragma once

#include "core/bytes/function_ref.hpp"
#include "core/bytes/op_counter.hpp"
#include "core/math/fixed.hpp"
#include "core/scene/drawing_view.hpp"

#include <algorithm>
#include <cstdint>

/// Two key drawings with different numbers of strokes and points, walked side by side as if they had the
/// same.
///
/// The rules are those of KFAST (C. M. Lever, Amiga, about 1992); core/pose/README.md has them with a worked
/// example. Nothing is copied: each drawing is read once, beside an empty one twice, and points are added as
/// they are asked for.
namespace kfast {

/// One of the two drawings, its strokes broken into as many parts as the partner has strokes.
template <DrawingReader R>
class BrokenDrawing {
public:
    /// `make(is_second)` returns the drawing, unread: so it is made in place, without a copy.
    BrokenDrawing(FunctionRef<R(bool)> make, bool is_second, std::uint32_t partner_strokes)
        : reader_{make(is_second)},
          strokes_{reader_.strokes()},
          parts_{std::max(partner_strokes, strokes_), std::max<std::uint32_t>(strokes_, 1)}
    {
    }

    /// The parts of the whole drawing.
    std::uint32_t parts() const { return parts_.each * strokes_ + parts_.extra; }

    /// Begins the next part and returns the number of its segments, at least 1.
    std::uint32_t next_part()
    {
        if (part_ == stroke_parts_)
            begin_stroke();
        if (is_whole()) {
            part_ = 1;
            return segments_;
        }
        const std::uint32_t begin = part_ * segments_ / stroke_parts_;
        const std::uint32_t end = (part_ + 1) * segments_ / stroke_parts_;
        ++part_;
        return is_subdivided() ? 1 : end - begin;
    }

    /// Divides the part that was begun into `pieces`; `segments` is what next_part() returned.
    void divide_part(std::uint32_t pieces, std::uint32_t segments)
    {
        is_plain_ = pieces == segments && !is_subdivided();
        pieces_ = {pieces, segments};
        segment_of_part_ = 0;
        piece_ = 0;
    }

    void next_piece(Segment& next)
    {
        if (is_plain_) {
            next = next_segment();
            return;
        }
        if (piece_ == 0 && sub_segment_ == 0)
            begin_segment();
        const std::uint32_t pieces = pieces_.at(segment_of_part_);
        const std::uint32_t number = sub_segment_ * pieces + piece_;
        const std::uint32_t count = sub_segments_ * pieces;
        advance();
        count_op(Op::split);
        next = count == 1 ? segment_ : piece_of_segment(number, count);
    }

    /// The first point of the stroke that the part belongs to.
    Point stroke_start() const { return reader_.start(); }
    /// Whether the part is a whole stroke.
    bool is_whole() const { return stroke_parts_ == 1; }
    /// Whether each segment of the part is one piece.
    bool is_plain() const { return is_plain_; }
    /// For reading the drawing without its parts.
    R& reader() { return reader_; }

private:
    bool is_subdivided() const { return segments_ < stroke_parts_; }

    void begin_stroke()
    {
        read_segments_ = 0;
        stroke_segments_ = reader_.next_stroke();
        segments_ = std::max<std::uint32_t>(stroke_segments_, 1);
        stroke_parts_ = parts_.at(stroke_++);
        part_ = 0;
    }

    Segment next_segment()
    {
        return stroke_segments_ == 0 ? still_segment(reader_.start()) : reader_.next_segment();
    }

    /// Begins the next segment where the stroke or its segments are divided.
    void begin_segment()
    {
        segment_ = next_segment();
        sub_segments_ = is_subdivided() ? Distribution{stroke_parts_, segments_}.at(read_segments_) : 1;
        ++read_segments_;
    }

    /// The outer ends of the first and the last piece are those of the segment.
    Segment piece_of_segment(std::uint32_t number, std::uint32_t count) const
    {
        Segment piece = rounded_to_grid(
            subsegment(segment_, Fraction::ratio(number, count), Fraction::ratio(number + 1, count)));
        if (number == 0)
            piece.from = segment_.from;
        if (number + 1 == count)
            piece.to = segment_.to;
        return piece;
    }

    void advance()
    {
        if (++piece_ < pieces_.at(segment_of_part_))
            return;
        piece_ = 0;
        ++segment_of_part_;
        if (++sub_segment_ == sub_segments_)
            sub_segment_ = 0;
    }

    R reader_;
    std::uint32_t strokes_;
    Distribution parts_;                ///< parts over the strokes
    std::uint32_t stroke_ = 0;          ///< the next stroke
    std::uint32_t stroke_segments_ = 0; ///< as the reader has them: 0 for a single point
    std::uint32_t segments_ = 0;        ///< a single point counts as one segment
    std::uint32_t stroke_parts_ = 0;
    std::uint32_t part_ = 0; ///< the next part of the stroke

    Segment segment_;                 ///< read last
    std::uint32_t read_segments_ = 0; ///< of the stroke
    std::uint32_t sub_segments_ = 1;  ///< that segment_ is divided into, for a stroke with too few of them
    std::uint32_t sub_segment_ = 0;   ///< the next one

    bool is_plain_ = true; ///< every segment of the part is one piece
    Distribution pieces_;  ///< pieces over the segments of the part
    std::uint32_t segment_of_part_ = 0;
    std::uint32_t piece_ = 0; ///< the next one of the segment
};

/// The same point or segment in two equalized drawings.
template <class T>
struct Pair {
    T a;
    T b;
};

/// A line paired with a curve becomes a curve.
inline void make_same_kind(Pair<Segment>& both)
{
    if (both.a.kind == both.b.kind)
        return;
    Segment& line = both.a.kind == Segment::Kind::line ? both.a : both.b;
    const Segment cubic = rounded_to_grid(as_cubic(line));
    line = {Segment::Kind::cubic, line.from, cubic.c1, cubic.c2, line.to};
}

/// Walks two drawings side by side:
///
///     EqualizedPair pair{a, b};
///     while (const std::uint32_t pieces = pair.next_stroke())
///         for (std::uint32_t i = 0; i < pieces; ++i)
///             use(pair.next_segment());
///
/// An empty drawing is its partner with every stroke drawn together to the centre of its vertices' box; two
/// empty ones have no strokes. Every segment that next_stroke() counts is read before the next is begun.
/// Points that are added are on a grid of 1/64 px, as those that are drawn are.
///
/// A drawing has at most 65535 strokes, a stroke at most 65535 segments, and their points are less than
/// 32768 px apart in x and in y (core/math/flatten.hpp). What the readers read must outlive the pair.
template <DrawingReader R>
class EqualizedPair {
public:
    EqualizedPair(const R& a, const R& b)
        : EqualizedPair{a.strokes(), b.strokes(), false, [&](bool is_second) { return is_second ? b : a; }}
    {
    }
    /// A drawing beside itself, read once.
    explicit EqualizedPair(const R& both)
        : EqualizedPair{both.strokes(), both.strokes(), true, [&](bool) { return both; }}
    {
    }
    /// For a small stack: `make(is_second)` returns either drawing, unread, with that many strokes. A single
    /// pair has as many strokes on both sides, and `make` is asked only for the first drawing.
    [[gnu::noinline]] EqualizedPair(std::uint32_t strokes_of_a, std::uint32_t strokes_of_b, bool is_single,
                                    FunctionRef<R(bool)> make)
        : a_{make, strokes_of_a == 0 && !is_single, strokes_of_b},
          b_{make, strokes_of_b != 0 && !is_single, strokes_of_a},
          is_single_{is_single || strokes_of_a == 0 || strokes_of_b == 0},
          a_is_empty_{strokes_of_a == 0},
          b_is_empty_{strokes_of_b == 0},
          is_plain_{strokes_of_a == strokes_of_b},
          strokes_left_{a_is_empty_ && b_is_empty_ ? 0 : a_.parts()}
    {
    }

    /// Begins the next pair of strokes and returns the number of its segments; 0 after the last stroke.
    std::uint32_t next_stroke()
    {
        if (strokes_left_ == 0)
            return 0;
        --strokes_left_;
        if (a_is_empty_ || b_is_empty_)
            find_centre();
        const std::uint32_t a = a_.next_part();
        if (is_single_) {
            a_.divide_part(a, a);
            return a;
        }
        const std::uint32_t b = b_.next_part();
        const std::uint32_t pieces = std::max(a, b);
        a_.divide_part(pieces, a);
        b_.divide_part(pieces, b);
        is_plain_ = is_plain_ && is_whole() && a_.is_plain() && b_.is_plain();
        return pieces;
    }

    /// Both are of the same kind, and stay as they are until the next call.
    const Pair<Segment>& next_segment()
    {
        a_.next_piece(both_.a);
        if (!is_single_) {
            b_.next_piece(both_.b);
        } else {
            both_.b = both_.a;
            if (a_is_empty_ == b_is_empty_)
                return both_;
            (a_is_empty_ ? both_.a : both_.b) = still_segment(centre_);
        }
        is_plain_ = is_plain_ && both_.a.kind == both_.b.kind;
        make_same_kind(both_);
        return both_;
    }

    /// Where the fill of the stroke is closed: the first points of the strokes that its two sides belong to.
    /// For a whole stroke that is its own first point; the parts of a broken one have it in common.
    Pair<Point> hub() const
    {
        return {a_is_empty_ ? centre_ : a_.stroke_start(),
                b_is_empty_ ? centre_ : (is_single_ ? a_ : b_).stroke_start()};
    }

    /// Whether in all that has been read nothing is broken, no points have been added, and no line has become
    /// a curve: then at progress 0 and 1 the tween is the drawing itself.
    bool is_plain() const { return is_plain_; }

    /// Whether neither side is a part of a broken stroke: closed strokes stay closed.
    bool is_whole() const { return a_.is_whole() && (is_single_ || b_.is_whole()); }

private:
    /// Finds the centre of the next stroke: b_ has the non-empty drawing, too, and is read only for this.
    [[gnu::cold, gnu::noinline]] void find_centre()
    {
        R& outline = b_.reader();
        const std::uint32_t segments = outline.next_stroke();
        Point low = outline.start();
        Point high = low;
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Point to = outline.next_segment().to;
            low = {std::min(low.x, to.x), std::min(low.y, to.y)};
            high = {std::max(high.x, to.x), std::max(high.y, to.y)};
        }
        centre_ = rounded_to_grid(still_segment(lerp(low, high, {Fraction::one / 2}))).to;
    }

    BrokenDrawing<R> a_;
    BrokenDrawing<R> b_; ///< not read side by side with the other if the pair is single
    bool is_single_;     ///< a drawing beside itself, or beside its strokes drawn together
    bool a_is_empty_;
    bool b_is_empty_;
    bool is_plain_;
    std::uint32_t strokes_left_;
    Point centre_;
    Pair<Segment> both_;
};

}
