#include "core/pose/item_state.hpp"

#include "core/bytes/op_counter.hpp"
#include "core/features.hpp"
#include "core/math/angle.hpp"
#include "core/math/fixed.hpp"
#include "core/math/projection.hpp"
#include "core/scene/track_view.hpp"
#include "core/time/track.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace kfast {

namespace {

constexpr int fraction_bits = raster::CornerMap::fraction_bits;
constexpr int inverse_bits = 36;
constexpr std::int32_t one = 1 << fraction_bits;

/// The maximum scale when corners are placed; above 1, so that what is only rotated keeps its scale although
/// its factors are rounded.
constexpr std::int32_t max_scale_factor = one * 17 / 16;
/// How far a map may be from a rotation with a scale, as a fraction of its scale: pens become that much
/// broader on a side.
constexpr std::int32_t tolerance = one / 128;

constexpr std::int32_t max_factor = 1 << 20; ///< far more than the largest scale

constexpr std::int64_t max_shift = std::int64_t{raster::CornerMap::max_shift} << (16 - raster::grid_bits);

std::int64_t sum_of_squares(std::int32_t a, std::int32_t b)
{
    constexpr std::int32_t max = 1 << 15;
    if (std::abs(a) <= max && std::abs(b) < max) // mostly, in 32 bits
        return a * a + b * b;
    return std::int64_t{a} * a + std::int64_t{b} * b;
}

bool is_within(std::int64_t value, std::int64_t limit) { return value >= -limit && value <= limit; }

}

RigidPlacements::RigidPlacements(std::int32_t canvas_scale)
    : base_{std::max<std::int32_t>(canvas_scale >> max_scale_bits, 1) << max_scale_bits},
      inverse_{quotient(std::int64_t{1} << inverse_bits, static_cast<std::uint32_t>(base_))}
{
}

std::int32_t RigidPlacements::factor(std::int32_t q16) const
{
    if (base_ == Fixed::one) // mostly; the result is the same
        return std::clamp(rounded_shift(q16, 2), -max_factor, max_factor);
    constexpr int shift = inverse_bits - fraction_bits;
    const std::int64_t wide = rounded_shift(q16 * inverse_, shift);
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(wide, -max_factor, max_factor));
}

std::optional<RigidPlacement> RigidPlacements::of(const Affine& map) const
{
    const std::int32_t xx = factor(map.xx);
    const std::int32_t xy = factor(map.xy);
    const std::int32_t yx = factor(map.yx);
    const std::int32_t yy = factor(map.yy);
    const std::int32_t shear =
        std::min(std::abs(xx - yy) + std::abs(xy + yx), std::abs(xx + yy) + std::abs(xy - yx));
    const std::int64_t square = sum_of_squares(xx, yx);
    int bits = -max_scale_bits;
    constexpr std::int64_t max = std::int64_t{max_scale_factor} * max_scale_factor;
    std::int64_t limit = max >> 2 * max_scale_bits;
    for (; bits <= max_scale_bits && square > limit; limit <<= 2)
        ++bits;
    const int up = bits + max_scale_bits; // from the smallest scale
    const std::int64_t scale = std::int64_t{base_ >> max_scale_bits} << up;
    if (bits > max_scale_bits || scale > Affine::max_factor || shear > (tolerance << up) >> max_scale_bits ||
        !is_within(map.x0, max_shift) || !is_within(map.y0, max_shift))
        return std::nullopt;
    const auto scaled = [up](std::int32_t value) {
        return ((value << max_scale_bits) + ((1 << up) >> 1)) >> up;
    };
    return RigidPlacement{.scale_bits = static_cast<std::int8_t>(bits),
                          .scale = static_cast<std::int32_t>(scale),
                          .map = {scaled(xx), scaled(xy), scaled(yx), scaled(yy),
                                  static_cast<std::int32_t>(map.x0), static_cast<std::int32_t>(map.y0)}};
}

namespace {

std::uint8_t channel_between(std::uint8_t from, std::uint8_t to, Progress progress)
{
    const std::int32_t value = from + multiply(to - from, progress.raw, 16);
    return static_cast<std::uint8_t>(std::clamp<std::int32_t>(value, 0, 255));
}

Colour colour_between(Colour from, Colour to, Progress progress)
{
    return {channel_between(from.red, to.red, progress), channel_between(from.green, to.green, progress),
            channel_between(from.blue, to.blue, progress),
            channel_between(from.opacity, to.opacity, progress)};
}

std::int64_t within_shift(std::int64_t shift)
{
    constexpr std::int64_t furthest = std::int64_t{65536} * Fixed::one;
    return std::clamp(shift, -furthest, furthest);
}

/// The placement of an item, from the values of its tracks.
class Placement {
public:
    explicit Placement(const Features& features) : features_{features}
    {
        fine(Property::scale_x) = fine(Property::scale_y) = to_fine(scale_one);
    }

    /// A value in 1/256 of the unit of the property, which is one of those that place an item.
    std::int32_t& fine(Property property) { return fine_[static_cast<std::size_t>(property)]; }
    /// Moves the pivot to the path.
    void follow(const PathView& path, const PackedDrawing& stroke)
    {
        const PathPlace place = features_.paths->place_on(path, stroke, value(Property::along));
        position_ = place.at - Point{in_pixels(Property::pivot_x), in_pixels(Property::pivot_y)};
        if (path.turns)
            turned_ = FineAngle::of(place.direction);
    }
    Space space() const;

private:
    std::int32_t value(Property property) const { return fine_[static_cast<std::size_t>(property)]; }
    Fixed in_pixels(Property property) const { return fine_pixels(value(property)); }
    FineAngle angle(Property property) const { return FineAngle::of_fine(value(property)); }
    Space rotation() const;

    const Features& features_;
    std::array<std::int32_t, static_cast<std::size_t>(Property::along) + 1> fine_{};
    Point position_;   ///< from a path
    FineAngle turned_; ///< rotation by a path
};

Space Placement::space() const
{
    const Space turned = rotation();
    const Fixed pivot_x = in_pixels(Property::pivot_x);
    const Fixed pivot_y = in_pixels(Property::pivot_y);
    const Space to_pivot{.plane = {.x0 = -pivot_x.raw(), .y0 = -pivot_y.raw()}};
    Space placed = to_pivot.plane == Affine{} ? turned : product(turned, to_pivot, features_);
    const auto shift = [](std::int64_t from_pivot, Fixed position, Fixed along_path, Fixed pivot) {
        return within_shift(from_pivot + position.raw() + along_path.raw() + pivot.raw());
    };
    placed.plane.x0 = shift(placed.plane.x0, in_pixels(Property::x), position_.x, pivot_x);
    placed.plane.y0 = shift(placed.plane.y0, in_pixels(Property::y), position_.y, pivot_y);
    placed.z0 = shift(placed.z0, in_pixels(Property::z), {}, {});
    return placed;
}

Space Placement::rotation() const
{
    const Turning turning{.x = angle(Property::rotation_x),
                          .y = angle(Property::rotation_y),
                          .z = angle(Property::rotation) + turned_,
                          .scale_x = value(Property::scale_x),
                          .scale_y = value(Property::scale_y)};
    const bool is_upright = turning.x == FineAngle{} && turning.y == FineAngle{};
    return is_upright ? upright(turning) : features_.depth->tilted(turning);
}

/// A function of its own, so that the view of the item is on the stack only where it is needed.
[[gnu::noinline]] void follow_path(Placement& placement, const SceneView& scene, const Node& item)
{
    const PathView path = item_view(scene, item).path;
    placement.follow(path, scene.drawing(path.drawing));
}

}

const TrackState* ItemState::track(Property property) const
{
    for (const TrackState& track : prepared_.tracks(item_))
        if (track.property == static_cast<std::uint8_t>(property))
            return &track;
    return nullptr;
}

/// The value in 1/256 of the unit of the property.
std::int32_t ItemState::fine(Property property) const
{
    const TrackState* const found = track(property);
    return found != nullptr ? prepared_.fine_value(scene_, *found) : to_fine(value_without_track(property));
}

std::uint32_t ItemState::opacity() const
{
    if (item_.track_count == 0)
        return 255;
    if (fine(Property::visible) == 0)
        return 0;
    return static_cast<std::uint32_t>(std::clamp<std::int32_t>(from_fine(fine(Property::opacity)), 0, 255));
}

Space ItemState::placement() const
{
    count_op(Op::placement);
    Placement placement{scene_.features()};
    for (const TrackState& track : prepared_.tracks(item_)) {
        if (!places_item(static_cast<Property>(track.property)))
            break;
        count_op(Op::track);
        placement.fine(static_cast<Property>(track.property)) = prepared_.fine_value(scene_, track);
    }
    if (item_.has_path)
        follow_path(placement, scene_, item_);
    return placement.space();
}

Point ItemState::pivot() const
{
    return {fine_pixels(fine(Property::pivot_x)), fine_pixels(fine(Property::pivot_y))};
}

Colour ItemState::colour(Property property, std::uint8_t without_track) const
{
    const TrackState* const found = track(property);
    if (found == nullptr)
        return scene_.colour(without_track);
    const auto [from, to, progress] = prepared_.key_span(*found, LawAxis::x);
    const Colour first = scene_.colour(static_cast<std::size_t>(from));
    return from == to ? first : colour_between(first, scene_.colour(static_cast<std::size_t>(to)), progress);
}

Fixed ItemState::width() const
{
    const TrackState* const found = track(Property::width);
    if (found == nullptr)
        return Fixed::sixteenths(item_.style.width);
    return std::max(fine_pixels(prepared_.fine_value(scene_, *found)), Fixed{});
}

Trim ItemState::trim() const
{
    Trim trim = Trim::between(fine(Property::trim_from), fine(Property::trim_to), fine(Property::trim_offset),
                              static_cast<TrimMode>(from_fine(fine(Property::trim_mode))));
    trim.dashes = dashes();
    if (trim.dashes.count != 0 && trim.mode == TrimMode::sector)
        trim.mode = TrimMode::each;
    return trim;
}

/// None if no length has a track.
Dashes ItemState::dashes() const
{
    std::array<std::int32_t, Dashes::max_lengths> lengths{};
    std::size_t count = 0;
    for (const TrackState& track : prepared_.tracks(item_)) {
        const auto property = static_cast<Property>(track.property);
        if (!is_dash_length(property))
            continue;
        const auto index =
            static_cast<std::size_t>(track.property) - static_cast<std::size_t>(Property::dash_1);
        lengths[index] = prepared_.fine_value(scene_, track);
        count = index + 1;
    }
    Dashes dashes = Dashes::of(std::span{lengths}.first(count), fine(Property::dash_offset),
                               item_.style.cap != Cap::butt);
    dashes.max = static_cast<std::uint32_t>(from_fine(fine(Property::max_dashes)));
    return dashes;
}

}
