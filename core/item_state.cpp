#include "core/item_state.hpp"

#include "core/angle.hpp"
#include "core/key_interval.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr int fine_bits = 8; ///< ItemState keeps values in 1/256

/// Two values of a track, and how far the way from one to the other has come.
struct Passage {
    std::int32_t from;
    std::int32_t to;
    Way way;
};

bool tweens(Property property) { return property != Property::order && property != Property::visible; }

Passage passage_at(const SceneView& scene, const TrackView& track, Time time)
{
    if (track.is_fixed)
        return {track.value, track.value, {}};
    const auto [from, to] = interval_at(track.keys, time);
    if (from.value == to.value || !tweens(track.property))
        return {from.value, from.value, {}};
    const LawPair laws = scene.laws(from.laws);
    const Progress progress = progress_between(from.time, to.time, time, laws);
    return {from.value, to.value, goes_by_y(track.property) ? progress.y : progress.x};
}

/// Rounded to nearest, halves up.
std::int32_t fine_value(const Passage& passage)
{
    return (passage.from << fine_bits) + multiply(passage.to - passage.from, passage.way.raw, 16 - fine_bits);
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

std::int64_t within_shift(std::int64_t shift)
{
    constexpr std::int64_t furthest = std::int64_t{65536} * Fixed::one;
    return std::clamp(shift, -furthest, furthest);
}

}

ItemState::ItemState(const SceneView& scene, const ItemView& item, Time time) : fine_{}
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
        read(scene, tracks.next(), time);
}

void ItemState::read(const SceneView& scene, const TrackView& track, Time time)
{
    const Passage passage = passage_at(scene, track, time);
    if (track.property == Property::fill)
        fill_ = colour_of(scene, passage);
    else if (track.property == Property::stroke)
        stroke_ = colour_of(scene, passage);
    else
        fine_[static_cast<std::size_t>(track.property)] = fine_value(passage);
}

std::uint32_t ItemState::opacity() const
{
    if (fine(Property::visible) == 0)
        return 0;
    return static_cast<std::uint32_t>(std::clamp<std::int32_t>(whole(Property::opacity), 0, 255));
}

Affine ItemState::placement() const
{
    const std::int32_t scale_x = fine(Property::scale_x);
    const std::int32_t scale_y = fine(Property::scale_y);
    const BinaryAngle angle = BinaryAngle::from_raw(whole(Property::rotation));
    const std::int32_t along = cosine(angle);
    const std::int32_t across = sine(angle);
    const Fixed pivot_x = pixels(Property::pivot_x);
    const Fixed pivot_y = pixels(Property::pivot_y);
    const Affine turned{.xx = scaled_component(along, scale_x),
                        .xy = scaled_component(-across, scale_y),
                        .yx = scaled_component(across, scale_x),
                        .yy = scaled_component(along, scale_y),
                        .x0 = std::int64_t{pixels(Property::x).raw()} + pivot_x.raw(),
                        .y0 = std::int64_t{pixels(Property::y).raw()} + pivot_y.raw()};
    Affine placed = turned * Affine{.x0 = -pivot_x.raw(), .y0 = -pivot_y.raw()};
    placed.x0 = within_shift(placed.x0);
    placed.y0 = within_shift(placed.y0);
    return placed;
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

std::int32_t order_at(const ItemView& item, Time time)
{
    for (TrackCursor tracks = item.tracks; !tracks.at_end();) {
        const TrackView track = tracks.next();
        if (track.property == Property::order)
            return track.is_fixed ? track.value : interval_at(track.keys, time).from.value;
    }
    return 0;
}

}
