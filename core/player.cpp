#include "core/player.hpp"

#include "core/equalize.hpp"
#include "core/flatten.hpp"
#include "core/pixel_row.hpp"
#include "core/sweep.hpp"

#include <optional>

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

/// The share of the way between two keys, apart for x and y.
struct Progress {
    Share x;
    Share y;
};

Progress progress_at(const KeyInterval& interval, Time time)
{
    if (time <= interval.from.time)
        return {};
    const auto passed = static_cast<std::uint32_t>((time - interval.from.time).ticks);
    const auto whole = static_cast<std::uint32_t>((interval.to.time - interval.from.time).ticks);
    if (passed >= whole)
        return {};
    const Share share = Share::ratio(passed, whole);
    return {progress(interval.from.law_x, share), progress(interval.from.law_y, share)};
}

Segment mapped(const Segment& segment, const CanvasMap& map)
{
    if (segment.kind == Segment::Kind::line)
        return {.kind = segment.kind, .from = map(segment.from), .to = map(segment.to)};
    return {segment.kind, map(segment.from), map(segment.c1), map(segment.c2), map(segment.to)};
}

/// Feeds the live strokes of one object to its fill, its stroke or both.
class ObjectOutline {
public:
    explicit ObjectOutline(std::uint32_t curve_pieces) : curve_pieces_{curve_pieces} {}

    void fill_into(EdgeList& edges, Layer& layer) { fill_.emplace(edges, layer); }
    void stroke_into(EdgeList& edges, Layer& layer, const Pen& pen) { stroke_.emplace(edges, layer, pen); }

    void begin(Point at)
    {
        if (fill_)
            fill_->begin(at);
        if (stroke_)
            stroke_->begin(at);
    }

    void add(const Segment& segment)
    {
        flatten(segment, curve_pieces_, [this](Point to) {
            if (fill_)
                fill_->line_to(to);
            if (stroke_)
                stroke_->line_to(to);
        });
    }

    void end(Point hub, bool is_closed)
    {
        if (fill_)
            fill_->end(hub);
        if (stroke_)
            stroke_->end(is_closed);
    }

private:
    std::optional<FillOutline> fill_;
    std::optional<StrokeOutline> stroke_;
    std::uint32_t curve_pieces_;
};

/// The strokes between two drawings at one moment of their way, on the panel.
class LiveStrokes {
public:
    LiveStrokes(const PackedDrawing& from, const PackedDrawing& to, Progress way, const CanvasMap& map)
        : pair_{from, to}, way_{way}, map_{map}
    {
    }

    void trace(ObjectOutline& outline)
    {
        while (const std::uint32_t segments = pair_.next_stroke())
            trace_stroke(segments, outline);
    }

private:
    void trace_stroke(std::uint32_t segments, ObjectOutline& outline)
    {
        Pair<Segment> both = pair_.next_segment();
        const Pair<Point> first{both.a.from, both.b.from};
        Segment live = tweened(both);
        outline.begin(live.from);
        outline.add(live);
        for (std::uint32_t i = 1; i < segments; ++i) {
            both = pair_.next_segment();
            outline.add(tweened(both));
        }
        const bool ends_meet = first.a == both.a.to && first.b == both.b.to;
        const Pair<Point> hub = pair_.hub();
        outline.end(tweened({still_segment(hub.a), still_segment(hub.b)}).to, ends_meet && pair_.is_whole());
    }

    Segment tweened(const Pair<Segment>& both) const
    {
        return mapped(tween(both.a, both.b, way_.x, way_.y), map_);
    }

    EqualizedPair<PackedDrawing> pair_;
    Progress way_;
    const CanvasMap& map_;
};

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
