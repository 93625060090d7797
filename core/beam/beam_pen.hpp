#pragma once

#include "core/beam/beam_lines.hpp"
#include "core/beam/beam_profile.hpp"
#include "core/math/flatten.hpp"
#include "core/math/point.hpp"
#include "core/math/projection.hpp"
#include "core/math/stroke_trimmer.hpp"
#include "core/pixel/paint_style.hpp"

#include <cstdint>
#include <optional>

namespace kfast {

/// What is drawn of an object.
enum class BeamInk : std::uint8_t {
    stroke,  ///< its strokes as they are; one without length is a dot
    outline, ///< the border of its fill: open strokes are closed, as they are for filling, and there are no
             ///< dots
};

/// Turns the live strokes of one object (PosedStrokes::trace()) into lines in the field.
///
/// Corners are rounded to units of the field, halves up; where lines cross its border is rounded from the
/// exact crossing of these, in whichever direction the line runs. What is beyond the border is cut off: a
/// line that leaves the field and comes back becomes several, all of them open.
class BeamPen {
public:
    /// `resolution` is that of the profile: the pixels of a side of the panel, which represents the field.
    BeamPen(BeamLines& lines, const ViewProjection& view, int resolution, BeamInk ink, Colour colour,
            std::uint32_t item);

    void begin(Point from);
    void add(const Segment& segment);
    void end(Point hub, bool is_closed);
    /// Ends a part of a broken stroke: it stays open, so that outlines have no seams where it has none.
    void end_part();
    // And for the pieces of a trimmed stroke (PieceSink).
    void end_piece(Point hub, PieceEnd end);
    int pieces_of(const Segment& segment) const { return view_.pieces_of(segment); }

private:
    /// As FieldPoint, but without limits.
    struct Place {
        std::int32_t x = 0;
        std::int32_t y = 0;

        bool is_in_field() const;
    };

    static bool is_outside_one_side(Place a, Place b);
    static std::optional<Place> crossing(Place outside, Place other);
    static std::optional<std::int32_t> crossing(std::int32_t border, Place from, Place to);

    Place place(Point seen) const;
    void move_to(Place to);
    void line_to(Place to);
    void add_cut(Place to);
    void add_point(Place at);
    void end_line();
    void end_stroke();
    bool is_near_last(Place to) const;

    BeamLines& lines_;
    ViewProjection view_;
    int shift_;            ///< from 1/65536 px to half units of the field
    std::int32_t merging_; ///< corners that are so near to the previous one are left out
    BeamInk ink_;
    Colour colour_;
    std::uint32_t item_;
    Place first_;
    Place last_;                   ///< the last one that was not left out
    std::optional<Place> skipped_; ///< the one after it
    bool is_drawing_ = false;      ///< a line in the field has begun
    bool is_cut_ = false;          ///< a part of the stroke is outside
};

}
