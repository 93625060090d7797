#pragma once

#include "core/angle.hpp"
#include "core/edge_list.hpp"
#include "core/stroke_style.hpp"

#include <cstdint>
#include <limits>

namespace kfast {

/// The tool that draws a stroke.
struct Pen {
    Fixed half_width;   ///< in panel pixels, at most 4095
    int arc_pieces = 4; ///< of half a turn
    Cap cap = Cap::butt;
    Join join = Join::miter;
    int miter_limit = default_miter_limit; ///< in 1/8 widths, 8 … 255
};

/// Turns strokes into the edges of their outlines, as they are drawn: nothing is stored but the first and the
/// last point. Every segment becomes a rectangle and every join a wedge, all with the same sense of rotation,
/// so that the winding number is positive wherever the pen has been.
class StrokeOutline {
public:
    StrokeOutline(EdgeList& edges, Layer& layer, const Pen& pen) : edges_{edges}, layer_{layer}, pen_{pen} {}

    void begin(Point at);
    /// The arcs of joins up to the next call, or to the end, have no more than `pieces` pieces besides one
    /// each.
    void limit_arcs(std::int32_t pieces) { spare_pieces_ = pieces; }
    /// Points closer than 1/256 px to the one before are passed over: their direction would be noise.
    void line_to(Point to);
    /// Ends the stroke with two caps, or joins its end to its beginning.
    void end(bool is_closed);

private:
    static constexpr std::int32_t unlimited = std::numeric_limits<std::int32_t>::max();

    /// A direction, exact to the precision of the outline.
    struct Heading {
        std::int32_t x = 0; ///< unit vector in Q15
        std::int32_t y = 0;
        BinaryAngle angle;
    };

    static Heading heading_of(Point vector);

    Point ahead(Heading heading) const;
    Point aside(Heading heading) const;
    void line(Point from, Point to) { edges_.add(layer_, from, to); }
    void join(Point at, Heading before, Heading after);
    void outer_join(Point at, Point from, Point to, BinaryAngle from_angle, std::int32_t turn);
    void arc(Point centre, Point from, Point to, BinaryAngle from_angle, std::int32_t turn);
    void cap(Point at, Heading outwards);
    void dot();

    EdgeList& edges_;
    Layer& layer_;
    Pen pen_;
    Point first_;
    Point last_;
    Heading first_heading_;
    Heading last_heading_;
    bool has_segment_ = false;
    std::int32_t spare_pieces_ = unlimited;
};

}
