#include "core/raster/edge_group.hpp"

#include "core/bytes/op_counter.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace kfast::raster {
namespace {

int step_of(const RowChain& chain) { return chain.runs_down ? 1 : -1; }

/// The windings that occur in a group.
class Windings {
public:
    explicit Windings(std::int32_t first) : min_{first}, max_{first} { note(first); }

    void note(std::int32_t winding)
    {
        min_ = std::min(min_, winding);
        max_ = std::max(max_, winding);
        has_zero_ = has_zero_ || winding == 0;
    }

    /// Whether sums of areas give the coverage.
    bool areas_add_up(FillRule rule) const
    {
        return max_ - min_ <= 1 || (rule == FillRule::nonzero && !has_zero_);
    }

private:
    std::int32_t min_;
    std::int32_t max_;
    bool has_zero_ = false;
};

/// For chains that are in order, calls visit(chain, sign) for those between inside and outside; sign is 1 if
/// the inside begins there.
template <class Visit>
void each_border(std::span<const RowChain> chains, FillRule rule, std::int32_t winding, Visit visit)
{
    bool was_inside = is_inside(rule, winding);
    for (const RowChain& chain : chains) {
        winding += step_of(chain);
        if (is_inside(rule, winding) == was_inside)
            continue;
        visit(chain, was_inside ? -1 : 1);
        was_inside = !was_inside;
    }
}

void add_in_order(std::span<const RowChain> chains, FillRule rule, std::int32_t winding, int columns,
                  CoverageSums& sums)
{
    each_border(chains, rule, winding, [&](const RowChain& chain, std::int32_t sign) {
        sums.add(edge_between(chain.top_x, chain.bottom_x), sign, columns);
    });
}

/// Two straight edges that follow each other cross at a height of a row, from its top, in part_height.
struct EdgeCrossing {
    std::int32_t height = CoverageSums::part_height; ///< this value: they do not cross
    std::size_t left = 0;                            ///< the number of the left edge
};

/// The next crossing below a height of the row. Edges that have not crossed are in order at the top.
EdgeCrossing next_crossing(std::span<const RowChain> chains, std::int32_t top)
{
    EdgeCrossing next;
    for (std::size_t i = 0; i + 1 != chains.size(); ++i) {
        const std::int32_t above = chains[i + 1].top_x - chains[i].top_x;
        const std::int32_t below = chains[i].bottom_x - chains[i + 1].bottom_x;
        if (below <= 0)
            continue;
        const auto way =
            static_cast<std::uint32_t>(std::max<std::int32_t>(above, 0)) * CoverageSums::part_height;
        const std::int32_t height =
            std::max(static_cast<std::int32_t>(way / static_cast<std::uint32_t>(above + below)), top);
        if (height < next.height)
            next = {height, i};
    }
    return next;
}

/// Rounded to nearest: the same for the part that ends at this height and the one that begins there.
std::int32_t x_at_height(const RowChain& chain, std::int32_t height)
{
    constexpr std::int32_t whole = CoverageSums::part_height;
    static_assert(whole == 1 << 10);
    return chain.top_x + (((chain.bottom_x - chain.top_x) * height + whole / 2) >> 10);
}

/// Adds only the edges between inside and outside, for straight edges that may cross: part by part of the
/// row, from crossing to crossing.
///
///     a   b c      they are in order at the top
///      \ / /
///       x /        b a c
///      / x
///     b c a        and in the end at the bottom
[[gnu::cold, gnu::noinline]] void add_crossing(std::span<RowChain> chains, FillRule rule,
                                               std::int32_t winding, int columns, CoverageSums& sums)
{
    EdgeCrossing next;
    for (std::int32_t top = 0; top != CoverageSums::part_height; top = next.height) {
        next = next_crossing(chains, top);
        if (next.height != top) // others cross where these did
            each_border(chains, rule, winding, [&](const RowChain& chain, std::int32_t sign) {
                sums.add_part(x_at_height(chain, top), x_at_height(chain, next.height),
                              sign * (next.height - top), columns);
            });
        if (next.height != CoverageSums::part_height)
            std::swap(chains[next.left], chains[next.left + 1]);
    }
}

/// Calls visit(line) for one line after another, as long as it returns true; true if there is none left.
template <class Visit>
bool each_line(std::span<const RowChain> chains, Visit visit)
{
    for (int number = 0; number != SampleLine::count_in_row; ++number) {
        SampleLine line{number};
        line.begin_part();
        for (const RowChain& chain : chains)
            line.add(chain);
        if (!visit(line))
            return false;
    }
    return true;
}

/// Whether sums of areas give the coverage, by the windings on lines. Lines take much stack: not while areas
/// are added.
[[gnu::noinline]] bool areas_add_up_on_lines(std::span<const RowChain> chains, FillRule rule,
                                             std::int32_t winding)
{
    Windings windings{winding};
    return each_line(chains, [&](const SampleLine& line) {
        line.walk(winding, [&](std::int32_t passed) { windings.note(passed); });
        return windings.areas_add_up(rule);
    });
}

[[gnu::noinline]] void add_lines(std::span<const RowChain> chains, FillRule rule, std::int32_t winding,
                                 int columns, CoverageSums& sums)
{
    each_line(chains, [&](const SampleLine& line) {
        line.add_inside(rule, winding, columns, sums);
        return true;
    });
}

/// How chains that are in the order of their upper ends go through a row.
enum class GroupKind : std::uint8_t {
    in_order, ///< as straight edges that do not cross
    crossing, ///< as straight edges
    bent,
};

GroupKind kind_of(std::span<const RowChain> chains)
{
    if (!std::ranges::all_of(chains, &RowChain::is_straight))
        return GroupKind::bent;
    return std::ranges::is_sorted(chains, {}, &RowChain::bottom_x) ? GroupKind::in_order
                                                                   : GroupKind::crossing;
}

bool has_bends(const RowChain& chain) { return chain.bend->y <= chain.top + chain.to; }

/// Whether no corner of a chain is to the right of another one, or, if `sign` is -1, to the left of it, by
/// more than what is rounded; both go through the same part of the row, with their ends in order.
[[gnu::noinline]] bool stays_beside(const RowChain& chain, const RowChain& other, std::int32_t sign)
{
    if (!has_bends(chain))
        return true;
    // All of the other one is on this side.
    const std::int32_t side = has_bends(other) ? (sign > 0 ? other.first : other.last + 1) * grid
                              : sign > 0       ? std::min(other.top_x, other.bottom_x)
                                               : std::max(other.top_x, other.bottom_x);
    bool stays = true;
    chain.each_edge([&](std::int32_t, std::int32_t, std::int32_t x, std::int32_t y) {
        stays = stays && ((side - x) * sign >= 0 || (other.x_at(y) - x) * sign >= -1);
    });
    return stays;
}

bool are_apart(const RowChain& left, const RowChain& right)
{
    return stays_beside(left, right, 1) && stays_beside(right, left, -1);
}

/// Whether two chains do not cross: one continues where the other ends, or they are on either side of a part
/// of the row.
bool are_plain(const RowChain& a, const RowChain& b)
{
    if (a.runs_down == b.runs_down)
        return a.to <= b.from || b.to <= a.from;
    if (a.from != b.from || a.to != b.to)
        return false;
    if (a.top_x <= b.top_x && a.bottom_x <= b.bottom_x && are_apart(a, b))
        return true;
    return a.top_x >= b.top_x && a.bottom_x >= b.bottom_x && are_apart(b, a);
}

/// Whether the coverage is the sum of the areas of all chains. Straight edges that cross are cut in any case:
/// to find out would take as long.
bool areas_add_up(std::span<const RowChain> chains, GroupKind kind, FillRule rule, std::int32_t winding)
{
    if (kind == GroupKind::crossing)
        return false;
    if (kind == GroupKind::bent)
        return (chains.size() == 2 && are_plain(chains[0], chains[1])) ||
               areas_add_up_on_lines(chains, rule, winding);
    Windings windings{winding};
    for (const RowChain& chain : chains)
        windings.note(winding += step_of(chain));
    return windings.areas_add_up(rule);
}

/// The first pixel of a group, and the one after its last.
std::pair<int, int> columns_of(std::span<const RowChain> chains)
{
    std::pair<int, int> columns{chains[0].first, 0};
    for (const RowChain& chain : chains) {
        columns.first = std::min(columns.first, chain.first);
        columns.second = std::max(columns.second, chain.last + 1);
    }
    return columns;
}

/// Sorts by the upper ends, so that the order before does not matter.
[[gnu::noinline]] void sort(std::span<RowChain> chains)
{
    const auto is_before = [](const RowChain& a, const RowChain& b) {
        if (a.top_x != b.top_x)
            return a.top_x < b.top_x;
        return a.bottom_x < b.bottom_x || (a.bottom_x == b.bottom_x && step_of(a) > step_of(b));
    };
    for (std::size_t i = 1; i < chains.size(); ++i)
        for (std::size_t j = i; j != 0 && is_before(chains[j], chains[j - 1]); --j)
            std::swap(chains[j], chains[j - 1]);
}

}

void add_chain(const RowChain& chain, int columns, CoverageSums& sums)
{
    if (chain.is_straight)
        return sums.add(edge_between(chain.top_x, chain.bottom_x), step_of(chain), columns);
    constexpr std::int32_t unit = CoverageSums::part_height / grid;
    chain.each_edge([&](std::int32_t x, std::int32_t y, std::int32_t next_x, std::int32_t next_y) {
        sums.add_part(x, next_x, (next_y - y) * unit * step_of(chain), columns);
    });
}

std::int32_t add_group(std::span<RowChain> chains, FillRule rule, std::int32_t winding, int columns,
                       CoverageSums& sums)
{
    if (chains.size() == 1) {
        add_chain(chains[0], columns, sums);
        return winding + chains[0].height() / grid;
    }
    std::int32_t height = 0;
    for (const RowChain& chain : chains)
        height += chain.height();
    const std::int32_t right = winding + height / grid;
    const auto [first, behind] = columns_of(chains);
    if (behind <= 0) { // left of the tile
        sums.add_height(height);
        return right;
    }
    sort(chains);
    const GroupKind kind = kind_of(chains);
    if (areas_add_up(chains, kind, rule, winding)) {
        for (const RowChain& chain : chains)
            add_chain(chain, columns, sums);
        return right;
    }
    count_op(Op::edge_group);
    begin_inside(first, rule, winding, columns, sums);
    switch (kind) {
    case GroupKind::in_order:
        add_in_order(chains, rule, winding, columns, sums);
        break;
    case GroupKind::crossing:
        add_crossing(chains, rule, winding, columns, sums);
        break;
    case GroupKind::bent:
        add_lines(chains, rule, winding, columns, sums);
        break;
    }
    end_inside(behind, rule, right, columns, sums);
    return right;
}

void begin_inside(int column, FillRule rule, std::int32_t winding, int columns, CoverageSums& sums)
{
    sums.add_windings(column, (is_inside(rule, winding) ? 1 : 0) - winding, columns);
}

void end_inside(int column, FillRule rule, std::int32_t winding, int columns, CoverageSums& sums)
{
    sums.add_windings(column, winding - (is_inside(rule, winding) ? 1 : 0), columns);
}

}
