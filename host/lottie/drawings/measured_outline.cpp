#include "host/lottie/drawings/measured_outline.hpp"

#include "host/art/geometry/cubic_piece.hpp"
#include "host/art/geometry/curve_length.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace kfast::lottie {
namespace {

using scene::Curve;
using scene::Outline;
using scene::Vec2;

/// Between two parameters, with where it begins.
std::pair<Vec2, Curve> part(Vec2 from, const Curve& curve, double first, double last)
{
    if (first <= 0 && last >= 1)
        return {from, curve};
    if (!curve.cubic)
        return {art::spot_on(from, curve, first), scene::line_to(art::spot_on(from, curve, last))};
    const art::CubicPiece piece = art::CubicPiece{{from, curve.c1, curve.c2, curve.to}}.between(first, last);
    return {piece.points[0], scene::cubic_to(piece.points[1], piece.points[2], piece.points[3])};
}

/// Pieces that are longer have two ends even when rounded.
constexpr double shortest_piece = 0.1;

}

MeasuredOutline::MeasuredOutline(const Outline& outline) : closed_{outline.closed}
{
    Vec2 from = outline.from;
    double length = 0;
    const auto add = [&](const Curve& curve) {
        segments_.push_back({from, curve});
        length += art::curve_length(from, curve);
        ends_.push_back(length);
        from = curve.to;
    };
    std::ranges::for_each(outline.curves, add);
    if (outline.closed && scene::distance(from, outline.from) > 0)
        add(scene::line_to(outline.from));
}

double MeasuredOutline::parameter(std::size_t index, double length) const
{
    return art::curve_parameter(segments_[index].from, segments_[index].curve, length - begin_of(index));
}

Outline MeasuredOutline::piece(Stretch stretch) const
{
    Outline outline;
    const double min = std::min(shortest_piece, length() / 1000);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        const double from = std::max(stretch.from, begin_of(i));
        const double to = std::min(stretch.to, ends_[i]);
        const bool is_whole = from == begin_of(i) && to == ends_[i];
        if (to <= from || (!is_whole && to - from < min))
            continue;
        const auto [begin, curve] =
            part(segments_[i].from, segments_[i].curve, parameter(i, from), parameter(i, to));
        if (outline.curves.empty())
            outline.from = begin;
        outline.curves.push_back(curve);
    }
    return outline;
}

void append(Outline& outline, Outline next)
{
    if (outline.curves.empty())
        outline = std::move(next);
    else
        std::ranges::move(next.curves, std::back_inserter(outline.curves));
}

}
