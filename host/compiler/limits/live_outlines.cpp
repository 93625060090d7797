#include "host/compiler/limits/live_outlines.hpp"

#include "core/math/affine.hpp"
#include "core/scene_walk.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::size_t corner_bytes =
    sizeof(raster::Corner) + sizeof(raster::Bend); ///< bytes, while it comes in
constexpr std::size_t chain_bytes = sizeof(raster::Chain) + sizeof(raster::Bend) + 8;

/// Bytes of an edge over so many rows. A long one is a chain of its own, and may cut off another one
/// (core/raster/outline/outline_store.hpp).
std::size_t max_edge_bytes(std::size_t rows)
{
    constexpr std::size_t line_bytes = sizeof(raster::Chain) + sizeof(raster::StraightLine);
    return std::min(chain_bytes + rows * sizeof(raster::Crossing), line_bytes + chain_bytes);
}

/// Not all edges of a drawing are as bad as they can be: the worst that were tried take more than two thirds.
std::size_t likely(std::size_t bytes) { return bytes * 4 / 5; }

/// What `points` in `strokes` of them take at most when they are filled: each corner of a polygon is stored,
/// the first one twice.
std::size_t max_filled_bytes(std::size_t strokes, std::size_t points, std::size_t rows)
{
    return (points + strokes) * corner_bytes + points * max_edge_bytes(rows);
}

/// The same when a pen follows them.
///
/// A join has 3 corners on its inner and 2 on its outer side, and those of a round between them. Besides two
/// edges along its pieces it has others around it, which reach no further than the pen, and are a chain if
/// they turn.
std::size_t max_drawn_bytes(std::size_t strokes, std::size_t points, const Pen& pen, std::size_t rows)
{
    const auto round = static_cast<std::size_t>(max_corners_of_half_turn(pen.half_width));
    const std::size_t of_join = 5 + (pen.join == Join::round ? round : 0);
    const std::size_t of_cap = pen.cap == Cap::round ? round : pen.cap == Cap::square ? 2 : 0;
    const std::size_t of_ends = 5 + (pen.cap == Cap::butt ? 0 : 2 * of_cap + 3);
    const std::size_t joins = points - strokes; // one more than an open stroke has: it may be closed
    const std::size_t pen_rows =
        std::min(rows, static_cast<std::size_t>((pen.half_width + pen.half_width).raw() >> 16) + 2);
    const std::size_t of_turn = chain_bytes + 2 * pen_rows * sizeof(raster::Crossing);
    return (strokes * of_ends + joins * of_join) * corner_bytes + points * 2 * max_edge_bytes(rows) +
           (joins + 4 * strokes) * of_turn;
}

/// Fewer strokes have more joins.
std::size_t max_drawn_bytes(const DrawingInput& limits, const Pen& pen, std::size_t rows)
{
    return std::max(max_drawn_bytes(limits.strokes, limits.points, pen, rows),
                    max_drawn_bytes(1, limits.points, pen, rows));
}

/// By what lengths around any point of a drawing grow, at most; in perspective by the most of 17 x 17 places
/// among those that a point can have.
std::int32_t max_scale_factor(const Space& space, const Camera& camera)
{
    if (space.is_flat())
        return space.plane.scale_factor();
    constexpr int farthest = 2048; // px
    constexpr int step = farthest / 8;
    const Projection projection{space, camera};
    std::int32_t max = 0;
    for (int x = -farthest; x <= farthest; x += step)
        for (int y = -farthest; y <= farthest; y += step)
            max = std::max(max, projection.scale_factor_at({Fixed::pixels(x), Fixed::pixels(y)}));
    return max;
}

/// Of a drawing from outside.
std::size_t bytes_of(const SceneOnPanel& on_panel, SceneWalk& walk)
{
    const DrawingInput limits = on_panel.scene.input(walk.node().of).drawing;
    const ObjectStyle& style = walk.node().style;
    const auto rows = static_cast<std::size_t>(on_panel.scene.canvas().height);
    std::size_t bytes = 0;
    if (style.is_filled)
        bytes += likely(max_filled_bytes(limits.strokes, limits.points, rows));
    if (style.is_stroked)
        bytes += likely(max_drawn_bytes(
            limits,
            {.half_width = half_width(walk.state().width(), max_scale_factor(walk.space(), on_panel.camera)),
             .cap = style.cap,
             .join = style.join},
            rows));
    return bytes;
}

}

std::size_t live_outline_bytes(const SceneOnPanel& on_panel)
{
    std::size_t bytes = 0;
    SceneWalk walk{on_panel, SceneWalk::Opacity::of_leaves};
    while (walk.next() == SceneWalk::Step::leaf)
        if (walk.node().kind == ItemKind::live && walk.node().live == InputLeaf::drawing)
            bytes += bytes_of(on_panel, walk);
    return bytes;
}

}
