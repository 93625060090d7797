#pragma once

#include "core/math/angle.hpp"
#include "core/math/flatten.hpp"
#include "core/math/projection.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/raster/outline/outline_store.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace kfast {

/// How a stroke is drawn.
struct Pen {
    Fixed half_width; ///< in panel pixels, at most 4095
    Cap cap = Cap::butt;
    Join join = Join::miter;
    int miter_limit = default_miter_limit; ///< in 1/8 widths, 8 … 255
};

/// The maximum number of corners between the ends of a half circle of a pen.
int max_corners_of_half_turn(Fixed half_width);

/// Converts strokes into contours as they are drawn: nothing is stored but the first and the last piece. Both
/// sides of a stroke are built at once. The winding number is positive wherever the pen has been: what the
/// contour goes around is the sum of a rectangle for each piece and a wedge for each join.
class StrokeOutline {
public:
    /// `coarseness`: how often the maximum length of pieces of arcs is doubled.
    StrokeOutline(raster::OutlineStore& outlines, const Pen& pen, int coarseness);

    void begin(Point at) { code_->begin(*this, at); }
    /// A segment from the last point on, as `view` shows it, in so many straight pieces, or in more for a
    /// wide pen. Where a stroke begins or ends with a curve, it does so across its tangent.
    void add(const Segment& segment, int pieces, const ViewProjection& view)
    {
        code_->add(*this, segment, pieces, view);
    }
    /// Points closer than 1/256 px to the previous one are skipped: their direction would be noise.
    void line_to(Point to);
    /// Ends the stroke with two caps, or joins its end to its beginning.
    void end(bool is_closed) { code_->end(*this, is_closed); }
    /// Ends the first piece of a closed stroke that is drawn across its seam: without a cap where it began.
    [[gnu::cold]] void end_after_seam();
    /// Ends the last piece of that stroke, which is the next one: joined to where the first one began.
    [[gnu::cold]] void end_at_seam();

private:
    /// How many pieces a curve needs that `pieces` would do for, were it not as wide. A rim half a width
    /// outside of the middle, whose radius is r, is farther from its chords by half_width / r; and a quarter
    /// of a circle has sqrt(5 r) pieces. Of curves that bend less, half as many again are enough.
    int pieces_of_rims(int pieces) const
    {
        constexpr int wide = 4;
        const int half_width = pen_.half_width.raw() >> 16;
        if (half_width < wide || pieces >= max_steps)
            return pieces;
        return std::min(pieces + std::min(half_width * 5 / pieces, pieces) / 2, max_steps);
    }

    /// The functions that work on it: linked only with what makes one.
    struct Code {
        void (*begin)(StrokeOutline&, Point at);
        void (*add)(StrokeOutline&, const Segment& segment, int pieces, const ViewProjection& view);
        void (*end)(StrokeOutline&, bool is_closed);
    };
    static const Code code;

    void begin_stroke(Point at);
    void add_segment(const Segment& segment, int pieces, const ViewProjection& view);
    void set_tangent(Point tangent);
    void end_stroke(bool is_closed);

    enum class Side : std::uint8_t { right, left };

    struct Piece {
        Direction direction;
        std::uint32_t length = 0; ///< in 1/65536 px
        Point side;               ///< half a width to its right
    };

    struct Bend;

    static constexpr Side opposite(Side side) { return side == Side::right ? Side::left : Side::right; }

    Piece piece_along(Point step) const;
    static bool can_begin_across(const Piece& tangent, const Piece& chord);
    void add(Side side, Point at);
    void join(const Piece& after);
    void add_pivot(const Bend& bend);
    void add_outer(const Bend& bend);
    bool has_miter(std::uint32_t rest) const;
    void arc(Side side, Point centre, Point from, Point ahead, std::int32_t cosine);
    void cap(Point at, Point side);
    void cap_end();
    void cap_beginning();
    void dot();

    const Code* code_ = &code;
    raster::OutlineStore& outlines_;
    Pen pen_;
    std::int32_t slight_bend_; ///< 1 - cosine, in Q30
    int arc_step_;             ///< in 1/48 quarter turn
    Point first_;
    Point last_;
    Piece first_piece_;
    Piece last_piece_;
    Piece seam_piece_; ///< with which the first piece began, whose end is joined to it
    bool has_piece_ = false;
    bool is_at_begin_ = false;
    Point end_tangent_;        ///< none where the stroke ends with a line
    bool has_tangent_ = false; ///< first_piece_ is the tangent that the stroke begins with
};

/// Makes one in place, for the feature.
void emplace_stroke_outline(std::optional<StrokeOutline>& outline, raster::OutlineStore& outlines,
                            const Pen& pen, int coarseness);

}
