#pragma once

#include "core/distribution.hpp"
#include "core/drawing_reader.hpp"
#include "core/work.hpp"

#include <algorithm>
#include <cstdint>

/// Two key drawings with different numbers of strokes and points, walked side by side as if they had the
/// same.
///
/// The rules are those of KFAST (C. M. Lever, Amiga, about 1992); docs/design.md has them with a worked
/// example. Nothing is copied: each drawing is read once, and points are added as they are asked for.
namespace kfast {

/// One of the two drawings, its strokes broken into as many parts as the partner has strokes.
template <DrawingReader R>
class BrokenDrawing {
public:
    BrokenDrawing(const R& drawing, std::uint32_t partner_strokes)
        : reader_{drawing}, strokes_{drawing.strokes()}, parts_{std::max(partner_strokes, strokes_),
                                                                std::max<std::uint32_t>(strokes_, 1)}
    {
    }

    /// The parts of the whole drawing.
    std::uint32_t parts() const { return parts_.each * strokes_ + parts_.extra; }

    /// Begins the next part and returns the number of its segments, at least 1.
    std::uint32_t next_part()
    {
        if (part_ == stroke_parts_)
            begin_stroke();
        const std::uint32_t begin = part_ * segments_ / stroke_parts_;
        const std::uint32_t end = (part_ + 1) * segments_ / stroke_parts_;
        ++part_;
        return is_subdivided() ? 1 : end - begin;
    }

    /// How many pieces the part that was begun is to yield; `segments` is what next_part() returned.
    void divide_part(std::uint32_t pieces, std::uint32_t segments)
    {
        pieces_ = {pieces, segments};
        segment_of_part_ = 0;
        piece_ = 0;
    }

    Segment next_piece()
    {
        read_segment();
        const std::uint32_t pieces = pieces_.at(segment_of_part_);
        const std::uint32_t number = sub_segment_ * pieces + piece_;
        const std::uint32_t count = sub_segments_ * pieces;
        advance();
        if (count == 1)
            return segment_;
        did(Work::split);
        return stretch(segment_, Share::ratio(number, count), Share::ratio(number + 1, count));
    }

    /// As next_piece(), but tells only its kind.
    Segment::Kind skip_piece()
    {
        read_segment();
        advance();
        return segment_.kind;
    }

    /// The first point of the stroke that the part belongs to.
    Point stroke_start() const { return reader_.start(); }
    /// The part is a whole stroke.
    bool is_whole() const { return stroke_parts_ == 1; }

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

    /// The segment of the next piece, if it is not the one that was read last.
    void read_segment()
    {
        if (piece_ != 0 || sub_segment_ != 0)
            return;
        segment_ = stroke_segments_ == 0 ? still_segment(reader_.start()) : reader_.next_segment();
        sub_segments_ = is_subdivided() ? Distribution{stroke_parts_, segments_}.at(read_segments_) : 1;
        ++read_segments_;
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

    Distribution pieces_; ///< pieces over the segments of the part
    std::uint32_t segment_of_part_ = 0;
    std::uint32_t piece_ = 0; ///< the next one of the segment
};

/// The same moment in two equalized drawings.
template <class T>
struct Pair {
    T a;
    T b;
};

/// Walks two drawings side by side:
///
///     EqualizedPair pair{a, b};
///     while (const std::uint32_t pieces = pair.next_stroke())
///         for (std::uint32_t i = 0; i < pieces; ++i)
///             use(pair.next_segment());
///
/// An empty drawing is its partner with every stroke drawn together to the centre of its vertices' box; two
/// empty ones have no strokes. Every segment that next_stroke() counts is read before the next is begun.
///
/// A drawing has at most 65535 strokes, a stroke at most 65535 segments, and their points lie less than
/// 32768 px apart in x and in y (core/segment.hpp). What the readers look at must outlive the pair.
template <DrawingReader R>
class EqualizedPair {
public:
    EqualizedPair(const R& a, const R& b)
        : a_{a.strokes() != 0 ? a : b, b.strokes()}, b_{b.strokes() != 0 ? b : a, a.strokes()},
          a_is_empty_{a.strokes() == 0}, b_is_empty_{b.strokes() == 0}, outline_{a_is_empty_ ? b : a},
          strokes_left_{a_is_empty_ && b_is_empty_ ? 0 : a_.parts()}
    {
    }

    /// Begins the next pair of strokes and returns the number of its segments; 0 after the last stroke.
    std::uint32_t next_stroke()
    {
        if (strokes_left_ == 0)
            return 0;
        --strokes_left_;
        const std::uint32_t a = a_.next_part();
        const std::uint32_t b = b_.next_part();
        const std::uint32_t pieces = std::max(a, b);
        a_.divide_part(pieces, a);
        b_.divide_part(pieces, b);
        if (a_is_empty_ || b_is_empty_)
            find_centre();
        return pieces;
    }

    Pair<Segment> next_segment()
    {
        const Pair<Segment> both{a_.next_piece(), b_.next_piece()};
        return {a_is_empty_ ? still_segment(centre_) : both.a, b_is_empty_ ? still_segment(centre_) : both.b};
    }

    /// As next_segment(), but computes no points: tells only whether the pair is a curve.
    bool skip_segment()
    {
        const Segment::Kind a = a_.skip_piece();
        const Segment::Kind b = b_.skip_piece();
        return a == Segment::Kind::cubic || b == Segment::Kind::cubic;
    }

    /// Where the fill of the stroke is closed: the first points of the strokes that its two sides belong to.
    /// For a whole stroke that is its own first point; the parts of a broken one share it.
    Pair<Point> hub() const
    {
        return {a_is_empty_ ? centre_ : a_.stroke_start(), b_is_empty_ ? centre_ : b_.stroke_start()};
    }

    /// Neither side is a part of a broken stroke: closed strokes stay closed.
    bool is_whole() const { return a_.is_whole() && b_.is_whole(); }

private:
    void find_centre()
    {
        const std::uint32_t segments = outline_.next_stroke();
        Point low = outline_.start();
        Point high = low;
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Point to = outline_.next_segment().to;
            low = {std::min(low.x, to.x), std::min(low.y, to.y)};
            high = {std::max(high.x, to.x), std::max(high.y, to.y)};
        }
        centre_ = lerp(low, high, {Share::one / 2});
    }

    BrokenDrawing<R> a_;
    BrokenDrawing<R> b_;
    bool a_is_empty_;
    bool b_is_empty_;
    R outline_; ///< reads the partner of an empty drawing ahead, for its centre
    Point centre_;
    std::uint32_t strokes_left_;
};

}
