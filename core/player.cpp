#include "core/player.hpp"

#include "core/block_cutter.hpp"
#include "core/match_pictures.hpp"
#include "core/row_painter.hpp"
#include "core/sweep.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::size_t widest_pixel = 3; ///< bytes
constexpr std::size_t span_count = 160; ///< for all rows of a strip

constexpr std::size_t whole_words(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

/// How the lent block is divided: one part after the other.
struct BlockPlan {
    std::size_t outlines; ///< bytes of each part
    std::size_t steps;
    std::size_t cells;
    std::size_t spans = span_count * sizeof(CoveredSpan);
    std::size_t backdrops;
    std::size_t live;

    BlockPlan(const SceneView& scene, Size panel, std::size_t live_bytes)
        : outlines{outline_bytes(scene, panel)}, steps{scene.paint_steps() * sizeof(PaintStep)},
          cells{CoverageRow::cells_for(panel.width) * sizeof(std::int32_t)},
          backdrops{
              whole_words(scene.blended_depth() * widest_pixel * static_cast<std::size_t>(panel.width))},
          live{live_bytes}
    {
    }

    std::size_t size() const { return 2 * (outlines + steps) + cells + spans + backdrops + live; }

    /// A panel that is larger than the canvas needs curves of more pieces: their number grows with the square
    /// root of the size, and doubles at a time.
    static std::size_t outline_bytes(const SceneView& scene, Size panel)
    {
        std::size_t bytes = scene.outline_bytes();
        Size reach = scene.canvas();
        for (; reach.width < panel.width || reach.height < panel.height; bytes *= 2)
            reach = {reach.width * 4, reach.height * 4};
        return bytes;
    }
};

static_assert(alignof(PaintStep) <= 4);

std::span<std::int32_t> zeroed(std::span<std::int32_t> cells)
{
    std::ranges::fill(cells, 0);
    return cells;
}

}

std::size_t Player::block_bytes(const SceneView& scene, Size panel)
{
    return BlockPlan{scene, panel, bytes_for(scene)}.size();
}

Result<Player> Player::create(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> block)
{
    const std::size_t bytes = block_bytes(scene, panel);
    if (block.size() < bytes)
        return Error::block_too_small;
    return Player{scene, panel, fit, block.first(bytes)};
}

/// What moves lies at the end, for it has any number of bytes.
Player::Player(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> block)
    : LiveScene{scene, panel, fit, block.last(bytes_for(scene))}, panel_{panel},
      background_{scene.colour(0)}, coverage_{{}, panel.width}, strips_{{}, panel}
{
    const BlockPlan plan{scene, panel, bytes_for(scene)};
    BlockCutter cutter{block};
    for (TracedPicture& picture : pictures_) {
        picture.outlines = OutlineStore{cutter.cut(plan.outlines), panel.height};
        picture.storage = cutter.cut_as<PaintStep>(plan.steps);
    }
    coverage_ = CoverageRow{zeroed(cutter.cut_as<std::int32_t>(plan.cells)), panel.width};
    strips_ = ChangedStrips{cutter.cut_as<CoveredSpan>(plan.spans), panel};
    backdrops_ = cutter.cut(plan.backdrops);
    trace({});
}

void Player::show(Time time) { show_moment(wrap(time, scene().length(), scene().loop())); }

void Player::show_moment(Time moment)
{
    moment = std::clamp(moment, Time{}, scene().length());
    next_row_ = 0;
    const std::uint32_t moved = take_moved();
    moved_since_shown_ |= moved;
    moved_since_coming_ |= moved;
    if (coming().still.holds(moment, moved_since_coming_))
        return;
    if (progress_ == Progress::done) {
        coming_ = 1 - coming_;
        moved_since_shown_ = moved_since_coming_;
        knows_panel_ = true;
    } else if (progress_ == Progress::begun) {
        knows_panel_ = false;
    }
    progress_ = Progress::none;
    trace(moment);
}

void Player::trace(Time time)
{
    const Moment moment = pose(time);
    const bool may_share = knows_panel_ && shown().coarseness == 0;
    Tracer{on_panel(), moment, coming(), may_share ? &shown() : nullptr, moved_since_shown_}.run();
    moved_since_coming_ = 0;
}

void Player::redraw()
{
    knows_panel_ = false;
    progress_ = Progress::none;
}

template <PixelFormat format>
void Player::draw_rows(int rows, std::span<std::byte> pixels)
{
    const std::size_t stride = row_bytes(format, panel_.width);
    for (; rows > 0; --rows, pixels = pixels.subspan(stride))
        paint_whole_row<format>(next_row_++, pixels.first(stride));
}

template <PixelFormat format>
std::span<const Change> Player::draw_changes(std::span<std::byte> pixels, Size granularity, int area_bytes)
{
    if (progress_ == Progress::done)
        return {};
    if (progress_ == Progress::none)
        begin_changes();
    constexpr int whole_bytes = pixels_in_whole_bytes(format);
    const int filling = (whole_bytes - panel_.width % whole_bytes) % whole_bytes;
    const int rows = static_cast<int>(pixels.size() / row_bytes(format, panel_.width));
    const AreaRules rules{.granularity = granularity,
                          .overhead = (area_bytes * 8 + bits_per_pixel(format) - 1) / bits_per_pixel(format),
                          .room = static_cast<std::size_t>(rows) *
                                  static_cast<std::size_t>(panel_.width + filling),
                          .filling = filling};
    const Strip& strip = knows_panel_ ? strips_.next(shown(), coming(), coverage_, rules)
                                      : next_whole_rows(rows - rows % granularity.height);
    if (strip.rows == 0) {
        progress_ = Progress::done;
        return {};
    }
    paint_strip<format>(strip, pixels);
    return std::span{changes_}.first(strip.columns.runs().size());
}

void Player::begin_changes()
{
    progress_ = Progress::begun;
    whole_rows_ = {};
    if (shown().outlines.is_full() || coming().outlines.is_full())
        knows_panel_ = false; // where a picture ends for want of room, nothing tells what changes
    if (!knows_panel_)
        return;
    match(shown(), coming(), moved_since_shown_);
    strips_.begin(shown(), coming());
}

/// As many of `rows` as there are.
const Strip& Player::next_whole_rows(int rows)
{
    const int top = whole_rows_.top + whole_rows_.rows;
    whole_rows_ = {.top = top, .rows = std::min(rows, panel_.height - top), .has_spans = false};
    whole_rows_.columns.add(0, panel_.width);
    return whole_rows_;
}

template <PixelFormat format>
void Player::paint_strip(const Strip& strip, std::span<std::byte> pixels)
{
    did(Work::strip);
    const std::span<const Run> runs = strip.columns.runs();
    std::array<RowWindow, RunList::most> windows;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::size_t bytes = row_bytes(format, runs[i].width());
        const auto area = pixels.first(bytes * static_cast<std::size_t>(strip.rows));
        pixels = pixels.subspan(area.size());
        windows[i] = {runs[i], area.data(), bytes};
        changes_[i] = {{runs[i].begin, strip.top, runs[i].width(), strip.rows}, area};
    }
    const std::span in_use = std::span{windows}.first(runs.size());
    for (int row = 0; row < strip.rows; ++row) {
        if (strip.has_spans)
            paint_swept<format>(in_use, strip.top + row, strips_.spans(row));
        else
            sweep_and_paint<format>(in_use, strip.top + row);
        for (RowWindow& window : in_use)
            window.first += window.bytes;
    }
}

template <PixelFormat format>
void Player::paint_whole_row(int row, std::span<std::byte> pixels)
{
    const RowWindow whole{{0, static_cast<std::int16_t>(panel_.width)}, pixels.data(), pixels.size()};
    sweep_and_paint<format>({&whole, 1}, row);
}

/// The topmost step that covers all windows wholly, as far as `spans` tell.
std::size_t Player::lowest_seen_step(std::span<const RowWindow> windows,
                                     std::span<const CoveredSpan> spans) const
{
    if (scene().blended_depth() != 0)
        return 0;
    const int begin = windows.front().columns.begin;
    const int end = windows.back().columns.end;
    for (auto span = spans.rbegin(); span != spans.rend(); ++span)
        if (span->level == 255 && span->begin <= begin && span->end >= end &&
            picture().steps()[span->step].layer.colour.opacity == 255)
            return span->step;
    return 0;
}

template <PixelFormat format>
void Player::paint_swept(std::span<const RowWindow> windows, int row, std::span<const CoveredSpan> spans)
{
    const std::size_t first = lowest_seen_step(windows, spans);
    while (!spans.empty() && spans.front().step < first)
        spans = spans.subspan(1);
    const CoveredSpan* span = spans.data();
    const CoveredSpan* const last = span + spans.size();
    painter<format>(windows, row).paint(coming(), first, background_, [&](std::size_t step, auto& paint) {
        const PaintStep& painted = coming().steps()[step];
        if (painted.change == PaintStep::Change::none) {
            const bool is_seen = painted.layer.left < windows.back().columns.end &&
                                 painted.layer.right > windows.front().columns.begin;
            return is_seen ? sweep_layer(step, row, paint) : void();
        }
        for (; span != last && span->step == step; ++span)
            paint(span->begin, span->end, span->level);
    });
}

template <PixelFormat format>
void Player::sweep_and_paint(std::span<const RowWindow> windows, int row)
{
    painter<format>(windows, row).paint(coming(), 0, background_, [&](std::size_t step, auto& paint) {
        sweep_layer(step, row, paint);
    });
}

template <class Paint>
void Player::sweep_layer(std::size_t step, int row, Paint& paint)
{
    sweep_row(coming().outlines, coming().steps()[step].layer, row, coverage_);
    coverage_.take_spans(paint);
}

template <PixelFormat format>
RowPainter<format> Player::painter(std::span<const RowWindow> windows, int row)
{
    return {windows, row, backdrops_, row_bytes(format, panel_.width)};
}

template void Player::draw_rows<PixelFormat::rgb565>(int, std::span<std::byte>);
template void Player::draw_rows<PixelFormat::rgb565_be>(int, std::span<std::byte>);
template void Player::draw_rows<PixelFormat::rgb444>(int, std::span<std::byte>);
template void Player::draw_rows<PixelFormat::rgb666>(int, std::span<std::byte>);
template void Player::draw_rows<PixelFormat::grey4>(int, std::span<std::byte>);
template void Player::draw_rows<PixelFormat::mono1>(int, std::span<std::byte>);
template void Player::draw_rows<PixelFormat::mono1_dithered>(int, std::span<std::byte>);
template std::span<const Change> Player::draw_changes<PixelFormat::rgb565>(std::span<std::byte>, Size, int);
template std::span<const Change> Player::draw_changes<PixelFormat::rgb565_be>(std::span<std::byte>, Size,
                                                                              int);
template std::span<const Change> Player::draw_changes<PixelFormat::rgb444>(std::span<std::byte>, Size, int);
template std::span<const Change> Player::draw_changes<PixelFormat::rgb666>(std::span<std::byte>, Size, int);
template std::span<const Change> Player::draw_changes<PixelFormat::grey4>(std::span<std::byte>, Size, int);
template std::span<const Change> Player::draw_changes<PixelFormat::mono1>(std::span<std::byte>, Size, int);
template std::span<const Change> Player::draw_changes<PixelFormat::mono1_dithered>(std::span<std::byte>, Size,
                                                                                   int);

}
