#pragma once

#include "core/bytes/op_counter.hpp"
#include "core/math/affine.hpp"
#include "core/math/flatten.hpp"
#include "core/math/point.hpp"
#include "core/scene/input_view.hpp"
#include "core/scene/scene_view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// In 1/16 px, in the coordinates of the items that show it.
struct InputPoint {
    std::int16_t x = 0;
    std::int16_t y = 0;

    friend constexpr bool operator==(InputPoint, InputPoint) = default;
};

/// Straight lines through points; one point is a dot. Closed when its first and last point coincide.
using InputStroke = std::span<const InputPoint>;

/// A drawing from outside: the one that is shown, and the next one, which arrives point by point and replaces
/// it at once. It is stored in memory that the caller lends; copies are the same drawing.
class InputDrawing {
public:
    /// Bytes of memory for what `limits` allow; a multiple of 4.
    static std::size_t bytes_for(const DrawingInput& limits);

    /// `memory` is aligned to 4 bytes, all 0 at first, and has bytes_for(limits). Both drawings are empty
    /// then.
    InputDrawing(std::span<std::byte> memory, const DrawingInput& limits);

    /// Strokes of the drawing that is shown.
    std::uint32_t strokes() const { return shown().strokes; }
    /// `number` is less than strokes(). The stroke has at least one point.
    InputStroke stroke(std::uint32_t number) const;

    /// Empties the next drawing and sets its mark to 0.
    void begin();
    /// Lets the next point begin a stroke, as the first one always does.
    void begin_stroke() { head_->has_stroke = 0; }
    /// Whether there was room for the point.
    bool add(InputPoint point);
    /// A number of the next drawing, for the code that adds its points; 0 at first.
    std::uint32_t mark() const { return head_->mark; }
    void set_mark(std::uint32_t mark) { head_->mark = mark; }
    /// Shows the next drawing instead, and empties what is next. Returns whether they differ.
    bool show();

private:
    struct Counts {
        std::uint16_t strokes;
        std::uint16_t points;
    };
    struct Head {
        Counts drawings[2];
        std::uint16_t shown;      ///< number of the drawing that is shown
        std::uint16_t has_stroke; ///< of the next one: points belong to its last stroke
        std::uint32_t mark;
    };
    static_assert(sizeof(Head) == 16);

    std::size_t next_number() const { return 1U - head_->shown; }
    const Counts& shown() const { return head_->drawings[head_->shown]; }
    Counts& next() { return head_->drawings[next_number()]; }
    /// How many points of a drawing come before the end of each stroke.
    std::uint16_t* ends(std::size_t drawing) const;
    InputPoint* points(std::size_t drawing) const;
    bool is_same() const;

    Head* head_;
    std::size_t max_strokes_;
    std::size_t max_points_;
};

constexpr Point point_of(InputPoint point)
{
    return {Fixed::sixteenths(point.x), Fixed::sixteenths(point.y)};
}

/// The first point of the drawing that is shown; the origin if it is empty.
inline Point start_of(const InputDrawing& drawing)
{
    return drawing.strokes() == 0 ? Point{} : point_of(drawing.stroke(0).front());
}

/// Adds the strokes that are shown, placed.
template <class Outline>
void trace_live_strokes(const InputDrawing& drawing, const Affine& placement, Outline& outline)
{
    const PointMap place{placement};
    for (std::uint32_t number = 0; number < drawing.strokes(); ++number) {
        count_op(Op::stroke);
        const InputStroke stroke = drawing.stroke(number);
        const Point first = place(point_of(stroke.front()));
        outline.begin(first);
        Point from = first;
        for (const InputPoint& point : stroke.subspan(1)) {
            count_op(Op::line);
            const Point to = place(point_of(point));
            outline.add(Segment{.from = from, .to = to});
            from = to;
        }
        outline.end(first, stroke.front() == stroke.back());
    }
}

/// The drawings that a scene takes from outside, in memory that the caller lends.
class InputDrawings {
public:
    /// Bytes of memory for all of them; a multiple of 4.
    static std::size_t bytes_for(const SceneView& scene);

    InputDrawings() = default;
    /// `memory`, aligned to 4 bytes, has bytes_for(scene). Shows the default drawings.
    InputDrawings(const SceneView& scene, std::span<std::byte> memory);

    /// Shows the default drawings: part of the constructor, called only with the feature.
    void show_default(const SceneView& scene) const;

    /// The drawing of the input `number` of `scene`, the scene that these were made for.
    InputDrawing of(const SceneView& scene, std::uint32_t number) const;

private:
    std::span<std::byte> memory_;
};

}
