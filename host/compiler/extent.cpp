#include "host/compiler/extent.hpp"

#include "host/compiler/track_peak.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kfast {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Extent nothing{infinity, -infinity};

void add(Extent& extent, double at)
{
    extent.least = std::min(extent.least, at);
    extent.most = std::max(extent.most, at);
}

void add(Extent& extent, const Extent& other)
{
    extent.least = std::min(extent.least, other.least);
    extent.most = std::max(extent.most, other.most);
}

void add(ExtentXY& extent, scene::Point point)
{
    add(extent.x, point.x / 16.0);
    add(extent.y, point.y / 16.0);
}

void add(ExtentXY& extent, const scene::Stroke& stroke)
{
    add(extent, stroke.from);
    for (const scene::Segment& segment : stroke.segments) {
        add(extent, segment.to);
        if (segment.cubic) {
            add(extent, segment.c1);
            add(extent, segment.c2);
        }
    }
}

/// By what share of a way a law leads beyond its keys at most.
double beyond(const VelocityLaw& law)
{
    const WayRange range = way_range(law);
    return std::max<double>(-1.0 * range.least.raw, 1.0 * range.most.raw - Way::one) / Way::one;
}

Extent widened(Extent extent, double share)
{
    const double more = share * (extent.most - extent.least);
    return {extent.least - more, extent.most + more};
}

/// No way is longer than the extent of all drawings.
ExtentXY drawn(const scene::Object& object)
{
    ExtentXY extent{nothing, nothing};
    double beyond_x = 0;
    double beyond_y = 0;
    for (const scene::Key& key : object.keys) {
        for (const scene::Stroke& stroke : key.drawing.strokes)
            add(extent, stroke);
        beyond_x = std::max(beyond_x, beyond(key.laws.x));
        beyond_y = std::max(beyond_y, beyond(key.laws.y));
    }
    if (extent.x.is_empty())
        return extent;
    return {widened(extent.x, beyond_x), widened(extent.y, beyond_y)};
}

Extent pixels(const scene::Item& item, Property property)
{
    const TrackRange range = track_range(item.tracks, property, 0);
    return {range.least / 16, range.most / 16};
}

double farthest(const Extent& extent, const Extent& pivot)
{
    return std::max({extent.most - pivot.least, pivot.most - extent.least, 0.0});
}

bool turns_about_z(const scene::Item& item)
{
    return track_peak(item.tracks, Property::rotation, 0) > 0 || (item.path && item.path->turns);
}

/// `reach` to either side of where the pivot gets to.
Extent moved(const scene::Item& item, Extent pivot, Extent path, Property position, double reach)
{
    const Extent& origin = item.path ? path : pivot;
    const Extent shift = pixels(item, position);
    return {origin.least + shift.least - reach, origin.most + shift.most + reach};
}

Extent shifted(Extent extent, Extent shift) { return {extent.least + shift.least, extent.most + shift.most}; }

bool stays_upright(const scene::Item& item)
{
    const auto is_still = [&item](Property property, double value) {
        const TrackRange range = track_range(item.tracks, property, value);
        return range.least == value && range.most == value;
    };
    return !item.path && !turns_about_z(item) && is_still(Property::scale_x, scale_one) &&
           is_still(Property::scale_y, scale_one);
}

}

Extents::Extents(const scene::Scene& scene) : scene_{&scene}
{
    for (const scene::Symbol& symbol : scene.symbols)
        symbols_.push_back(of_all(symbol.items));
}

ExtentXY Extents::inside(const scene::Item& item) const
{
    if (const auto* group = std::get_if<scene::Group>(&item.content))
        return of_all(group->items);
    if (const auto* use = std::get_if<scene::Use>(&item.content))
        return symbols_[use->symbol];
    const auto& object = std::get<scene::Object>(item.content);
    if (object.skin || !object.backbone_keys.empty())
        return {{0, 1.0 * scene_->canvas.width}, {0, 1.0 * scene_->canvas.height}};
    return drawn(object);
}

// Not std::hypot, which platforms round differently.
Reach Extents::from_pivot(const scene::Item& item, const ExtentXY& own)
{
    if (own.x.is_empty())
        return {};
    const double x = farthest(own.x, pixels(item, Property::pivot_x)) *
                     track_peak(item.tracks, Property::scale_x, scale_one) / scale_one;
    const double y = farthest(own.y, pixels(item, Property::pivot_y)) *
                     track_peak(item.tracks, Property::scale_y, scale_one) / scale_one;
    const double both = std::sqrt(x * x + y * y);
    return turns_about_z(item) ? Reach{both, both} : Reach{x, y};
}

/// Of `item` in the plane of what it lies in.
ExtentXY Extents::around(const scene::Item& item) const
{
    const ExtentXY own = inside(item);
    if (own.x.is_empty())
        return own;
    if (stays_upright(item))
        return {shifted(own.x, pixels(item, Property::x)), shifted(own.y, pixels(item, Property::y))};
    ExtentXY path{nothing, nothing};
    if (item.path)
        add(path, item.path->stroke);
    const Reach reach = from_pivot(item, own);
    return {moved(item, pixels(item, Property::pivot_x), path.x, Property::x, reach.x),
            moved(item, pixels(item, Property::pivot_y), path.y, Property::y, reach.y)};
}

ExtentXY Extents::of_all(const std::vector<scene::Item>& items) const
{
    ExtentXY extent{nothing, nothing};
    for (const scene::Item& item : items) {
        const ExtentXY one = around(item);
        add(extent.x, one.x);
        add(extent.y, one.y);
    }
    return extent;
}

}
