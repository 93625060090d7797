#include "host/art/document/extent.hpp"

#include "host/art/animation/ease.hpp"
#include "host/art/document/document.hpp"
#include "host/art/geometry/affine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kfast::art {

namespace {

using scene::Vec2;

double greatest(Range range)
{
    return range.empty() ? 0 : std::max(std::abs(range.low), std::abs(range.high));
}

Range sum(Range left, Range right) { return {left.low + right.low, left.high + right.high}; }
Range difference(Range left, Range right) { return {left.low - right.high, left.high - right.low}; }
Range widened(Range range, double by) { return {range.low - by, range.high + by}; }

Range product(double factor, Range range)
{
    const double one = factor * range.low;
    const double other = factor * range.high;
    return {std::min(one, other), std::max(one, other)};
}

/// How far transitions overshoot their keys, as a fraction of the difference.
template <typename Value>
double overshoot_of(const Animated<Value>& animated)
{
    double max = 0;
    for (const auto& key : animated.keys) {
        const ProgressRange range = progress_range(key.ease);
        max = std::max({max, -range.low, range.high - 1});
    }
    return max;
}

Extent extent_of(const Drawing& drawing)
{
    Extent extent;
    const auto take = [&](Vec2 spot) {
        extent.x.take(spot.x);
        extent.y.take(spot.y);
    };
    for (const scene::Outline& outline : drawing.outlines) {
        take(outline.from);
        for (const scene::Curve& curve : outline.curves) {
            take(curve.to);
            if (curve.cubic) {
                take(curve.c1);
                take(curve.c2);
            }
        }
    }
    return extent;
}

/// How far a shape's line reaches beyond its drawing.
double stroke_reach(const StrokeStyle& stroke)
{
    const double widths = stroke.join == Join::miter ? std::max(stroke.miter_limit, std::numbers::sqrt2)
                                                     : std::numbers::sqrt2; // corners of square caps
    return 0.5 * greatest(stroke.width) * widths;
}

/// Bones keep what they deform within the sum of all their lengths and motions.
double rig_reach(const Rig& rig, const Extent& extent)
{
    const Vec2 root = rig.bones.front().from;
    double reach = std::max(greatest(difference(extent.x, {root.x, root.x})),
                            greatest(difference(extent.y, {root.y, root.y})));
    reach *= std::numbers::sqrt2 * scale_factor_of(rig);
    for (const Bone& bone : rig.bones)
        reach += distance(bone.from, root) * scale_factor_of(rig) + distance(bone.from, bone.to) +
                 greatest(bone.x) + greatest(bone.y) + (bone.length ? greatest(*bone.length) : 0);
    return reach;
}

bool is_zero(const Channel& channel) { return greatest(channel) == 0; }

bool turns_in_space(const Transform& transform)
{
    return !is_zero(transform.rotate_x) || !is_zero(transform.rotate_y);
}

/// Whether it is one affine map at all times, apart from its position.
bool keeps_form(const Transform& transform)
{
    return !turns_in_space(transform) && transform.rotate.is_still() && transform.scale_x.is_still() &&
           transform.scale_y.is_still() && transform.skew.is_still() && transform.skew_axis.is_still();
}

Range x_of(const Transform& transform)
{
    return transform.path ? extent_of(transform.path->path).x : range_of(transform.x);
}

Range y_of(const Transform& transform)
{
    return transform.path ? extent_of(transform.path->path).y : range_of(transform.y);
}

}

void Range::take(double value)
{
    low = std::min(low, value);
    high = std::max(high, value);
}

void Range::take(Range other)
{
    low = std::min(low, other.low);
    high = std::max(high, other.high);
}

void Extent::take(const Extent& other)
{
    x.take(other.x);
    y.take(other.y);
    z.take(other.z);
}

Range range_of(const Channel& channel)
{
    Range range;
    for (std::size_t i = 0; i < channel.keys.size(); ++i) {
        range.take(channel.keys[i].value);
        if (i + 1 == channel.keys.size())
            break;
        const ProgressRange way = progress_range(channel.keys[i].ease);
        range.take(mixed(channel.keys[i].value, channel.keys[i + 1].value, way.low));
        range.take(mixed(channel.keys[i].value, channel.keys[i + 1].value, way.high));
    }
    return range;
}

double greatest(const Channel& channel) { return greatest(range_of(channel)); }

Extent extent_of(const Shape& shape, std::span<const Rig> rigs)
{
    Extent extent;
    for (const auto& key : shape.drawing.keys)
        extent.take(extent_of(key.value));
    if (extent.empty())
        return extent;
    const double overshoot = overshoot_of(shape.drawing);
    double beyond = overshoot * std::max(extent.x.high - extent.x.low, extent.y.high - extent.y.low);
    if (shape.stroke)
        beyond += stroke_reach(*shape.stroke);
    if (shape.skin && shape.skin->rig < rigs.size()) {
        const Rig& rig = rigs[shape.skin->rig];
        const double reach = rig_reach(rig, {widened(extent.x, beyond), widened(extent.y, beyond), {}});
        const Vec2 root = rig.bones.front().from;
        return {{root.x - reach, root.x + reach}, {root.y - reach, root.y + reach}, {0, 0}};
    }
    return {widened(extent.x, beyond), widened(extent.y, beyond), {0, 0}};
}

double reach_of(const Extent& content, const Transform& transform)
{
    if (content.empty())
        return 0;
    const double x = greatest(difference(content.x, range_of(transform.anchor_x)));
    const double y = greatest(difference(content.y, range_of(transform.anchor_y)));
    const double z = greatest(content.z);
    return std::sqrt(x * x + y * y + z * z);
}

double skew_scale_factor(const Transform& transform)
{
    const double degrees = std::min(greatest(transform.skew), steepest_skew);
    return 1 + std::tan(degrees * std::numbers::pi / 180);
}

double scale_factor_of(const Transform& transform)
{
    constexpr double min = 1e-6;
    return std::max({min, greatest(transform.scale_x), greatest(transform.scale_y)}) *
           skew_scale_factor(transform);
}

double scale_factor_of(const Rig& rig)
{
    double max = 1;
    for (const Bone& bone : rig.bones)
        if (bone.length)
            max = std::max(max, greatest(*bone.length) / std::max(distance(bone.from, bone.to), 1e-6));
    return max;
}

Extent placed(const Extent& content, const Transform& transform)
{
    if (content.empty())
        return content;
    const Range x = x_of(transform);
    const Range y = y_of(transform);
    const Range z = range_of(transform.z);
    if (keeps_form(transform) && transform.skew.value() == 0) {
        const Range across =
            product(transform.scale_x.value(), difference(content.x, range_of(transform.anchor_x)));
        const Range along =
            product(transform.scale_y.value(), difference(content.y, range_of(transform.anchor_y)));
        const Affine rotation = turned(transform.rotate.value());
        return {sum(x, sum(product(rotation.a, across), product(rotation.c, along))),
                sum(y, sum(product(rotation.b, across), product(rotation.d, along))), sum(z, content.z)};
    }
    const double reach = reach_of(content, transform) * std::max(1.0, scale_factor_of(transform));
    const double depth = turns_in_space(transform) ? reach : 0;
    return {widened(x, reach), widened(y, reach), widened(sum(z, content.z), depth)};
}

namespace {

bool has_depth(const std::vector<Node>& nodes)
{
    return std::ranges::any_of(nodes, [](const Node& node) {
        const Transform& transform = node.transform;
        for (const Channel* channel : {&transform.z, &transform.rotate_x, &transform.rotate_y})
            if (greatest(*channel) > 0)
                return true;
        const auto* group = std::get_if<Group>(&node.content);
        return group && has_depth(group->nodes);
    });
}

double farthest(Range range, double from)
{
    return std::max(std::abs(range.low - from), std::abs(range.high - from));
}

}

bool has_depth(const Document& document)
{
    return has_depth(document.nodes) || std::ranges::any_of(document.symbols, [](const Symbol& symbol) {
               return has_depth(symbol.nodes);
           });
}

Extent copied(const Extent& content, const Copies& copies)
{
    Extent all;
    for (int number = 0; number < copies.count; ++number) {
        Transform transform;
        transform.x = {number * copies.x};
        transform.y = {number * copies.y};
        transform.rotate = {number * copies.rotation};
        transform.scale_x = transform.scale_y = {std::pow(copies.scale, number)};
        all.take(placed(content, transform));
    }
    return all;
}

double scale_factor_of(const Copies& copies)
{
    return std::max(1.0, std::pow(copies.scale, copies.count - 1));
}

double perspective_scale_factor(const Document& document, const Extent& all)
{
    if (all.empty() || !has_depth(document))
        return 1;
    // As docs/scene-language.md has it: seen camera / (camera - z) times as large, and no nearer than that.
    constexpr double nearest = 15.0 / 16;
    const double camera = document.camera.value_or(2 * std::max(document.width, document.height));
    const double scale_factor = camera / (camera - std::clamp(all.z.high, 0.0, nearest * camera));
    const double away = std::hypot(farthest(all.x, document.width / 2), farthest(all.y, document.height / 2));
    // A motion across the canvas is scaled by that; one towards the viewer moves what is far from the middle.
    return scale_factor * (1 + away * scale_factor / camera);
}

}
