#include "host/art/geometry/curve_length.hpp"
#include "host/lottie/shapes/transform.hpp"
#include "host/lottie/values/member.hpp"
#include "host/lottie/values/ways.hpp"

#include <limits>

namespace kfast::lottie {
namespace {

using scene::Vec2;

bool equal(Vec2 left, Vec2 right) { return left.x == right.x && left.y == right.y; }

/// Of a value or a tangent; what is missing is 0.
Vec2 spot_of(const Json* value)
{
    if (!value)
        return {};
    if (!value->is_array())
        return {number_of(*value), number_of(*value)};
    return {value->empty() ? 0 : number_of((*value)[0]), value->size() < 2 ? 0 : number_of((*value)[1])};
}

Vec2 tangent(const FileKey& key, const char* name) { return spot_of(find_member(*key.key, name)); }

bool is_bent(const std::vector<FileKey>& keys)
{
    return std::any_of(keys.begin(), keys.end() - 1, [](const FileKey& key) {
        return !key.hold && !(equal(tangent(key, "to"), {}) && equal(tangent(key, "ti"), {}));
    });
}

/// Grows by the ways between keys, and by a line wherever the position jumps.
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

/// The lengths at which the ways begin and end, as values.
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
            path.add(curve_from(key, spot_of(key.end ? key.end : keys[i + 1].begin)));
        const art::Ease ease = key.hold ? art::Ease{.kind = art::EaseKind::hold} : read_ease(key, 0);
        ways.push_back({key.time, keys[i + 1].time, begin, path.length(), ease});
    }
    path.add(scene::line_to(spot_of(keys.back().begin)));
    ways.push_back({keys.back().time, endless, path.length(), path.length(), {}});
    return ways;
}

/// Nothing if it leads nowhere.
std::optional<art::MotionPath> read_motion_path(const std::vector<FileKey>& keys, const Reading& reading,
                                                bool turns)
{
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
        transform.path = read_motion_path(property.keys, reading, turns);
    if (transform.path)
        return;
    transform.x = read_channel(owner, "p", 0, 0, 1, reading.time, reading.budget);
    transform.y = read_channel(owner, "p", 1, 0, 1, reading.time, reading.budget);
}

}
