#include "core/player.hpp"

#include "core/blending.hpp"
#include "core/live_strokes.hpp"
#include "core/paint_order.hpp"
#include "core/pixel_row.hpp"
#include "core/sweep.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::size_t widest_pixel = 2; ///< bytes

/// How the lent block is divided.
struct BlockPlan {
    std::size_t edges_at = 0;
    std::size_t cells_at;
    std::size_t steps_at;
    std::size_t backdrops_at;
    std::size_t size;

    BlockPlan(const SceneView& scene, Size panel)
        : cells_at{scene.max_edges() * sizeof(Edge)}, steps_at{cells_at +
                                                               CoverageRow::cells_for(panel.width) *
                                                                   sizeof(std::int32_t)},
          backdrops_at{steps_at + scene.paint_steps() * sizeof(PaintStep)}, size{backdrops_at +
                                                                                 backdrop_bytes(scene, panel)}
    {
    }

    static std::size_t backdrop_bytes(const SceneView& scene, Size panel)
    {
        return scene.blended_depth() * widest_pixel * static_cast<std::size_t>(panel.width);
    }
};

template <class T>
std::span<T> place(std::span<std::byte> block, std::size_t begin, std::size_t count)
{
    return {reinterpret_cast<T*>(block.data() + begin), count};
}

/// a b / 255, rounded to nearest.
constexpr std::uint32_t product_of_opacities(std::uint32_t a, std::uint32_t b) { return (a * b + 127) / 255; }

Pen pen_for(const ObjectStyle& style, Fixed width, const Affine& placement)
{
    return {.half_width = half_width(width, placement.growth()),
            .arc_pieces = static_cast<int>(style.arc_pieces),
            .cap = style.cap,
            .join = style.join,
            .miter_limit = style.miter_limit};
}

}

std::size_t Player::block_bytes(const SceneView& scene, Size panel) { return BlockPlan{scene, panel}.size; }

Result<Player> Player::create(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> block)
{
    if (block.size() < block_bytes(scene, panel))
        return Error::block_too_small;
    return Player{scene, panel, fit, block};
}

Player::Player(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> block)
    : scene_{scene}, panel_{panel}, canvas_{canvas_map(scene.canvas(), panel, fit)},
      steps_{place<PaintStep>(block, BlockPlan{scene, panel}.steps_at, scene.paint_steps())},
      edges_{place<Edge>(block, 0, scene.max_edges()), panel.height},
      coverage_{
          place<std::int32_t>(block, BlockPlan{scene, panel}.cells_at, CoverageRow::cells_for(panel.width)),
          panel.width},
      backdrops_{block.subspan(BlockPlan{scene, panel}.backdrops_at)}
{
    std::ranges::fill(
        place<std::int32_t>(block, BlockPlan{scene, panel}.cells_at, CoverageRow::cells_for(panel.width)), 0);
    show({});
}

void Player::show(Time time) { show_moment(wrap(time, scene_.length(), scene_.loop())); }

void Player::show_moment(Time moment)
{
    moment_ = std::clamp(moment, Time{}, scene_.length());
    edges_.clear();
    step_count_ = 0;
    next_row_ = 0;
    trace(scene_.items(), canvas_);
}

/// Calls itself no deeper than groups and uses may lie in each other, kfb::max_depth.
void Player::trace(ItemCursor items, const Affine& plane)
{
    PaintOrder order{items, moment_};
    while (const auto item = order.next())
        trace(*item, plane);
}

void Player::trace(const ItemView& item, const Affine& plane)
{
    const ItemState state{scene_, item, moment_};
    const std::uint32_t opacity = state.opacity();
    if (opacity == 0)
        return;
    if (opacity == 255 || !has_several_layers(item))
        return trace(item, state, opacity, plane);
    add_step(PaintStep::Kind::begin_blend);
    trace(item, state, 255, plane);
    add_step(PaintStep::Kind::end_blend).opacity = static_cast<std::uint8_t>(opacity);
}

void Player::trace(const ItemView& item, const ItemState& state, std::uint32_t opacity, const Affine& plane)
{
    const Affine placement = item.tracks.at_end() ? plane : plane * state.placement();
    switch (item.kind) {
    case ItemKind::object:
        return trace_object(item.object, state, opacity, placement);
    case ItemKind::group:
        return trace(ItemCursor{item.items}, placement);
    case ItemKind::use:
        return trace(scene_.symbol(item.symbol), placement);
    }
}

void Player::trace_object(const ObjectView& object, const ItemState& state, std::uint32_t opacity,
                          const Affine& placement)
{
    const auto [from, next] = interval_at(object.keys(), moment_);
    const Progress way = progress_between(from.time, next.time, moment_, scene_.laws(from.laws));
    const std::uint32_t to = object.has_arrivals ? from.arrival : next.drawing;
    const bool is_on_key = way.x == Way{} && way.y == Way{};
    const std::size_t first_step = step_count_;
    const ObjectStyle& style = object.style;
    ObjectOutline outline{from.curve_pieces};
    if (style.is_filled)
        outline.fill_into(edges_, add_layer(state.fill(), opacity, style.fill_rule));
    if (style.is_stroked)
        outline.stroke_into(edges_, add_layer(state.stroke(), opacity, FillRule::nonzero),
                            pen_for(style, state.width(), placement));
    LiveStrokes strokes{scene_.drawing(from.drawing), scene_.drawing(is_on_key ? from.drawing : to), way,
                        placement};
    strokes.trace(outline);
    for (PaintStep& step : steps_.subspan(first_step, step_count_ - first_step))
        edges_.sort(step.layer);
}

PaintStep& Player::add_step(PaintStep::Kind kind)
{
    PaintStep& step = steps_[step_count_++];
    step = {.kind = kind, .opacity = 255, .layer = {}};
    return step;
}

Layer& Player::add_layer(Colour colour, std::uint32_t opacity, FillRule rule)
{
    Layer& layer = add_step(PaintStep::Kind::layer).layer;
    colour.opacity = static_cast<std::uint8_t>(product_of_opacities(colour.opacity, opacity));
    layer.colour = colour;
    layer.rule = rule;
    return layer;
}

template <PixelFormat format>
void Player::draw_rows(int rows, std::span<std::byte> pixels)
{
    const std::size_t stride = row_bytes(format, panel_.width);
    for (std::byte* row = pixels.data(); rows > 0; --rows, row += stride)
        draw_row(PixelRow<format>{row}, stride);
}

template <class Row>
void Player::draw_row(Row row, std::size_t bytes)
{
    row.fill(0, panel_.width, Row::ink(scene_.colour(0)));
    std::size_t depth = 0;
    for (PaintStep& step : steps_.first(step_count_)) {
        switch (step.kind) {
        case PaintStep::Kind::layer:
            paint_layer(row, step.layer);
            break;
        case PaintStep::Kind::begin_blend:
            std::copy_n(row.row, bytes, backdrop(depth++).data());
            break;
        case PaintStep::Kind::end_blend:
            row.fade_from(backdrop(--depth).data(), panel_.width, step.opacity);
            break;
        }
    }
    ++next_row_;
}

template <class Row>
void Player::paint_layer(Row row, Layer& layer)
{
    sweep_row(edges_, layer, next_row_, coverage_);
    const std::uint32_t ink = Row::ink(layer.colour);
    const std::uint32_t opacity = layer.colour.opacity;
    coverage_.take_spans([&](int x, int count, std::int32_t level) {
        const std::uint32_t coverage = product_of_opacities(static_cast<std::uint32_t>(level), opacity);
        if (coverage == 255)
            row.fill(x, count, ink);
        else
            row.blend(x, count, ink, coverage);
    });
}

/// Where the row is kept while `depth` others are kept already.
std::span<std::byte> Player::backdrop(std::size_t depth)
{
    const std::size_t stride = widest_pixel * static_cast<std::size_t>(panel_.width);
    return backdrops_.subspan(depth * stride, stride);
}

template void Player::draw_rows<PixelFormat::rgb565>(int rows, std::span<std::byte> pixels);
template void Player::draw_rows<PixelFormat::grey4>(int rows, std::span<std::byte> pixels);
template void Player::draw_rows<PixelFormat::mono1>(int rows, std::span<std::byte> pixels);

}
