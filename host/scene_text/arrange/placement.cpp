#include "host/scene_text/arrange/placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace kfast::scene_text {

namespace {

using art::Affine;
using art::Channel;
using art::Transform;

constexpr double tiny = 1e-9;

bool is(const Channel& channel, double value)
{
    return std::ranges::all_of(channel.keys, [value](const auto& key) { return key.value == value; });
}

bool near(double one, double other) { return std::abs(one - other) <= tiny * std::max(1.0, std::abs(one)); }

std::array<const Channel*, 12> channels_of(const Transform& transform)
{
    return {&transform.anchor_x, &transform.anchor_y, &transform.x,       &transform.y,
            &transform.z,        &transform.scale_x,  &transform.scale_y, &transform.rotate,
            &transform.rotate_x, &transform.rotate_y, &transform.skew,    &transform.skew_axis};
}

}

bool is_identity(const Transform& transform)
{
    return !transform.path && is(transform.x, 0) && is(transform.y, 0) && is(transform.z, 0) &&
           is(transform.anchor_x, 0) && is(transform.anchor_y, 0) && is(transform.scale_x, 1) &&
           is(transform.scale_y, 1) && is(transform.rotate, 0) && lies_flat(transform) &&
           !is_skewed(transform);
}

bool is_still(const Transform& transform)
{
    const auto is_still = [](const Channel* channel) { return channel->is_still(); };
    return !transform.path && is(transform.z, 0) && lies_flat(transform) &&
           std::ranges::all_of(channels_of(transform), is_still);
}

bool lies_flat(const Transform& transform) { return is(transform.rotate_x, 0) && is(transform.rotate_y, 0); }

bool is_skewed(const Transform& transform) { return !is(transform.skew, 0); }

bool Placement::is_even() const { return near(std::abs(scale_x), std::abs(scale_y)); }

std::optional<Placement> placement_of(const Affine& affine)
{
    const double across = std::hypot(affine.a, affine.b);
    const double down = std::hypot(affine.c, affine.d);
    if (std::abs(affine.a * affine.c + affine.b * affine.d) > tiny * std::max(across * down, tiny))
        return std::nullopt;
    Placement placement{affine.e, affine.f, 0, across, std::copysign(down, affine.determinant())};
    // If there is no width, the rotation is that of the height.
    const double angle = across > 0 ? std::atan2(affine.b, affine.a) : std::atan2(-affine.c, affine.d);
    placement.rotate = near(angle, 0) ? 0 : angle * 180 / std::numbers::pi;
    if (near(std::abs(placement.rotate), 180)) { // mirrored rather than rotated
        placement.rotate = 0;
        placement.scale_x = -placement.scale_x;
        placement.scale_y = -placement.scale_y;
    }
    return placement;
}

Transform transform_of(const Placement& placement)
{
    Transform transform;
    transform.x = {placement.x};
    transform.y = {placement.y};
    transform.rotate = {placement.rotate};
    transform.scale_x = {placement.scale_x};
    transform.scale_y = {placement.scale_y};
    return transform;
}

double scale_factor_of(const Affine& affine) { return std::sqrt(std::abs(affine.determinant())); }

double distortion_of(const Affine& affine)
{
    // The sum and the difference of the singular values.
    const double sum = std::hypot(affine.a + affine.d, affine.b - affine.c);
    const double difference = std::hypot(affine.a - affine.d, affine.b + affine.c);
    const double shorter = std::abs(sum - difference) / 2;
    const double longer = (sum + difference) / 2;
    if (longer == 0)
        return 0;
    return shorter > 0 ? longer / shorter - 1 : std::numeric_limits<double>::infinity();
}

using art::Span;

std::vector<Span> common(const std::vector<Span>& one, const std::vector<Span>& other)
{
    std::vector<Span> both;
    for (const Span& left : one)
        for (const Span& right : other)
            if (const Span span{std::max(left.from, right.from), std::min(left.to, right.to)};
                span.from < span.to)
                both.push_back(span);
    std::ranges::sort(both, {}, &Span::from);
    return both;
}

}
