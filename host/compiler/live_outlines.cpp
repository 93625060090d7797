#include "host/compiler/live_outlines.hpp"

#include "core/affine.hpp"

#include <algorithm>

namespace kfast {
namespace {

/// What `points` in `strokes` of them take at most when they are filled: each corner of a polygon is stored,
/// the first one twice, and each edge may be a chain.
OutlineAmount most_filled(std::size_t strokes, std::size_t points) { return {points + strokes, points}; }

/// Likewise when a pen follows them.
///
/// A join has 3 corners on its inner and 2 on its outer side, and those of a round between them. Both sides
/// together turn once round at it, so that y turns back twice; a third time is for what rounding does to an
/// edge that is next to level.
OutlineAmount most_drawn(std::size_t strokes, std::size_t points, const Pen& pen)
{
    const auto round = static_cast<std::size_t>(most_corners_of_half_turn(pen.half_width));
    const std::size_t of_join = 5 + (pen.join == Join::round ? round : 0);
    const std::size_t of_cap = pen.cap == Cap::round ? round : pen.cap == Cap::square ? 2 : 0;
    const std::size_t of_ends = 5 + (pen.cap == Cap::butt ? 0 : 2 * of_cap + 3);
    const std::size_t joins = points - strokes; // one more than an open stroke has: it may be closed
    return {strokes * of_ends + joins * of_join, strokes * 8 + joins * 3};
}

/// Fewer strokes have more joins.
OutlineAmount most_drawn(const DrawingInput& limits, const Pen& pen)
{
    const OutlineAmount many = most_drawn(limits.strokes, limits.points, pen);
    const OutlineAmount one = most_drawn(1, limits.points, pen);
    return {std::max(many.corners, one.corners), std::max(many.chains, one.chains)};
}

/// By what lengths around any point of a drawing grow, at most; in perspective by the most of 17 x 17 places
/// among those that a point can have.
std::int32_t most_growth(const Space& space, const Camera& camera)
{
    if (space.is_flat())
        return space.plane.growth();
    constexpr int farthest = 2048; // px
    constexpr int step = farthest / 8;
    const Projection projection{space, camera};
    std::int32_t most = 0;
    for (int x = -farthest; x <= farthest; x += step)
        for (int y = -farthest; y <= farthest; y += step)
            most = std::max(most, projection.growth_at({Fixed::pixels(x), Fixed::pixels(y)}));
    return most;
}

/// Walks through what is seen, as the tracer does.
class LiveItems {
public:
    LiveItems(const SceneOnPanel& on_panel, const Moment& moment) : on_panel_{on_panel}, moment_{moment} {}

    OutlineAmount most() const { return most_; }

    void add(ItemCursor items, const Space& outer)
    {
        while (!items.at_end())
            add(items.next(), outer);
    }

private:
    void add(const ItemView& item, const Space& outer)
    {
        if (item.kind == ItemKind::object)
            return;
        const ItemState state{on_panel_.scene, item, moment_};
        if (state.opacity() == 0)
            return;
        const Space space = item.tracks.at_end() ? outer : outer * state.placement();
        if (item.kind == ItemKind::live && item.live.kind == LiveKind::drawing)
            add_live(item, state, space);
        else if (!item.is_leaf())
            add(on_panel_.scene.items_in(item), space);
    }

    void add_live(const ItemView& item, const ItemState& state, const Space& space)
    {
        const DrawingInput limits = on_panel_.scene.input(item.live.input).drawing;
        const ObjectStyle& style = item.object.style;
        if (style.is_filled)
            most_ += most_filled(limits.strokes, limits.points);
        if (style.is_stroked)
            most_ += most_drawn(
                limits, {.half_width = half_width(state.width(), most_growth(space, on_panel_.camera)),
                         .cap = style.cap,
                         .join = style.join});
    }

    const SceneOnPanel& on_panel_;
    const Moment& moment_;
    OutlineAmount most_;
};

}

OutlineAmount live_outlines(const SceneOnPanel& on_panel, const Moment& moment)
{
    LiveItems items{on_panel, moment};
    items.add(on_panel.scene.items(), on_panel.canvas);
    return items.most();
}

}
