#include "host/lottie/shapes/transform.hpp"

#include "host/art/geometry/affine.hpp"
#include "host/lottie/values/member.hpp"

#include <algorithm>

namespace kfast::lottie {
namespace {

using art::Channel;

constexpr double percent = 0.01;

Channel channel(const Json& owner, const char* name, std::size_t index, double default_value, double factor,
                const Reading& reading)
{
    return read_channel(owner, name, index, default_value, factor, reading.time, reading.budget);
}

bool is_zero(const Channel& number) { return steady_value(number) == 0.0; }

/// Of two, one of which is steady.
std::optional<Channel> sum(const Channel& one, const Channel& other)
{
    const auto constant = steady_value(other);
    if (!constant)
        return steady_value(one) ? sum(other, one) : std::nullopt;
    Channel result = one;
    for (auto& key : result.keys)
        key.value += *constant;
    return result;
}

/// Turns about the three axes: about z first, then about y, then about x.
struct Rotations {
    Channel x = {0};
    Channel y = {0};
    Channel z = {0};
};

/// After Effects has z lead away from the viewer, and turns about x and y the other way round.
Rotations read_rotation(const Json& ks, const Reading& reading)
{
    const char* const about_z = find_member(ks, "rz") ? "rz" : "r";
    return {channel(ks, "rx", 0, 0, -1, reading), channel(ks, "ry", 0, 0, -1, reading),
            channel(ks, about_z, 0, 0, 1, reading)};
}

Rotations read_orientation(const Json& ks, const Reading& reading)
{
    return {channel(ks, "or", 0, 0, -1, reading), channel(ks, "or", 1, 0, -1, reading),
            channel(ks, "or", 2, 0, 1, reading)};
}

/// First `inner`, then `outer`, as one; nothing if one cannot say it.
std::optional<Rotations> merged(const Rotations& outer, const Rotations& inner)
{
    const bool outer_begins_with_x = is_zero(outer.z) && is_zero(outer.y);
    const bool inner_ends_with_z = is_zero(inner.x) && is_zero(inner.y);
    const bool both_have_y = is_zero(inner.x) && is_zero(outer.z);
    if (!outer_begins_with_x && !inner_ends_with_z && !both_have_y)
        return std::nullopt;
    const auto x = sum(outer.x, inner.x);
    const auto y = sum(outer.y, inner.y);
    const auto z = sum(outer.z, inner.z);
    if (!x || !y || !z)
        return std::nullopt;
    return Rotations{*x, *y, *z};
}

Channel read_depth(const Json& ks, const Reading& reading)
{
    const Json* const position = find_member(ks, "p");
    if (position && position->is_object() && find_member(*position, "z"))
        return channel(*position, "z", 0, 0, -1, reading);
    return channel(ks, "p", 2, 0, -1, reading);
}

void report(const Reading& reading, const char* feature, const char* instead)
{
    reading.losses.add({feature, reading.layer, std::nullopt, instead});
}

void turn_in_space(art::Transform& transform, const Json& ks, const Reading& reading)
{
    transform.z = read_depth(ks, reading);
    if (!is_zero(channel(ks, "a", 2, 0, 1, reading)))
        report(reading, "depth of the anchor", "the layer turns about a point in its own plane");
    Rotations turns = read_rotation(ks, reading);
    const Rotations orientation = read_orientation(ks, reading);
    if (const auto both = merged(orientation, turns))
        turns = *both;
    else
        report(reading, "orientation and rotation about different axes", "the rotation alone");
    transform.rotate_x = turns.x;
    transform.rotate_y = turns.y;
    transform.rotate = turns.z;
}

art::Transform read_flat(const Json& ks, const Reading& reading, bool turns)
{
    art::Transform transform;
    read_position(transform, ks, reading, turns);
    transform.anchor_x = channel(ks, "a", 0, 0, 1, reading);
    transform.anchor_y = channel(ks, "a", 1, 0, 1, reading);
    transform.scale_x = channel(ks, "s", 0, 1, percent, reading);
    transform.scale_y = channel(ks, "s", 1, 1, percent, reading);
    transform.rotate = channel(ks, find_member(ks, "r") ? "r" : "rz", 0, 0, 1, reading);
    transform.skew = channel(ks, "sk", 0, 0, 1, reading);
    transform.skew_axis = channel(ks, "sa", 0, 0, 1, reading);
    skew_before_scaling(transform);
    return transform;
}

}

bool is_flat(const art::Transform& transform)
{
    return steady_value(transform.z) == 0.0 && steady_value(transform.rotate_x) == 0.0 &&
           steady_value(transform.rotate_y) == 0.0;
}

std::optional<double> steady_value(const Channel& channel)
{
    const double value = channel.keys.front().value;
    const bool steady =
        std::ranges::all_of(channel.keys, [&](const auto& key) { return key.value == value; });
    return steady ? std::optional{value} : std::nullopt;
}

art::Transform read_transform(const Json& transform, const Reading& reading)
{
    return read_flat(transform, reading, false);
}

art::Transform read_layer_transform(const Json& layer, const Reading& reading)
{
    const Json none = Json::object();
    const Json* const found = find_member(layer, "ks");
    const Json& ks = found ? *found : none;
    art::Transform transform = read_flat(ks, reading, truth_at(layer, "ao", false));
    if (truth_at(layer, "ddd", false))
        turn_in_space(transform, ks, reading);
    return transform;
}

}
