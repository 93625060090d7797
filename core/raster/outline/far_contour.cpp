#include "core/raster/outline/far_contour.hpp"

#include <algorithm>
#include <cstdlib>

namespace kfast::raster {
namespace {

/// Adds corners behind others, up to a limit.
class CornerList {
public:
    CornerList(Corner* end, Corner* limit) : end_{end}, limit_{limit} {}

    void add(Corner corner)
    {
        if (end_ + 1 > limit_) // its place need not be a whole number of corners away
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

/// Writes a contour anew, edge by edge: add_edge(list, from, to) adds what stands for the way behind `from`.
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

/// Moves what lies beyond two lines to these: `along` is Corner::x for upright lines, then `across` is y.
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
