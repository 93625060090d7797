#pragma once

#include "core/math/affine.hpp"
#include "core/math/flatten.hpp"
#include "core/math/point.hpp"
#include "core/math/projection.hpp"
#include "core/math/stroke_trimmer.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/scene/scene_view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Where the parallel lines of a hatching cross the border of a fill, found while the strokes of an object
/// are traced (PosedStrokes::trace()), in its own space: the lines stay where they are while the drawing
/// changes, and they rotate and scale with the object.
///
/// Line n is n + 1/2 spacings from the origin. Strokes that are not closed are filled as if they were.
class Hatching {
public:
    /// Crossings are in `memory`, which is aligned to 4 bytes. The lines are 2^`wider` times as far from each
    /// other as `style` says; `coarseness` is that of a ViewProjection.
    Hatching(std::span<std::byte> memory, const BeamStyle& style, int wider, int coarseness);

    void begin(Point from);
    void add(const Segment& segment);
    void end(Point hub, bool is_closed);
    // And for the pieces of a trimmed stroke (PieceSink).
    void end_piece(Point hub, PieceEnd end) { this->end(hub, end == PieceEnd::closed); }
    int pieces_of(const Segment& segment) const { return view_.pieces_of(segment); }

    /// Whether not all crossings have found room.
    bool is_full() const { return is_full_; }
    /// Draws with `pen` the pieces of the lines that are inside, placed: line by line, in one direction along
    /// one and in the other along the next. Of the memory, the pen may fill 8 bytes for each piece from the
    /// front, and 12 from the back: the crossings in their place have been read by then.
    template <class Pen>
    void trace(FillRule rule, const Affine& placement, Pen& pen)
    {
        sort();
        const PointMap place{placement};
        std::int32_t winding = 0;
        Crossing entry;
        for (std::size_t i = 0; i < count_; ++i) {
            const Crossing crossing = crossings_[i];
            const bool was_inside = is_inside(rule, winding);
            winding += crossing.winding();
            if (!was_inside)
                entry = crossing;
            else if (!is_inside(rule, winding) && length(entry, crossing) >= min_length)
                trace_piece(place(point(entry)), place(point(crossing)), pen);
        }
    }

private:
    /// Its lowest bit is the direction in which the border crosses the line.
    struct Crossing {
        std::int32_t line = 0;
        std::int32_t along = 0; ///< in 1/65536 px

        std::int32_t winding() const { return (along & 1) != 0 ? 1 : -1; }
    };

    /// A point in a space where the lines run to the right.
    struct Place {
        std::int32_t along = 0;
        std::int32_t across = 0;
    };

    /// The minimum length of a piece, in 1/65536 px. A corner on a line would shine as a dot otherwise.
    static constexpr std::int32_t min_length = 65536 / 16;

    static constexpr std::size_t bytes_of_crossing =
        sizeof(Crossing) + 6; ///< and that of half a piece at the back

    template <class Pen>
    static void trace_piece(Point from, Point to, Pen& pen)
    {
        pen.begin(from);
        pen.add(Segment{.from = from, .to = to});
        pen.end(from, false);
    }

    static constexpr std::int32_t length(const Crossing& entry, const Crossing& exit)
    {
        return entry.along < exit.along ? exit.along - entry.along : entry.along - exit.along;
    }

    Place place(Point at) const;
    Point point(const Crossing& crossing) const;
    std::int32_t first_line_from(std::int32_t across) const;
    std::int32_t across_of(std::int32_t line) const { return line * spacing_ + spacing_ / 2; }
    void line_to(Point to);
    void cross(std::int32_t line, Place low, Place high, bool is_up);
    void sort();

    Crossing* crossings_;
    std::size_t max_;
    std::size_t count_ = 0;
    std::int32_t spacing_; ///< in 1/65536 px
    UnitVector direction_; ///< of the lines
    ViewProjection view_;
    Point start_;
    Point last_;
    bool is_full_ = false;
};

/// The size of memory for the hatchings of a scene, besides that for outlines, a multiple of 4: for two
/// crossings on each line of every hatched object, as if each were as large as the canvas. What is larger, or
/// has more holes, has the room that others leave.
std::size_t hatching_bytes(const SceneView& scene);

}
