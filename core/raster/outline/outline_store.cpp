#include "core/raster/outline/outline_store.hpp"

#include "core/bytes/op_counter.hpp"
#include "core/raster/outline/chain.hpp"
#include "core/raster/outline/grid.hpp"
#include "core/raster/outline/simplify.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>

namespace kfast::raster {
namespace {

constexpr std::int32_t margin = 32 * grid; ///< to the left and right of the panel
constexpr std::int32_t reach = 1 << ChainBuilder::reach_bits;
/// All corners on such a panel and its margins are in reach.
constexpr int small_panel = (reach - 2 * margin) / grid - 1;

/// An edge that is higher is a chain of its own, which takes less memory: crossings would take more than a
/// straight line and a further chain.
constexpr std::int32_t long_edge = 40 * grid;
/// Corners of chains on large panels are no further away: their columns have 16 bits.
constexpr std::int32_t farthest = 1 << 20;

/// How far apart the corners of a run are: a chain has no room for more.
class Reach {
public:
    explicit Reach(Corner first) : left_{first.x}, right_{first.x}, y_{first.y} {}

    /// Returns false if a corner is too far away.
    bool take(Corner corner)
    {
        if (std::abs(corner.x) >= farthest)
            return false;
        left_ = std::min(left_, corner.x);
        right_ = std::max(right_, corner.x);
        return right_ - left_ < reach / 2 - grid && std::abs(corner.y - y_) < ChainBuilder::max_height - grid;
    }

private:
    std::int32_t left_;
    std::int32_t right_;
    std::int32_t y_;
};

/// Whether no edge is longer than a chain can represent.
[[gnu::cold, gnu::noinline]] bool has_short_edges(const Corner* first, const Corner* end)
{
    for (const Corner* corner = first; corner != end; ++corner)
        if (!Reach{*corner}.take(corner + 1 == end ? *first : corner[1]))
            return false;
    return true;
}

/// Where an edge crosses a height that is between its ends.
Corner corner_on(Corner upper, Corner lower, std::int32_t y)
{
    return {interpolate(upper.x, lower.x, y - upper.y, lower.y - upper.y), y};
}

}

OutlineStore::OutlineStore(std::span<std::byte> storage, std::span<std::uint32_t> heads, Size panel,
                           int band_bits)
    : bytes_{storage.data()},
      heads_{heads},
      size_{storage.size()},
      panel_{panel},
      band_bits_{band_bits},
      is_large_{panel.width > small_panel || panel.height > small_panel}
{
    clear();
}

void OutlineStore::clear()
{
    chains_ = bytes_ + size_;
    begin_picture();
}

/// Begins with all layers that there are.
void OutlineStore::begin_picture()
{
    layer_ = nullptr;
    kept_ = bytes_ + size_;
    kept_end_ = chains_;
    waiting_ = static_cast<std::size_t>(kept_ - kept_end_);
    needed_ = 0;
    is_full_ = false;
    begin_contour();
    std::ranges::fill(heads_, Chain::none);
}

void OutlineStore::begin_layer(LayerName name, std::uint16_t step)
{
    layer_ = nullptr;
    if (!reserve(sizeof(LayerOutlines)))
        return;
    layer_ = new (chains_ - sizeof(LayerOutlines)) LayerOutlines;
    layer_->item = name.item;
    layer_->part = name.part;
    layer_->step = step;
    end_chains_at(reinterpret_cast<std::byte*>(layer_));
}

const LayerOutlines* OutlineStore::end_layer(const Dependence& dependence)
{
    if (layer_ != nullptr)
        layer_->dependence = dependence;
    return layer_;
}

void OutlineStore::begin_contour()
{
    corners_end_ = reinterpret_cast<Corner*>(bytes_);
    behind_ = reinterpret_cast<Corner*>(chains_);
}

bool OutlineStore::reserve(std::size_t bytes)
{
    const auto free = static_cast<std::size_t>(reinterpret_cast<std::byte*>(behind_) -
                                               reinterpret_cast<std::byte*>(corners_end_));
    const std::size_t taken = size_ - free - waiting_ + bytes;
    needed_ = std::max(needed_, taken);
    if (layer_ != nullptr) {
        const auto above = static_cast<std::size_t>(bytes_ + size_ - reinterpret_cast<std::byte*>(layer_));
        layer_->peak_bytes =
            std::max(layer_->peak_bytes, static_cast<std::uint32_t>(taken + waiting_ - above));
    }
    is_full_ = is_full_ || bytes > free;
    return !is_full_;
}

void OutlineStore::add_behind(Corner corner)
{
    count_op(Op::corner);
    if (corners_end_ + 1 > behind_)
        is_full_ = true;
    else
        *--behind_ = corner;
}

void OutlineStore::close()
{
    if (is_full_)
        return begin_contour();
    corners_end_ = std::copy(behind_, reinterpret_cast<Corner*>(chains_), corners_end_);
    behind_ = reinterpret_cast<Corner*>(chains_);
    if (map_ != nullptr)
        place_corners();
    add_contour();
}

/// Adds the complete contour, from first_corner() to corners_end_.
void OutlineStore::add_contour()
{
    std::int32_t columns = 0;
    for (const Corner* corner = first_corner(); corner != corners_end_; ++corner)
        columns |= corner->x + margin;
    if (!is_named_)
        layer_->fingerprint.add(std::span<const Corner>{first_corner(), corners_end_});
    const bool is_near = is_large_ ? has_short_edges(first_corner(), corners_end_) : (columns & -reach) == 0;
    std::byte* const mark = chains_;
    if (reserve(0) && !add_runs(is_near)) {
        const CutContour cut = cut_far_contour(first_corner(), corners_end_, behind_, {-margin, 0},
                                               {panel_.width * grid + margin, panel_.height * grid});
        corners_end_ = cut.peak;
        reserve(0);
        corners_end_ = cut.end;
        if (cut.end == nullptr || !add_runs(false))
            is_full_ = true;
    }
    if (is_full_) // a part of the contour would enclose nothing
        remove_chains(mark);
    begin_contour();
}

/// Where the outline changes from down to up or from up to down for the first time; null if it encloses
/// nothing.
Corner* OutlineStore::first_turn() const
{
    std::int32_t sense = 0;
    for (Corner* corner = first_corner(); corner + 1 < corners_end_; ++corner) {
        const std::int32_t rise = corner[1].y - corner->y;
        if (rise == 0)
            continue;
        if (sense != 0 && (rise ^ sense) < 0)
            return corner;
        sense = rise;
    }
    return sense == 0 ? nullptr : corners_end_ - 1; // it changes direction where it closes, at the latest
}

/// Begins where the contour changes direction, so that no chain is cut in two. Returns false, adding nothing,
/// if corners are out of reach: they are in reach if `is_near`.
bool OutlineStore::add_runs(bool is_near)
{
    Corner* const end = corners_end_;
    Corner* const turn = first_turn();
    if (turn == nullptr || !reserve(sizeof(Corner) * static_cast<std::size_t>(turn + 1 - first_corner())))
        return true;
    std::byte* const mark = chains_;
    corners_end_ = std::copy(first_corner(), turn + 1, end);
    if (find_runs(turn, corners_end_ - 1, is_near))
        return true;
    remove_chains(mark);
    corners_end_ = end;
    return false;
}

/// Divides the corners from `first` to `last`, at both of which the contour changes direction, into runs that
/// go all the way down or up, and long edges: from the end, so that corners of a run that was added need no
/// room any more, if that is wanted. Level edges between two runs belong to the one before them.
bool OutlineStore::find_runs(Corner* first, Corner* last, bool frees_corners)
{
    for (Corner* end = last; end != first;) {
        Corner* const begin = begin_of_run(first, end);
        if (!add_run(begin, end, begin->y < end->y))
            return false;
        if (frees_corners)
            corners_end_ = begin + 1;
        end = begin;
    }
    return true;
}

/// Where the run that ends at `end` begins: a long edge, level edges before one, or edges in one direction.
Corner* OutlineStore::begin_of_run(Corner* first, Corner* end) const
{
    Reach reached{*end};
    const auto is_in_reach = [&](const Corner& corner) { return !is_large_ || reached.take(corner); };
    Corner* begin = end - 1;
    is_in_reach(*begin); // the first edge is taken in any case
    while (begin != first && begin->y == end->y && is_in_reach(begin[-1]))
        --begin;
    const std::int32_t rise = end->y - begin->y;
    if (std::abs(rise) > long_edge)
        return begin + 1 == end ? begin : begin + 1;
    const std::int32_t sense = rise < 0 ? -1 : 1;
    const auto next_rise = [&] { return (begin->y - begin[-1].y) * sense; };
    const auto goes_on = [&] { return static_cast<std::uint32_t>(next_rise()) <= long_edge; }; // nor turns
    while (begin != first && goes_on() && is_in_reach(begin[-1]))
        --begin;
    if (rise != 0 && begin != first && next_rise() < 0)
        while (begin->y == begin[1].y)
            ++begin;
    return begin;
}

/// Level edges at an end that is on the border of a band, however high it is, do not matter for the band.
/// Others belong to what is not alike in all rows, also if a long outline was divided so that nothing else is
/// left in a run.
bool OutlineStore::add_run(Corner* first, Corner* last, bool runs_down)
{
    const auto is_level = [](const Corner& a, const Corner& b) {
        return a.y == b.y && (a.y & ((grid << max_band_bits) - 1)) == 0;
    };
    while (last != first && is_level(last[-1], *last))
        --last;
    while (last != first && is_level(*first, first[1]))
        ++first;
    return runs_down ? add_cut(first, last, 1) : add_cut(last, first, -1);
}

/// Cuts off what is above or below the panel. Corners are restored: the next run has them, too.
bool OutlineStore::add_cut(Corner* top, Corner* bottom, std::ptrdiff_t step)
{
    const std::int32_t height = panel_.height * grid;
    if (top == bottom || bottom->y <= 0 || top->y >= height)
        return true;
    while (top[step].y <= 0)
        top += step;
    while (bottom[-step].y >= height)
        bottom -= step;
    const Corner whole_top = *top;
    const Corner whole_bottom = *bottom;
    if (top->y < 0)
        *top = corner_on(*top, top[step], 0);
    if (bottom->y > height)
        *bottom = corner_on(bottom[-step], whole_bottom, height);
    const bool is_added = add_chain(top, bottom, step);
    *top = whole_top;
    *bottom = whole_bottom;
    return is_added;
}

/// Returns false if corners are out of reach.
bool OutlineStore::add_chain(const Corner* top, const Corner* bottom, std::ptrdiff_t step)
{
    if (is_large_ && std::abs(top->x) >= farthest)
        return false;
    const std::int32_t left = is_large_ ? (top->x & -grid) - reach / 2 : -margin;
    if (top + step == bottom &&
        ChainBuilder::crossing_bytes(top->y, bottom->y) + sizeof(Bend) > sizeof(StraightLine))
        return add_straight(*top, *bottom, left, step > 0);
    const auto corners = static_cast<std::size_t>((bottom - top) * step + 1);
    const std::size_t bytes = ChainBuilder::room_for(corners, top->y, bottom->y) + sizeof(Chain);
    is_full_ = is_full_ || bytes > Chain::max_bytes;
    if (!reserve(bytes))
        return true;
    ChainBuilder builder;
    if (!builder.build(top, bottom, step, left, chains_))
        return false;
    count_op(Op::crossing, ChainBuilder::crossing_bytes(top->y, bottom->y) / sizeof(Crossing));
    rewind(put_chain(builder.memory_begin(), *top, *bottom, left, step > 0));
    return true;
}

bool OutlineStore::add_straight(Corner top, Corner bottom, std::int32_t left, bool runs_down)
{
    const std::int32_t top_x = top.x - left;
    const std::int32_t bottom_x = bottom.x - left;
    if (((top_x | bottom_x) & -reach) != 0 || bottom.y - (top.y & -grid) > ChainBuilder::max_height)
        return false;
    if (!reserve(sizeof(Chain) + sizeof(StraightLine)))
        return true;
    auto* const line = new (chains_ - sizeof(StraightLine)) StraightLine;
    line->top = static_cast<Crossing>(top_x);
    line->bottom.x = static_cast<Crossing>(bottom_x);
    line->slope = slope_of(bottom_x - top_x, bottom.y - top.y);
    Chain& chain = put_chain(reinterpret_cast<std::byte*>(line), top, bottom, left, runs_down);
    chain.is_straight = true;
    rewind(chain);
    return true;
}

/// Puts it before its bends, or before its line.
Chain& OutlineStore::put_chain(std::byte* end, Corner top, Corner bottom, std::int32_t left, bool runs_down)
{
    const std::byte* const above = chains_;
    end_chains_at(end - sizeof(Chain));
    count_op(Op::chain);
    auto* const chain = new (chains_) Chain;
    chain->top = top.y;
    chain->bottom = bottom.y;
    chain->left = static_cast<std::int16_t>(floor_pixel(left));
    chain->layer = layer_->step;
    chain->runs_down = runs_down;
    chain->words = static_cast<std::uint16_t>((above - chains_) / 4);
    layer_->reach(floor_pixel(top.y), std::max(ceil_pixel(bottom.y), floor_pixel(top.y) + 1));
    return *chain;
}

/// Sets the end of the chains of the layer that is being added.
void OutlineStore::end_chains_at(std::byte* chains)
{
    chains_ = chains;
    behind_ = reinterpret_cast<Corner*>(chains);
    layer_->bytes = static_cast<std::uint32_t>(reinterpret_cast<std::byte*>(layer_) - chains);
}

void OutlineStore::rewind(int band_bits)
{
    band_bits_ = band_bits;
    std::ranges::fill(heads_, Chain::none);
    each_layer([this](LayerOutlines& layer) {
        if (layer.step != LayerOutlines::no_step)
            each_chain_of(layer, [this](Chain& chain) { rewind(chain); });
    });
}

void OutlineStore::rewind(Chain& chain)
{
    const std::uint32_t place = place_of(&chain);
    const std::uint32_t end = place + 4U * chain.words;
    const int row = floor_pixel(chain.top);
    const int band = row >> band_bits_;
    if (chain.is_straight) {
        chain.crossings = end - std::uint32_t{sizeof(StraightLine) - offsetof(StraightLine, in_band)};
        chain.bends = end - std::uint32_t{sizeof(StraightLine) - offsetof(StraightLine, bottom)};
    } else {
        const std::uint32_t crossings = end - ChainBuilder::crossing_bytes(chain.top, chain.bottom);
        const auto rows_above = static_cast<std::uint32_t>(row - (band << band_bits_));
        chain.crossings = crossings - rows_above * std::uint32_t{sizeof(Crossing)};
        chain.bends = crossings - std::uint32_t{sizeof(Bend)};
    }
    chain.next = std::exchange(heads_[static_cast<std::size_t>(band)], place);
}

/// Removes the chains that were added since the mark.
void OutlineStore::remove_chains(std::byte* mark)
{
    end_chains_at(mark);
    rewind(band_bits_);
}

}
