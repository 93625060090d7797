#include "core/player.hpp"

#include "core/live_strokes.hpp"
#include "core/pixel_row.hpp"
#include "core/sweep.hpp"

#include <algorithm>

namespace kfast {
namespace {

/// How the lent block is divided: edges, then the cells of a row, then layers.
struct BlockPlan {
    std::size_t cells_at;
    std::size_t layers_at;
    std::size_t size;

    BlockPlan(const SceneView& scene, Size panel)
        : cells_at{scene.max_edges() * sizeof(Edge)}, layers_at{cells_at +
                                                                CoverageRow::cells_for(panel.width) *
                                                                    sizeof(std::int32_t)},
          size{layers_at + scene.layers() * sizeof(Layer)}
    {
    }
};

template <class T>
std::span<T> place(std::span<std::byte> block, std::size_t begin, std::size_t count)
{
    return {reinterpret_cast<T*>(block.data() + begin), count};
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
    : scene_{scene}, panel_{panel}, map_{scene.canvas(), panel, fit},
      layers_{place<Layer>(block, BlockPlan{scene, panel}.layers_at, scene.layers())},
      edges_{place<Edge>(block, 0, scene.max_edges()), panel.height},
      coverage_{
          place<std::int32_t>(block, BlockPlan{scene, panel}.cells_at, CoverageRow::cells_for(panel.width)),
          panel.width}
{
    std::ranges::fill(
        place<std::int32_t>(block, BlockPlan{scene, panel}.cells_at, CoverageRow::cells_for(panel.width)), 0);
    show({});
}

void Player::show(Time time)
{
    const Time moment = wrap(time, scene_.length(), scene_.loop());
    edges_.clear();
    next_row_ = 0;
    std::size_t layer = 0;
    ObjectCursor objects = scene_.objects();
    while (!objects.at_end())
        trace(objects.next(), moment, layer);
}

void Player::trace(const ObjectView& object, Time time, std::size_t& layer)
{
    const KeyInterval interval = object.interval_at(time);
    const Progress way = progress_at(interval, time);
    const bool is_on_key = way.x == Share{} && way.y == Share{};
    const std::size_t first_layer = layer;
    ObjectOutline outline{interval.from.curve_pieces};
    if (object.style.is_filled)
        outline.fill_into(edges_, begin_layer(layer++, object.style.fill));
    if (object.style.is_stroked)
        outline.stroke_into(edges_, begin_layer(layer++, object.style.stroke), pen_for(object.style));
    LiveStrokes strokes{scene_.drawing(interval.from),
                        scene_.drawing(is_on_key ? interval.from : interval.to), way, map_};
    strokes.trace(outline);
    for (std::size_t i = first_layer; i < layer; ++i)
        edges_.sort(layers_[i]);
}

Layer& Player::begin_layer(std::size_t index, std::uint8_t colour)
{
    layers_[index] = Layer{.colour = colour};
    return layers_[index];
}

Pen Player::pen_for(const ObjectStyle& style) const
{
    return {.half_width = map_.half_width(Fixed::from_raw(style.width * (Fixed::one / 32))),
            .arc_pieces = arc_pieces(style.width),
            .cap = style.cap,
            .join = style.join};
}

template <PixelFormat format>
void Player::draw_rows(int rows, std::span<std::byte> pixels)
{
    const std::size_t stride = row_bytes(format, panel_.width);
    for (std::byte* row = pixels.data(); rows > 0; --rows, row += stride)
        draw_row(PixelRow<format>{row});
}

template <class Row>
void Player::draw_row(Row row)
{
    row.fill(0, panel_.width, Row::ink(scene_.colour(0)));
    for (Layer& layer : layers_) {
        sweep_row(edges_, layer, next_row_, coverage_);
        const std::uint32_t ink = Row::ink(scene_.colour(layer.colour));
        coverage_.take_spans([&](int x, int count, std::int32_t level) {
            if (level == 255)
                row.fill(x, count, ink);
            else
                row.blend(x, count, ink, static_cast<std::uint32_t>(level));
        });
    }
    ++next_row_;
}

template void Player::draw_rows<PixelFormat::rgb565>(int rows, std::span<std::byte> pixels);
template void Player::draw_rows<PixelFormat::grey4>(int rows, std::span<std::byte> pixels);
template void Player::draw_rows<PixelFormat::mono1>(int rows, std::span<std::byte> pixels);

}
