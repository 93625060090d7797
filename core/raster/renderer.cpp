#include "core/raster/renderer.hpp"

#include "core/bytes/expects.hpp"
#include "core/bytes/op_counter.hpp"
#include "core/raster/band_painter.hpp"
#include "core/raster/packing.hpp"
#include "core/raster/record.hpp"

#include <algorithm>

namespace kfast::raster {
namespace {

/// As many rows as the granularity has, or four if it has fewer; less where a piece of four rows, as wide as
/// the granularity, would not fit into as many rows of the panel as the granularity has, which is what is
/// lent.
int band_bits_for(Size granularity, int columns)
{
    int bits = default_band_bits;
    while (1 << bits < granularity.height)
        ++bits;
    while (bits > 0 && 1 << bits > granularity.height && granularity.width << bits > columns)
        --bits;
    return bits;
}

/// Whether an area is as wide as another that ends where it begins: its pixels follow those of the other.
bool lies_below(Rect area, Rect above)
{
    return area.x == above.x && area.width == above.width && area.y == above.y + above.height;
}

void extend(Change& change, int rows, std::size_t bytes)
{
    change.area.height += rows;
    change.pixels = {change.pixels.data(), change.pixels.size() + bytes};
}

/// Cuts off rows of a band above and below those of the mask.
void trim_rows(RowMask rows, Rect& area)
{
    for (; (rows & 1) == 0 && area.height > 1; rows >>= 1) {
        ++area.y;
        --area.height;
    }
    while ((rows >> (area.height - 1)) == 0 && area.height > 1)
        --area.height;
}

int rounded_down(int value, int unit) { return value & -unit; }
int rounded_up(int value, int unit) { return (value + unit - 1) & -unit; }

}

void Renderer::begin()
{
    if (progress_ == Progress::begun)
        forget();
    progress_ = Progress::none;
    is_fresh_ = true;
    next_row_ = 0;
}

void Renderer::forget()
{
    record_.forget();
    shown_count_ = 0;
    knows_panel_ = false;
    progress_ = Progress::none;
}

int Renderer::unrecorded_bands() const { return record_.unknown_count(band_count()); }

int Renderer::band_count() const
{
    const int bits = picture_.outlines.band_bits();
    return (panel_.height + (1 << bits) - 1) >> bits;
}

/// Begins before the first band.
void Renderer::begin_pass(int band_bits)
{
    if (!is_fresh_ || picture_.outlines.band_bits() != band_bits)
        picture_.outlines.rewind(band_bits);
    is_fresh_ = false;
    next_row_ = 0;
    band_.begin(picture_.outlines, picture_.steps(), panel_);
    count_op(Op::step, static_cast<std::uint32_t>(picture_.step_count + shown_count_));
}

void Renderer::begin_changes(int band_bits)
{
    // After a picture that ended for want of room, it is not known what changes.
    if (picture_.outlines.is_full() || recorded_band_bits_ != band_bits)
        forget();
    recorded_band_bits_ = band_bits;
    begin_pass(band_bits);
    record_.begin_picture();
    slots_.set_pictures(picture_.steps(), shown_storage_.first(shown_count_));
    find_changed_bands();
    regions_.clear();
    next_region_ = regions_.begin();
    progress_ = Progress::begun;
}

void Renderer::find_changed_bands()
{
    const int bits = picture_.outlines.band_bits();
    const auto add = [this, bits](RowRange rows) {
        changed_.add(rows.begin >> bits, (rows.end + (1 << bits) - 1) >> bits);
    };
    const std::span<const PaintStep> shown = shown_storage_.first(shown_count_);
    changed_.clear();
    has_same_numbers_ = true;
    for (const PaintStep& step : picture_.steps()) {
        if (step.kind == PaintStep::Kind::layer && !slots_.is_same(step)) {
            add(step.rows);
            if (step.partner != PaintStep::no_partner)
                add(shown[step.partner].rows);
        }
    }
    for (std::size_t number = 0; number != shown.size(); ++number) {
        const PaintStep& step = shown[number];
        has_same_numbers_ = has_same_numbers_ && step.partner == number;
        if (step.kind == PaintStep::Kind::layer && step.partner == PaintStep::no_partner)
            add(step.rows);
    }
}

void Renderer::end_changes()
{
    progress_ = Progress::done;
    knows_panel_ = !picture_.outlines.is_full();
    if (!knows_panel_)
        return;
    shown_count_ = picture_.step_count;
    std::ranges::copy(picture_.steps(), shown_storage_.begin());
}

/// Assigns slots to those layers that have chains in the band.
bool Renderer::assign_slots(std::span<const Record::Border> shown)
{
    slots_.clear_marks();
    for (std::uint32_t place = band_.first(); place != Chain::none; place = band_.chain(place).next)
        Slots::mark(picture_.storage[band_.chain(place).layer]);
    for (const Record::Border& border : shown)
        Slots::mark(shown_storage_[border.layer]);
    const bool have_slots = slots_.assign();
    band_.take_slots();
    return have_slots;
}

template <class Cells>
bool Renderer::next_band(bool is_known, std::span<const Record::Border> shown)
{
    if (!slots_.hold_all()) {
        if (!assign_slots(shown)) {
            regions_.set_whole(panel_.width, band_.first());
            return false;
        }
        slots_.set_inks<Cells>();
    }
    band_.wind(slots_.even_odd);
    if (is_known)
        find_dirty(band_, shown, shown_storage_, slots_, panel_.width, regions_);
    else
        find_all(band_, slots_, panel_.width, regions_);
    return true;
}

/// The number of the next band that may differ from what the panel shows; what is known of those before it
/// stays known. The number of bands if there is none.
int Renderer::next_changed_band()
{
    const int count = band_count();
    int band = band_.number() + 1;
    for (; band != count && knows_panel_ && record_.is_known(band) && !changed_.has(band); ++band)
        record_.pass_band(band, has_same_numbers_ ? std::span<const PaintStep>{}
                                                  : shown_storage_.first(shown_count_));
    return band;
}

/// Returns false if there is none.
template <class Cells>
bool Renderer::next_dirty_band()
{
    for (;;) {
        const int number = next_changed_band();
        if (number == band_count())
            return false;
        band_.advance(number);
        const bool is_known = knows_panel_ && record_.is_known(number);
        const std::span<const Record::Border> shown = record_.begin_band(number);
        if (next_band<Cells>(is_known, shown))
            keep_band();
        else
            record_.drop_band();
        drawn_columns_ = 0;
        next_region_ = regions_.begin();
        if (!regions_.is_empty())
            return true;
    }
}

void Renderer::keep_band()
{
    for (std::uint32_t place = band_.first(); place != Chain::none; place = band_.chain(place).next)
        record_.add(band_.chain(place));
    record_.end_band();
}

/// Takes the regions that are still to be drawn, as far as gaps between them have at most `gap` columns or
/// are within a unit of the granularity. None if all are drawn.
Renderer::Window Renderer::next_window(int granularity, int gap)
{
    const Region* const end = regions_.end();
    while (next_region_ != end && next_region_->end <= drawn_columns_)
        ++next_region_;
    const Region* region = next_region_;
    if (region == end)
        return {};
    Window window{rounded_down(region->begin, granularity), region->end, region->rows};
    const auto belongs = [&](const Region& next) {
        return next.begin <= window.end + gap || next.begin < rounded_up(window.end, granularity);
    };
    for (++region; region != end && belongs(*region); ++region) {
        window.end = region->end;
        window.rows |= region->rows;
    }
    window.begin = std::max(window.begin, drawn_columns_);
    window.end = std::min(rounded_up(window.end, granularity), panel_.width);
    return window;
}

template <class Cells>
void Renderer::draw_tile(const Tile<Cells>& tile, LayerRow& row)
{
    using Cell = typename Cells::Cell;
    BandPainter<Cells> painter{
        band_,
        picture_.steps(),
        slots_,
        row,
        {reinterpret_cast<Cell*>(backdrops_.data()), backdrops_.size() / sizeof(Cell)}};
    const int right = tile.left + tile.columns;
    const Region* const end = regions_.end();
    const Region* region = next_region_;
    if (region != end && region->begin <= tile.left && region->end >= right)
        return painter.paint(*region, tile);
    Region gap; // between two regions, in a window that takes in both
    Tile<Cells> part = tile;
    while (part.left < right) {
        while (region != end && region->end <= part.left)
            ++region;
        const bool is_gap = region == end || region->begin > part.left;
        const int part_end =
            region == end ? right : std::min<int>(is_gap ? region->begin : region->end, right);
        if (is_gap)
            gap = region_between(band_, part.left, part_end);
        part.columns = part_end - part.left;
        painter.paint(is_gap ? gap : *region, part);
        part.cells += part.columns;
        part.left = part_end;
    }
}

/// Draws an area of the band.
template <PixelFormat format>
void Renderer::draw_area(const Rect& area, std::span<std::byte> pixels, LayerRow& row)
{
    using Pack = Packing<format>;
    using Cells = typename Pack::Cells;
    using Cell = typename Cells::Cell;
    constexpr int cells_of_tile = static_cast<int>(tile_bytes / sizeof(Cell));
    const int columns = std::min(tile_columns, cells_of_tile >> picture_.outlines.band_bits());
    alignas(4) std::array<Cell, Pack::is_direct ? 1 : cells_of_tile> cells;
    const std::size_t stride = row_bytes(format, area.width);
    for (int x = 0; x < area.width; x += columns) {
        Tile<Cells> tile{.left = area.x + x,
                         .columns = std::min(columns, area.width - x),
                         .first_row = area.y - band_.top_row(),
                         .rows = area.height};
        std::byte* const first = pixels.data() + row_bytes(format, x);
        if constexpr (Pack::is_direct) {
            tile.cells = reinterpret_cast<Cell*>(first);
            tile.stride = area.width;
            draw_tile(tile, row);
        } else {
            tile.cells = cells.data();
            tile.stride = columns;
            draw_tile(tile, row);
            for (int y = 0; y != area.height; ++y)
                Pack::pack(tile.cells + y * columns, tile.columns,
                           first + static_cast<std::size_t>(y) * stride, tile.left, area.y + y);
        }
    }
    count_ops_for(0);
    if constexpr (Pack::is_direct)
        Pack::finish(reinterpret_cast<Cell*>(pixels.data()),
                     static_cast<std::size_t>(area.width * area.height));
}

template <PixelFormat format>
std::span<const Change> Renderer::draw_changes(std::span<std::byte> pixels, Size granularity, int area_bytes)
{
    using Cells = typename Packing<format>::Cells;
    if (progress_ == Progress::done)
        return {};
    if (progress_ == Progress::none) {
        begin_changes(band_bits_for(granularity, panel_.width));
        slots_.set_inks<Cells>();
    }
    LayerRow row{sums_}; // on the stack: evaluation takes as much of it at other times
    std::size_t count = 0;
    const int gap = area_bytes * 8 / bits_per_pixel(format) >> picture_.outlines.band_bits();
    while (count != max_changes) {
        const Window window = next_window(granularity.width, gap);
        if (window.end == 0) {
            if (next_dirty_band<Cells>())
                continue;
            end_changes();
            break;
        }
        Rect area{window.begin, band_.top_row(), window.end - window.begin, band_.row_count()};
        if (granularity.height == 1 && window.rows != all_rows)
            trim_rows(window.rows, area);
        const auto rows = static_cast<std::size_t>(area.height);
        std::size_t bytes = row_bytes(format, area.width) * rows;
        if (bytes > pixels.size()) {
            if (count != 0)
                break; // it may find room in the next call
            const auto room = static_cast<int>(pixels.size() / rows) * 8 / bits_per_pixel(format);
            area.width = rounded_down(room, granularity.width);
            bytes = row_bytes(format, area.width) * rows;
        }
        draw_area<format>(area, pixels.first(bytes), row);
        // Whole rows go together; otherwise slow buses are busy for a long time without a break.
        if (count != 0 && area.width == panel_.width && lies_below(area, changes_[count - 1].area)) {
            extend(changes_[count - 1], area.height, bytes);
        } else {
            Change& change = changes_[count++];
            change.area = area;
            change.pixels = pixels.first(bytes);
        }
        pixels = pixels.subspan(bytes);
        drawn_columns_ = area.x + area.width;
    }
    return {changes_.data(), count};
}

template <PixelFormat format>
void Renderer::draw_rows(int first_row, int rows, std::span<std::byte> pixels)
{
    using Cells = typename Packing<format>::Cells;
    if (progress_ == Progress::begun)
        forget();
    const std::size_t stride = row_bytes(format, panel_.width);
    expects(first_row >= 0 && rows >= 0 && rows <= panel_.height - first_row &&
            pixels.size() >= stride * static_cast<unsigned>(rows));
    if (first_row == 0 || first_row != next_row_) {
        begin_pass(default_band_bits);
        slots_.set_pictures(picture_.steps(), {});
        slots_.set_inks<Cells>();
    }
    LayerRow row{sums_};
    for (; rows > 0;) {
        while (band_.number() < first_row >> default_band_bits) {
            band_.advance();
            next_band<Cells>(false, {});
            next_region_ = regions_.begin();
        }
        const int band_end = std::min(band_.top_row() + (1 << default_band_bits), panel_.height);
        const int part = std::min(rows, band_end - first_row);
        draw_area<format>({0, first_row, panel_.width, part},
                          pixels.first(stride * static_cast<std::size_t>(part)), row);
        pixels = pixels.subspan(stride * static_cast<std::size_t>(part));
        first_row += part;
        rows -= part;
    }
    next_row_ = first_row;
}

#define KFAST_INSTANTIATE(name, bits)                                                                        \
    template void Renderer::draw_rows<PixelFormat::name>(int, int, std::span<std::byte>);                    \
    template std::span<const Change> Renderer::draw_changes<PixelFormat::name>(std::span<std::byte>, Size,   \
                                                                               int);
KFAST_PIXEL_FORMATS(KFAST_INSTANTIATE)
#undef KFAST_INSTANTIATE

}
