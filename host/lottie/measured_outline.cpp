#include "host/lottie/measured_outline.hpp"

#include "host/art/curve_length.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace kfast::lottie {
namespace {

using scene::Curve;
using scene::Outline;
using scene::Spot;

Spot between(Spot from, Spot to, double share) { return from + share * (to - from); }

/// What lies before the parameter `t`, and what behind it, with where that begins.
std::pair<Curve, std::pair<Spot, Curve>> cut(Spot from, const Curve& curve, double t)
{
    const Spot middle = art::spot_on(from, curve, t);
    if (!curve.cubic)
        return {scene::line_to(middle), {middle, curve}};
    const Spot a = between(from, curve.c1, t);
    const Spot b = between(curve.c1, curve.c2, t);
    const Spot c = between(curve.c2, curve.to, t);
    return {scene::cubic_to(a, between(a, b, t), middle),
            {middle, scene::cubic_to(between(b, c, t), c, curve.to)}};
}

/// Pieces that are longer have two ends even when rounded.
constexpr double shortest_piece = 0.1;

}

MeasuredOutline::MeasuredOutline(const Outline& outline) : closed_{outline.closed}
{
    Spot from = outline.from;
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

Spot MeasuredOutline::at(double length) const
{
    if (segments_.empty())
        return {};
    const auto end = std::ranges::lower_bound(ends_, length);
    const auto index =
        static_cast<std::size_t>(std::distance(ends_.begin(), end == ends_.end() ? std::prev(end) : end));
    return art::spot_on(segments_[index].from, segments_[index].curve, parameter(index, length));
}

Outline MeasuredOutline::piece(Stretch stretch) const
{
    Outline outline;
    const double least = std::min(shortest_piece, length() / 1000);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        const double from = std::max(stretch.from, begin_of(i));
        const double to = std::min(stretch.to, ends_[i]);
        const bool is_whole = from == begin_of(i) && to == ends_[i];
        if (to <= from || (!is_whole && to - from < least))
            continue;
        auto [begin, curve] = segments_[i];
        const double first = parameter(i, from);
        if (to < ends_[i])
            curve = cut(begin, curve, parameter(i, to)).first;
        if (first > 0)
            std::tie(begin, curve) =
                cut(begin, curve, to < ends_[i] ? first / parameter(i, to) : first).second;
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
