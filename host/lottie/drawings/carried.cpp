#include "host/lottie/drawings/carried.hpp"

#include "host/art/document/document.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace kfast::lottie {
namespace {

using art::Affine;
using art::Channel;

std::array<const Channel*, 9> flat_channels(const art::Transform& transform)
{
    return {&transform.anchor_x, &transform.anchor_y, &transform.x,
            &transform.y,        &transform.scale_x,  &transform.scale_y,
            &transform.rotate,   &transform.skew,     &transform.skew_axis};
}

bool is_shown(const std::vector<art::Span>& shown, double time)
{
    return std::ranges::any_of(shown,
                               [&](const art::Span& span) { return span.from <= time && time < span.to; });
}

template <typename AffineAt>
MovingDrawing mapped(MovingDrawing drawing, AffineAt affine_at)
{
    drawing.cost += drawing.points;
    drawing.at = [affine_at, at = std::move(drawing.at)](double time) {
        art::Drawing result = at(time);
        const Affine affine = affine_at(time);
        for (scene::Outline& outline : result.outlines)
            outline = affine.of(outline);
        return result;
    };
    return drawing;
}

/// Keys at the times when something appears or vanishes.
Channel jumps(const std::vector<art::Span>& shown)
{
    std::vector<art::Key<double>> keys;
    const auto add = [&](double time) {
        if (std::isfinite(time) && (keys.empty() || time > keys.back().time))
            keys.push_back({time, 0, {.kind = art::EaseKind::hold}});
    };
    for (const art::Span& span : shown) {
        add(span.from - 1);
        add(span.from);
        add(span.to);
    }
    return keys.empty() ? Channel{0} : Channel{std::move(keys)};
}

}

bool is_still(const art::Transform& transform)
{
    return !transform.path && std::ranges::all_of(flat_channels(transform), &Channel::is_still);
}

Moments moments_of(const art::Transform& transform)
{
    Moments moments;
    for (const Channel* channel : flat_channels(transform))
        moments.add(*channel);
    if (transform.path)
        moments.add(transform.path->share);
    return moments;
}

MovingDrawing carried(MovingDrawing drawing, const art::Transform& transform)
{
    // Finding the eases of its channels takes longer than moving a few points.
    constexpr double cost_of_transform = 100;
    if (is_still(transform))
        return mapped(std::move(drawing), [affine = matrix_at(transform, 0)](double) { return affine; });
    drawing.moments.add(moments_of(transform));
    drawing.cost += cost_of_transform;
    const auto shared = std::make_shared<const art::Transform>(transform);
    return mapped(std::move(drawing), [shared](double time) { return matrix_at(*shared, time); });
}

MovingDrawing while_shown(MovingDrawing drawing, const std::vector<art::Span>& shown)
{
    if (shown == std::vector<art::Span>{{}})
        return drawing;
    drawing.moments.add(jumps(shown));
    drawing.changes_form = true;
    drawing.at = [shown, at = std::move(drawing.at)](double time) {
        return is_shown(shown, time) ? at(time) : art::Drawing{};
    };
    return drawing;
}

}
