#include "core/raster/outline/simplify.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace kfast::raster {

namespace {

/// An edge replaces no more than these, so that each corner is looked at a few times at most.
constexpr std::ptrdiff_t max_replaced = 8;

/// The maximum extent of an edge that replaces others, to either side: products have 32 bits.
constexpr std::int32_t max_extent = 256 * grid;

/// The length of a vector, at most 12 % too small or 4 % too large.
std::int32_t length(std::int32_t x, std::int32_t y)
{
    const std::int32_t a = std::abs(x);
    const std::int32_t b = std::abs(y);
    return std::max(a, b) + std::min(a, b) / 4;
}

/// Whether the corners between two others are near the straight line from one to the other, and beside it.
bool are_near_line(const Corner* from, const Corner* to)
{
    const std::int32_t width = to->x - from->x;
    const std::int32_t height = to->y - from->y;
    if (std::abs(width) > max_extent || std::abs(height) > max_extent)
        return false;
    const std::int32_t square = width * width + height * height;
    const std::int32_t limit = simplify_tolerance * length(width, height);
    for (const Corner* corner = from + 1; corner != to; ++corner) {
        const std::int32_t x = corner->x - from->x;
        const std::int32_t y = corner->y - from->y;
        if (std::abs(x) > max_extent || std::abs(y) > max_extent)
            return false;
        const std::int32_t along = x * width + y * height;
        if (square == 0 && (x | y) != 0) // there and back
            return false;
        if (along < 0 || along > square || std::abs(x * height - y * width) > limit)
            return false;
    }
    return true;
}

}

Corner* simplify(Corner* first, Corner* end)
{
    Corner* out = first;
    for (const Corner* corner = first; end - corner > 1;) {
        const Corner* next = corner + 1;
        const Corner* const farthest = std::min<const Corner*>(end - 1, corner + max_replaced);
        while (next != farthest && are_near_line(corner, next + 1))
            ++next;
        corner = next;
        *++out = *next;
    }
    return first == end ? end : out + 1;
}

namespace {

/// Adds corners after others, up to a limit.
class CornerList {
public:
    CornerList(Corner* end, Corner* limit) : end_{end}, limit_{limit} {}

    void add(Corner corner)
    {
        if (end_ + 1 > limit_) // the limit need not be a whole number of corners away
            has_overflown_ = true;
        else
            *end_++ = corner;
    }

    Corner* end() const { return end_; }
    bool has_overflown() const { return has_overflown_; }

private:
    Corner* end_;
    Corner* limit_;
    bool has_overflown_ = false;
};

/// Writes a contour anew, edge by edge: add_edge(list, from, to) adds what replaces the edge after `from`.
template <class AddEdge>
[[gnu::cold, gnu::noinline]] CutContour rewrite(Corner* first, CutContour contour, Corner* limit,
                                                AddEdge add_edge)
{
    if (contour.end == nullptr)
        return contour;
    CornerList list{contour.end, limit};
    Corner from = contour.end[-1];
    for (const Corner* to = first; to != contour.end; ++to) {
        add_edge(list, from, *to);
        from = *to;
    }
    Corner* const end = list.has_overflown() ? nullptr : std::copy(contour.end, list.end(), first);
    return {end, std::max(contour.peak, list.end())};
}

/// Clamps the contour between two lines: `along` is Corner::x for upright lines, then `across` is y.
CutContour clamp(Corner* first, CutContour contour, Corner* limit, std::int32_t Corner::*along,
                 std::int32_t Corner::*across, std::int32_t low, std::int32_t high)
{
    return rewrite(first, contour, limit, [=](CornerList& list, Corner from, Corner to) {
        const auto add_crossing = [&](std::int32_t line) {
            if ((from.*along < line) == (to.*along < line) || from.*along == line || to.*along == line)
                return;
            Corner at;
            at.*along = line;
            at.*across = interpolate(from.*across, to.*across, std::abs(line - from.*along),
                                     std::abs(to.*along - from.*along));
            list.add(at);
        };
        const bool grows = from.*along < to.*along;
        add_crossing(grows ? low : high);
        add_crossing(grows ? high : low);
        to.*along = std::clamp(to.*along, low, high);
        list.add(to);
    });
}

CutContour divide_edges(Corner* first, CutContour contour, Corner* limit)
{
    return rewrite(first, contour, limit, [](CornerList& list, Corner from, Corner to) {
        const std::int32_t length = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
        const auto pieces = static_cast<std::int32_t>(static_cast<std::uint32_t>(length) / max_far_edge) + 1;
        for (std::int32_t i = 1; i < pieces; ++i)
            list.add({interpolate(from.x, to.x, i, pieces), interpolate(from.y, to.y, i, pieces)});
        list.add(to);
    });
}

}

CutContour cut_far_contour(Corner* first, Corner* end, Corner* limit, Corner upper_left, Corner lower_right)
{
    CutContour contour{end, end};
    contour = clamp(first, contour, limit, &Corner::y, &Corner::x, upper_left.y, lower_right.y);
    contour = clamp(first, contour, limit, &Corner::x, &Corner::y, upper_left.x, lower_right.x);
    return divide_edges(first, contour, limit);
}

}
