#include "host/lottie/measured_outline.hpp"

#include "host/art/drawing.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace kfast::lottie {
namespace {

using scene::Curve;
using scene::Outline;
using scene::Spot;

Spot between(Spot from, Spot to, double share) { return from + share * (to - from); }

Spot spot_on(Spot from, const Curve& curve, double t)
{
    if (!curve.cubic)
        return between(from, curve.to, t);
    const double s = 1 - t;
    return s * s * s * from + 3 * s * s * t * curve.c1 + 3 * s * t * t * curve.c2 + t * t * t * curve.to;
}

double speed(Spot from, const Curve& curve, double t)
{
    const double s = 1 - t;
    const Spot way =
        3 * s * s * (curve.c1 - from) + 6 * s * t * (curve.c2 - curve.c1) + 3 * t * t * (curve.to - curve.c2);
    return scene::distance({}, way);
}

/// By the Gauss-Legendre rule of five nodes, in four parts.
double length_until(Spot from, const Curve& curve, double t)
{
    if (!curve.cubic)
        return t * scene::distance(from, curve.to);
    constexpr std::array<std::array<double, 2>, 5> nodes{{{0, 128.0 / 225},
                                                          {0.538469310105683091, 0.478628670499366468},
                                                          {-0.538469310105683091, 0.478628670499366468},
                                                          {0.906179845938663993, 0.236926885056189088},
                                                          {-0.906179845938663993, 0.236926885056189088}}};
    constexpr int parts = 4;
    const double half = t / parts / 2;
    double sum = 0;
    for (int part = 0; part < parts; ++part)
        for (const auto& [node, weight] : nodes)
            sum += weight * speed(from, curve, (2 * part + 1 + node) * half);
    return sum * half;
}

/// What lies behind the parameter `t`, and before it.
std::pair<Curve, std::pair<Spot, Curve>> cut(Spot from, const Curve& curve, double t)
{
    const Spot middle = spot_on(from, curve, t);
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
        length += length_until(from, curve, 1);
        ends_.push_back(length);
        from = curve.to;
    };
    std::ranges::for_each(outline.curves, add);
    if (outline.closed && scene::distance(from, outline.from) > 0)
        add(scene::line_to(outline.from));
}

double MeasuredOutline::parameter(std::size_t index, double length) const
{
    const auto& [from, curve] = segments_[index];
    const double wanted = length - begin_of(index);
    const double whole = ends_[index] - begin_of(index);
    if (wanted <= 0 || whole <= 0)
        return 0;
    if (wanted >= whole)
        return 1;
    double low = 0;
    double high = 1;
    double t = wanted / whole;
    if (!curve.cubic)
        return t;
    for (int step = 0; step < 40 && high - low > 1e-12; ++step) {
        const double off = length_until(from, curve, t) - wanted;
        (off < 0 ? low : high) = t;
        const double slope = speed(from, curve, t);
        const double next = slope > 0 ? t - off / slope : low;
        if (std::abs(off) < 1e-9 * whole)
            break;
        t = next > low && next < high ? next : (low + high) / 2;
    }
    return t;
}

Spot MeasuredOutline::at(double length) const
{
    if (segments_.empty())
        return {};
    const auto end = std::ranges::lower_bound(ends_, length);
    const auto index =
        static_cast<std::size_t>(std::distance(ends_.begin(), end == ends_.end() ? std::prev(end) : end));
    return spot_on(segments_[index].from, segments_[index].curve, parameter(index, length));
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
