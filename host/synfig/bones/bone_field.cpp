#include "host/synfig/bones/bone_field.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::synfig {
namespace {

// Shorter bones deform nothing.
constexpr double min_length = 1e-6;
constexpr double nearest_distance = 1e-10;
constexpr double same_length = 1e-3;
// Matrices are cached for that many times.
constexpr std::size_t max_moments = 4096;

double distance_to_bone(const Bone& bone, Vec2 place)
{
    const Vec2 along = bone.to() - bone.from();
    const double share =
        std::clamp(scene::dot(place - bone.from(), along) / scene::dot(along, along), 0.0, 1.0);
    return scene::distance(place, bone.from() + share * along);
}

/// How deep a point is in a circle: 1 in its middle, 0 on its edge and below that outside.
double depth_in_circle(Vec2 centre, double radius, Vec2 place)
{
    return radius > 0 ? 1 - scene::distance(centre, place) / radius : 0;
}

/// The same between the common tangents of both circles, from the middle of the bone outwards.
double depth_in_belt(const Bone& bone, double margin, Vec2 place)
{
    const double first = bone.width + margin;
    const double last = bone.tip_width + margin;
    const Vec2 along = bone.to() - bone.from();
    const double length = std::sqrt(scene::dot(along, along));
    if (length <= std::abs(last - first))
        return 0;
    const double lean = (first - last) / length;
    const double upright = std::sqrt(1 - lean * lean);
    const Vec2 direction = 1 / length * along;
    const Vec2 from = bone.from() + first * lean * direction;
    const double reach = length - first * lean + last * lean;
    const double share = scene::dot(place - from, direction) / reach;
    const double half_width = upright * (first + share * (last - first));
    if (share <= 0 || share >= 1 || half_width <= 0)
        return 0;
    return 1 - std::abs(scene::cross(direction, place - from)) / half_width;
}

double depth_in(const Bone& bone, double margin, Vec2 place)
{
    return std::max({0.0, depth_in_circle(bone.from(), bone.width + margin, place),
                     depth_in_circle(bone.to(), bone.tip_width + margin, place),
                     depth_in_belt(bone, margin, place)});
}

/// The matrix from the bone's own coordinates, in which it is from (0, 0) to (1, 0).
art::Affine frame_of(const Bone& bone)
{
    const Vec2 along = bone.to() - bone.from();
    return {along.x, along.y, -along.y, along.x, bone.from().x, bone.from().y};
}

art::Affine inverse(const art::Affine& matrix)
{
    const double determinant = matrix.determinant();
    const art::Affine linear{matrix.d / determinant,
                             -matrix.b / determinant,
                             -matrix.c / determinant,
                             matrix.a / determinant,
                             0,
                             0};
    const Vec2 offset = linear.of(Vec2{matrix.e, matrix.f});
    return {linear.a, linear.b, linear.c, linear.d, -offset.x, -offset.y};
}

double length_of(const Bone& bone) { return scene::distance(bone.from(), bone.to()); }

}

BoneField::BoneField(const Layer& layer) : layer_{layer}
{
    for (const BonePair& pair : pairs_at(0))
        rests_.push_back(pair.rest);
    const Vec2 one = layer.spot("point1", 0, {-4, 4});
    const Vec2 other = layer.spot("point2", 0, {4, -4});
    const double columns = std::max(1.0, layer.number("x_subdivisions", 0, 32));
    const double rows = std::max(1.0, layer.number("y_subdivisions", 0, 32));
    const Vec2 step{(other.x - one.x) / columns, (other.y - one.y) / rows};
    margin_ = 2 * std::sqrt(scene::dot(step, step));
}

std::vector<BonePair> BoneField::pairs_at(double frame) const
{
    std::vector<BonePair> pairs;
    for (const Value& entry : layer_.at("bones", frame).as<List>().entries) {
        const auto parts = entry.as<List>().entries;
        if (parts.size() == 2)
            pairs.push_back({parts[0].as<Bone>(), parts[1].as<Bone>()});
    }
    std::erase_if(pairs, [](const BonePair& pair) { return !(length_of(pair.rest) > min_length); });
    return pairs;
}

Vec2 BoneField::in_units(Vec2 place) const { return inverse(layer_.reading().to_canvas).of(place); }

std::vector<art::BoneInfluence> BoneField::shares(Vec2 place) const
{
    const Vec2 at = in_units(place);
    std::vector<art::BoneInfluence> shares;
    for (std::size_t i = 0; i < rests_.size(); ++i)
        if (const double depth = depth_in(rests_[i], margin_, at); depth > 1e-10) {
            const double distance = std::max(nearest_distance, distance_to_bone(rests_[i], at));
            shares.push_back({i, depth / (distance * distance)});
        }
    return shares;
}

bool BoneField::covers(Vec2 place) const
{
    return std::ranges::any_of(
        rests_, [&, at = in_units(place)](const Bone& rest) { return depth_in(rest, 0, at) > 0; });
}

std::size_t BoneField::nearest(Vec2 place) const
{
    const Vec2 at = in_units(place);
    const auto found =
        std::ranges::min_element(rests_, {}, [&](const Bone& rest) { return distance_to_bone(rest, at); });
    return static_cast<std::size_t>(found - rests_.begin());
}

art::Affine BoneField::carrying(std::size_t bone, double frame) const
{
    auto known = carryings_.find(frame);
    if (known == carryings_.end()) {
        if (carryings_.size() >= max_moments)
            carryings_.clear();
        const art::Affine& to_canvas = layer_.reading().to_canvas;
        std::vector<art::Affine> all;
        for (const BonePair& pair : pairs_at(frame))
            all.push_back(to_canvas * frame_of(pair.pose) * inverse(frame_of(pair.rest)) *
                          inverse(to_canvas));
        all.resize(rests_.size());
        known = carryings_.emplace(frame, std::move(all)).first;
    }
    return known->second[bone];
}

Vec2 BoneField::deformed(Vec2 place, double frame) const
{
    Vec2 total;
    double weights = 0;
    for (const art::BoneInfluence& share : shares(place)) {
        total = total + share.weight * carrying(share.bone, frame).of(place);
        weights += share.weight;
    }
    return weights > 0 ? 1 / weights * total : place;
}

std::vector<double> BoneField::samples() const
{
    constexpr int even = 24;
    std::vector<double> times = layer_.bends({"bones"});
    for (int i = 0; i <= even; ++i)
        times.push_back(layer_.reading().frames * i / even);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

bool BoneField::keeps_lengths() const
{
    for (const double time : samples()) {
        const auto pairs = pairs_at(time);
        if (pairs.size() != rests_.size())
            return false;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const double length = length_of(rests_[i]);
            const double moved = scene::distance(pairs[i].rest.from(), rests_[i].from()) +
                                 scene::distance(pairs[i].rest.to(), rests_[i].to());
            if (std::abs(length_of(pairs[i].pose) - length) + moved > same_length * length)
                return false;
        }
    }
    return true;
}

}
