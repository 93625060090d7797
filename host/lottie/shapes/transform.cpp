#include "host/lottie/shapes/transform.hpp"

#include "host/art/geometry/affine.hpp"
#include "host/art/geometry/curves.hpp"
#include "host/lottie/values/json.hpp"
#include "host/lottie/values/ways.hpp"

#include <algorithm>
#include <limits>

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

/// The sum of two, one of which is steady.
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

/// Rotations about the three axes: about z first, then about y, then about x.
struct Rotations {
    Channel x = {0};
    Channel y = {0};
    Channel z = {0};
};

/// In After Effects z points away from the viewer, and rotations about x and y have the opposite sense.
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

/// First `inner`, then `outer`, as one; nothing if one cannot represent it.
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

bool changes_while_skewed(const art::Transform& transform)
{
    const auto is_steady = [](const Channel* channel) { return steady_value(*channel).has_value(); };
    const auto form = {&transform.skew, &transform.skew_axis, &transform.scale_x, &transform.scale_y};
    return !is_zero(transform.skew) && !std::ranges::all_of(form, is_steady);
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

namespace {

using scene::Vec2;

bool equal(Vec2 left, Vec2 right) { return left.x == right.x && left.y == right.y; }

/// The point of a value or a tangent; what is missing is 0.
Vec2 spot_of(const Json* value)
{
    if (!value)
        return {};
    if (!value->is_array())
        return {number_of(*value), number_of(*value)};
    return {value->empty() ? 0 : number_of((*value)[0]), value->size() < 2 ? 0 : number_of((*value)[1])};
}

Vec2 tangent(const FileKey& key, const char* name) { return spot_of(find_member(*key.key, name)); }

Vec2 end_of(const FileKey& key, const FileKey& next) { return spot_of(key.end ? key.end : next.begin); }

/// Programs also write tangents to straight ways, rounded to 1/1000 px.
bool is_bent(const FileKey& key, Vec2 to)
{
    constexpr double tolerance = 1.0 / 128;
    const Vec2 from = spot_of(key.begin);
    const auto lies_between = [&](Vec2 control) {
        return scene::distance_to_line(control, from, to) <= tolerance;
    };
    return !lies_between(from + tangent(key, "to")) || !lies_between(to + tangent(key, "ti"));
}

bool is_bent(const std::vector<FileKey>& keys)
{
    for (std::size_t i = 0; i + 1 < keys.size(); ++i)
        if (!keys[i].hold && is_bent(keys[i], end_of(keys[i], keys[i + 1])))
            return true;
    return false;
}

/// A path that is extended by the curves between keys, and by a line wherever the position jumps.
class GrowingPath {
public:
    explicit GrowingPath(Vec2 from) : outline_{from, {}, false} {}

    double length() const { return length_; }
    const scene::Outline& outline() const { return outline_; }

    void add(const scene::Curve& curve)
    {
        const Vec2 end = outline_.curves.empty() ? outline_.from : outline_.curves.back().to;
        const double length = art::curve_length(end, curve);
        if (length == 0)
            return;
        length_ += length;
        outline_.curves.push_back(curve);
    }

private:
    scene::Outline outline_;
    double length_ = 0;
};

scene::Curve curve_from(const FileKey& key, Vec2 end)
{
    const Vec2 out = tangent(key, "to");
    const Vec2 in = tangent(key, "ti");
    if (equal(out, {}) && equal(in, {}))
        return scene::line_to(end);
    return scene::cubic_to(spot_of(key.begin) + out, end + in, end);
}

/// The transitions between keys with path lengths as values.
std::vector<Way<double>> grow_along(GrowingPath& path, const std::vector<FileKey>& keys)
{
    constexpr double endless = std::numeric_limits<double>::infinity();
    std::vector<Way<double>> ways{{-endless, keys.front().time, 0, 0, {}}};
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const FileKey& key = keys[i];
        path.add(scene::line_to(spot_of(key.begin)));
        if (keys[i + 1].time == key.time)
            continue;
        const double begin = path.length();
        if (!key.hold)
            path.add(curve_from(key, end_of(key, keys[i + 1])));
        const art::Ease ease = read_ease(key, 0, path.length() != begin);
        ways.push_back({key.time, keys[i + 1].time, begin, path.length(), ease});
    }
    path.add(scene::line_to(spot_of(keys.back().begin)));
    ways.push_back({keys.back().time, endless, path.length(), path.length(), {}});
    return ways;
}

/// Nothing if it has no extent.
std::optional<art::MotionPath> read_motion_path(const Property& position, const Reading& reading, bool turns)
{
    const std::vector<FileKey>& keys = position.keys;
    GrowingPath path{spot_of(keys.front().begin)};
    std::vector<Way<double>> ways = grow_along(path, keys);
    if (path.length() == 0)
        return std::nullopt;
    for (Way<double>& way : ways) {
        way.begin /= path.length();
        way.end /= path.length();
    }
    reading.budget.take_keys(keys.size());
    reading.budget.take_points(path.outline().curves.size() + 1);
    place_in_scene(ways, reading.time);
    if (position.loop)
        repeat_ways(ways, *position.loop, reading.time, reading.budget);
    return art::MotionPath{{{path.outline()}}, joined(ways), turns};
}

bool is_split(const Json* position)
{
    return position && position->is_object() && position->contains("x") && (*position)["x"].is_object();
}

}

void read_position(art::Transform& transform, const Json& owner, const Reading& reading, bool turns)
{
    const Json* const position = find_member(owner, "p");
    if (is_split(position)) {
        if (turns)
            reading.losses.add({"orientation along a split position", reading.layer, std::nullopt,
                                "the layer does not turn"});
        transform.x = read_channel(*position, "x", 0, 0, 1, reading.time, reading.budget);
        transform.y = read_channel(*position, "y", 0, 0, 1, reading.time, reading.budget);
        return;
    }
    const Property property = read_property(owner, "p");
    if (property.keys.size() > 1 && (turns || is_bent(property.keys)))
        transform.path = read_motion_path(property, reading, turns);
    if (transform.path)
        return;
    transform.x = read_channel(owner, "p", 0, 0, 1, reading.time, reading.budget);
    transform.y = read_channel(owner, "p", 1, 0, 1, reading.time, reading.budget);
}

}
