#include "core/item_state.hpp"

#include "core/hermite.hpp"
#include "core/passage.hpp"
#include "core/work.hpp"

#include <algorithm>

namespace kfast {
namespace {

bool tweens(Property property) { return property != Property::order && property != Property::visible; }

/// Between its two keys around `time`, which the track has.
Passage passage_between(const SceneView& scene, Property property, const KeyInterval<TrackKey>& keys,
                        Time time)
{
    if (!tweens(property))
        return {keys.from.value, keys.from.value, {}};
    return passage_between(scene, keys, goes_by_y(property) ? LawAxis::y : LawAxis::x, time);
}

/// Likewise: how long it stays as it is on the way between them.
Still still_between(const SceneView& scene, Property property, const KeyInterval<TrackKey>& keys, Time time)
{
    if (keys.from.value == keys.to.value || !tweens(property))
        return {.begin = keys.from.time, .end = keys.to.time};
    const LawPair laws = scene.laws(keys.from.laws);
    const VelocityLaw& law = goes_by_y(property) ? laws.y : laws.x;
    return still_between(keys.from.time, keys.to.time, time, {law, law});
}

std::uint8_t channel_between(std::uint8_t from, std::uint8_t to, Way way)
{
    const std::int32_t value = from + multiply(to - from, way.raw, 16);
    return static_cast<std::uint8_t>(std::clamp<std::int32_t>(value, 0, 255));
}

Colour colour_between(Colour from, Colour to, Way way)
{
    return {channel_between(from.red, to.red, way), channel_between(from.green, to.green, way),
            channel_between(from.blue, to.blue, way), channel_between(from.opacity, to.opacity, way)};
}

Colour colour_of(const SceneView& scene, const Passage& passage)
{
    return colour_between(scene.colour(static_cast<std::size_t>(passage.from)),
                          scene.colour(static_cast<std::size_t>(passage.to)), passage.way);
}

/// A unit vector's component in Q30 times a scale in 1/2^20, as a Q16 factor.
std::int32_t scaled_component(std::int32_t component, std::int32_t scale)
{
    return multiply(component, scale, 34);
}

/// A unit vector's component in Q30, in Q16.
std::int32_t component(std::int32_t q30) { return (q30 + (1 << 13)) >> 14; }

/// Of two components of unit vectors.
std::int32_t product(std::int32_t a, std::int32_t b) { return multiply(a, b, 30); }

struct Direction {
    explicit Direction(FineAngle angle) : cosine{kfast::cosine(angle)}, sine{kfast::sine(angle)} {}

    std::int32_t cosine; ///< Q30
    std::int32_t sine;
};

std::int64_t within_shift(std::int64_t shift)
{
    constexpr std::int64_t furthest = std::int64_t{65536} * Fixed::one;
    return std::clamp(shift, -furthest, furthest);
}

}

ItemState::ItemState(const SceneView& scene, const ItemView& item, const Moment& moment) : fine_{}
{
    const ObjectStyle& style = item.object.style;
    for (std::size_t i = 0; i < property_count; ++i)
        fine_[i] = value_without_track(static_cast<Property>(i)) << fine_bits;
    fine_[static_cast<std::size_t>(Property::width)] = style.width << fine_bits;
    if (style.is_filled)
        fill_ = scene.colour(style.fill);
    if (style.is_stroked)
        stroke_ = scene.colour(style.stroke);
    for (TrackCursor tracks = item.tracks; !tracks.at_end();)
        read(scene, tracks.next(), moment);
    if (item.path.is_known)
        follow(item.path, scene.drawing(item.path.drawing));
}

void ItemState::read(const SceneView& scene, const TrackView& track, const Moment& moment)
{
    did(Work::track);
    if (track.is_fixed)
        return take(scene, track.property, {track.value, track.value, {}});
    const Clock clock = track.keys.beats().clock();
    const Time time = moment.at(clock);
    if (track.is_smooth) {
        const HermiteSpan span = hermite_span_at(track.keys, time);
        const Still still = still_around<KeyTime>({span.from, span.to}, time, moving_at(time));
        still_ = still_ & still_by_clock(clock, still);
        fine_[static_cast<std::size_t>(track.property)] = hermite(span, time);
        return;
    }
    const KeyInterval<TrackKey> keys = interval_at(track.keys, time);
    const Still still = still_around(keys, time, still_between(scene, track.property, keys, time));
    still_ = still_ & still_by_clock(clock, still);
    take(scene, track.property, passage_between(scene, track.property, keys, time));
}

void ItemState::take(const SceneView& scene, Property property, const Passage& passage)
{
    if (property == Property::fill)
        fill_ = colour_of(scene, passage);
    else if (property == Property::stroke)
        stroke_ = colour_of(scene, passage);
    else
        fine_[static_cast<std::size_t>(property)] = fine_value(passage);
}

std::uint32_t ItemState::opacity() const
{
    if (fine(Property::visible) == 0)
        return 0;
    return static_cast<std::uint32_t>(std::clamp<std::int32_t>(whole(Property::opacity), 0, 255));
}

/// Puts the pivot onto the path.
void ItemState::follow(const PathView& path, const PackedDrawing& stroke)
{
    const PathPlace place = place_on(path, stroke, fine(Property::along));
    position_ = place.at - pivot();
    if (path.turns)
        turned_ = FineAngle::of(place.direction);
}

Space ItemState::placement() const
{
    did(Work::placement);
    const Space turned = turning();
    const Fixed pivot_x = pixels(Property::pivot_x);
    const Fixed pivot_y = pixels(Property::pivot_y);
    Space placed = turned * Space{.plane = {.x0 = -pivot_x.raw(), .y0 = -pivot_y.raw()}};
    const auto shift = [](std::int64_t from_pivot, Fixed position, Fixed along_path, Fixed pivot) {
        return within_shift(from_pivot + position.raw() + along_path.raw() + pivot.raw());
    };
    placed.plane.x0 = shift(placed.plane.x0, pixels(Property::x), position_.x, pivot_x);
    placed.plane.y0 = shift(placed.plane.y0, pixels(Property::y), position_.y, pivot_y);
    placed.z0 = shift(placed.z0, pixels(Property::z), {}, {});
    return placed;
}

/// Scale, then turn about z, y and x; every factor is rounded to Q16 once.
Space ItemState::turning() const
{
    const Direction z{angle(Property::rotation) + turned_};
    const std::int32_t scale_x = fine(Property::scale_x);
    const std::int32_t scale_y = fine(Property::scale_y);
    if (angle(Property::rotation_x) == FineAngle{} && angle(Property::rotation_y) == FineAngle{})
        return {.plane = {.xx = scaled_component(z.cosine, scale_x),
                          .xy = scaled_component(-z.sine, scale_y),
                          .yx = scaled_component(z.sine, scale_x),
                          .yy = scaled_component(z.cosine, scale_y)}};
    const Direction x{angle(Property::rotation_x)};
    const Direction y{angle(Property::rotation_y)};
    const std::int32_t deep_x = -product(y.sine, z.cosine); // where turns about z and y take x and y in z
    const std::int32_t deep_y = product(y.sine, z.sine);
    return {.plane = {.xx = scaled_component(product(y.cosine, z.cosine), scale_x),
                      .xy = scaled_component(-product(y.cosine, z.sine), scale_y),
                      .yx = scaled_component(product(x.cosine, z.sine) - product(x.sine, deep_x), scale_x),
                      .yy = scaled_component(product(x.cosine, z.cosine) - product(x.sine, deep_y), scale_y)},
            .xz = component(y.sine),
            .yz = component(-product(x.sine, y.cosine)),
            .zx = scaled_component(product(x.sine, z.sine) + product(x.cosine, deep_x), scale_x),
            .zy = scaled_component(product(x.sine, z.cosine) + product(x.cosine, deep_y), scale_y),
            .zz = component(product(x.cosine, y.cosine))};
}

Fixed ItemState::width() const { return std::max(pixels(Property::width), Fixed{}); }

/// Rounded to nearest, halves up.
std::int32_t ItemState::whole(Property property) const
{
    return (fine(property) + (1 << (fine_bits - 1))) >> fine_bits;
}

/// Of a property in 1/16 px.
Fixed ItemState::pixels(Property property) const
{
    return Fixed::from_raw(fine(property) * (Fixed::one >> (4 + fine_bits)));
}

std::int32_t order_at(const ItemView& item, const Moment& moment)
{
    for (TrackCursor tracks = item.tracks; !tracks.at_end();) {
        const TrackView track = tracks.next();
        if (track.property == Property::order)
            return track.is_fixed ? track.value
                                  : interval_at(track.keys, moment.at(track.keys.beats().clock())).from.value;
    }
    return 0;
}

}
