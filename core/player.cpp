#include "core/player.hpp"

#include "core/blending.hpp"
#include "core/live_strokes.hpp"
#include "core/paint_order.hpp"
#include "core/pixel_row.hpp"
#include "core/sweep.hpp"

#include <algorithm>
#include <optional>

namespace kfast {
namespace {

constexpr std::size_t widest_pixel = 2; ///< bytes
constexpr int pieces = 32;              ///< of a curve, and of half a turn of an arc

std::size_t edges_in(const SceneView& scene)
{
    return std::min<std::size_t>(scene.outline_bytes() / sizeof(Edge), Layer::no_edge - 1);
}

/// How the lent block is divided.
struct BlockPlan {
    std::size_t edges_at = 0;
    std::size_t cells_at;
    std::size_t steps_at;
    std::size_t bones_at;
    std::size_t nodes_at;
    std::size_t backdrops_at;
    std::size_t size;

    BlockPlan(const SceneView& scene, Size panel)
        : cells_at{edges_in(scene) * sizeof(Edge)}, steps_at{cells_at + CoverageRow::cells_for(panel.width) *
                                                                            sizeof(std::int32_t)},
          bones_at{steps_at + scene.paint_steps() * sizeof(PaintStep)}, nodes_at{bones_at +
                                                                                 scene.bone_count() *
                                                                                     sizeof(LiveBone)},
          backdrops_at{nodes_at + scene.backbone_nodes() * sizeof(BackboneNode)}, size{backdrops_at +
                                                                                       backdrop_bytes(scene,
                                                                                                      panel)}
    {
    }

    static std::size_t backdrop_bytes(const SceneView& scene, Size panel)
    {
        return scene.blended_depth() * widest_pixel * static_cast<std::size_t>(panel.width);
    }
};

static_assert(alignof(LiveBone) <= 4 && alignof(BackboneNode) <= 4 && sizeof(PaintStep) % 4 == 0);

template <class T>
std::span<T> place(std::span<std::byte> block, std::size_t begin, std::size_t count)
{
    return {reinterpret_cast<T*>(block.data() + begin), count};
}

/// a b / 255, rounded to nearest.
constexpr std::uint32_t product_of_opacities(std::uint32_t a, std::uint32_t b) { return (a * b + 127) / 255; }

Pen pen_for(const ObjectStyle& style, Fixed width, std::int32_t growth)
{
    return {.half_width = half_width(width, growth),
            .arc_pieces = pieces,
            .cap = style.cap,
            .join = style.join,
            .miter_limit = style.miter_limit};
}

Space canvas_space(Size canvas, Size panel, Fit fit)
{
    const Affine map = canvas_map(canvas, panel, fit);
    return {.plane = map, .zz = map.xx};
}

/// The canvas lies in the middle of the panel, and the viewer in front of it.
Camera camera_for(const SceneView& scene, Size panel, const Space& canvas)
{
    return {.x = std::int64_t{panel.width} * Fixed::one / 2,
            .y = std::int64_t{panel.height} * Fixed::one / 2,
            .distance = std::int64_t{scene.camera()} * canvas.zz};
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
    : scene_{scene}, panel_{panel}, canvas_{canvas_space(scene.canvas(), panel, fit)},
      camera_{camera_for(scene, panel, canvas_)}, edges_{place<Edge>(block, 0, edges_in(scene)),
                                                         panel.height},
      coverage_{
          place<std::int32_t>(block, BlockPlan{scene, panel}.cells_at, CoverageRow::cells_for(panel.width)),
          panel.width}
{
    const BlockPlan plan{scene, panel};
    steps_ = place<PaintStep>(block, plan.steps_at, scene.paint_steps());
    bones_ = place<LiveBone>(block, plan.bones_at, scene.bone_count());
    backbone_nodes_ = place<BackboneNode>(block, plan.nodes_at, scene.backbone_nodes());
    backdrops_ = block.subspan(plan.backdrops_at);
    std::ranges::fill(place<std::int32_t>(block, plan.cells_at, CoverageRow::cells_for(panel.width)), 0);
    set_up_bones(scene, bones_);
    show({});
}

void Player::show(Time time) { show_moment(wrap(time, scene_.length(), scene_.loop())); }

void Player::show_moment(Time moment)
{
    moment_ = std::clamp(moment, Time{}, scene_.length());
    edges_.clear();
    step_count_ = 0;
    next_row_ = 0;
    pose_bones(scene_, moment_, bones_);
    trace(scene_.items(), canvas_);
}

/// Calls itself no deeper than groups and uses may lie in each other, kfb::max_depth.
void Player::trace(ItemCursor items, const Space& space)
{
    PaintOrder order{items, moment_};
    while (const auto item = order.next())
        trace(*item, space);
}

void Player::trace(const ItemView& item, const Space& space)
{
    const ItemState state{scene_, item, moment_};
    const std::uint32_t opacity = state.opacity();
    if (opacity == 0)
        return;
    if (opacity == 255 || !has_several_layers(item))
        return trace(item, state, opacity, space);
    add_step(PaintStep::Kind::begin_blend);
    trace(item, state, 255, space);
    add_step(PaintStep::Kind::end_blend).opacity = static_cast<std::uint8_t>(opacity);
}

void Player::trace(const ItemView& item, const ItemState& state, std::uint32_t opacity, const Space& space)
{
    const Space placement = item.tracks.at_end() ? space : space * state.placement();
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
                          const Space& placement)
{
    const std::size_t first_step = step_count_;
    const ObjectStyle& style = object.style;
    const bool is_flat = placement.is_flat();
    const Projection projection{placement, camera_};
    const KeyInterval<Key> keys = interval_at(object.keys(), moment_);
    ObjectOutline outline{pieces, is_flat ? nullptr : &projection};
    if (style.is_filled)
        outline.fill_into(edges_, add_layer(state.fill(), opacity, style.fill_rule));
    if (style.is_stroked)
        outline.stroke_into(edges_, add_layer(state.stroke(), opacity, FillRule::nonzero),
                            pen_for(style, state.width(),
                                    is_flat ? placement.plane.growth()
                                            : projection.growth_at(first_point(object, keys.from))));
    trace_strokes(object, keys, is_flat ? placement.plane : Affine{}, outline);
    for (PaintStep& step : steps_.subspan(first_step, step_count_ - first_step))
        edges_.sort(step.layer);
}

void Player::trace_strokes(const ObjectView& object, const KeyInterval<Key>& keys, const Affine& placement,
                           ObjectOutline& outline)
{
    const auto& [from, next] = keys;
    const Progress way = progress_between(from.time, next.time, moment_, scene_.laws(from.laws));
    const bool is_on_key = way.x == Way{} && way.y == Way{};
    const CarriedDrawing begin = carried(object, from.drawing, from.skin);
    const std::uint32_t to = object.has_arrivals ? from.arrival : next.drawing;
    const CarriedDrawing end = is_on_key ? begin : carried(object, to, next.skin);
    std::optional<LiveBackbones> backbones;
    if (object.carrier == Carrier::backbones)
        backbones = backbones_of(object);
    LiveStrokes{begin, end, way, backbones ? &*backbones : nullptr, placement}.trace(outline);
}

CarriedDrawing Player::carried(const ObjectView& object, std::uint32_t drawing, std::uint32_t skin) const
{
    const PackedDrawing own = scene_.drawing(drawing);
    if (object.carrier != Carrier::bones)
        return CarriedDrawing{own};
    const SkinReader reader = scene_.skin(skin);
    return {own, reader.has_drawing_at_rest() ? scene_.drawing(reader.drawing_at_rest()) : own, reader,
            bones_.subspan(scene_.first_bone(object.skeleton))};
}

LiveBackbones Player::backbones_of(const ObjectView& object) const
{
    const auto [from, to] = interval_at(object.backbones.keys(), moment_);
    return {backbone_nodes_, object.backbones.unit_bits, scene_.drawing(from.drawing),
            scene_.drawing(to.drawing),
            progress_between(from.time, to.time, moment_, scene_.laws(from.laws))};
}

/// Of the drawing of a key, or of the backbones that carry it.
Point Player::first_point(const ObjectView& object, const Key& key) const
{
    const bool has_backbones = object.carrier == Carrier::backbones;
    PackedDrawing drawing =
        scene_.drawing(has_backbones ? object.backbones.keys().next().drawing : key.drawing);
    if (drawing.strokes() != 0)
        drawing.next_stroke();
    return drawing.start();
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
