#include "host/scene/skeleton/bone_regions.hpp"

#include "host/scene/skeleton/bone_frames.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace kfast::scene {

BoneRegions::BoneRegions(const Skeleton& skeleton, const std::vector<std::size_t>& bones)
{
    const std::vector<BoneFrame> frames = frames_as_set_up(skeleton.bones.bones);
    for (const std::size_t bone : bones)
        regions_.push_back({bone, frames[bone].origin, frames[bone].tip(), skeleton.regions[bone]});
}

std::vector<WeightedBone> BoneRegions::around(Vec2 spot) const
{
    std::vector<WeightedBone> bones;
    for (const Region& region : regions_) {
        const double away = distance_to(region, spot);
        if (away >= region.radius)
            continue;
        const double share = away / region.radius;
        const double fall = 1 - share * share;
        bones.push_back({region.bone, fall * fall});
    }
    return bones;
}

std::size_t BoneRegions::nearest(Vec2 spot) const
{
    const auto nearest = std::ranges::min_element(
        regions_, {}, [&](const Region& region) { return distance_to(region, spot); });
    return nearest->bone;
}

double BoneRegions::distance_to(const Region& region, Vec2 spot)
{
    return distance_to_line(spot, region.from, region.to);
}

namespace {

constexpr int alike = kfb::skin::whole_weight / 16; ///< by how much the weights of both differ at most
constexpr double closeness = 1;                     ///< px: the largest distance between bones that overlap
constexpr double slant = 1.0 / 8;                   ///< or this fraction of the shorter one

using BonePair = std::pair<std::size_t, std::size_t>;

bool lies_on(const BoneFrame& bone, const BoneFrame& longer)
{
    const double max = std::max(closeness, slant * bone.length);
    return std::max(distance_to_line(bone.origin, longer.origin, longer.tip()),
                    distance_to_line(bone.tip(), longer.origin, longer.tip())) <= max;
}

bool has_keys(const Bone& bone)
{
    return std::ranges::any_of(bone.keys, [](const auto& keys) { return !keys.empty(); });
}

/// Finds the points whose heaviest bones have nearly equal weights.
class OverlappingBones {
public:
    explicit OverlappingBones(const std::vector<Bone>& bones)
        : bones_{bones}, frames_{frames_as_set_up(bones)}
    {
    }

    void look_at(std::size_t point, const Binding& binding)
    {
        const auto is_heavy = [&](const BoneWeight& bone) {
            return binding.front().weight - bone.weight <= alike;
        };
        const auto end = std::ranges::find_if_not(binding, is_heavy);
        for (auto one = binding.begin(); one != end; ++one)
            for (auto other = one + 1; other != end; ++other)
                look_at(point, std::minmax(one->bone, other->bone));
    }

    /// By the bones between which they cannot decide.
    const std::map<BonePair, std::vector<std::size_t>>& points() const { return points_; }

    /// The pair to report: limbs of one parent if there are any, and those of most points.
    const auto& worst() const
    {
        return *std::ranges::max_element(points_, {}, [this](const auto& entry) {
            const auto& [pair, of_pair] = entry;
            return std::pair{bones_[pair.first].parent == bones_[pair.second].parent, of_pair.size()};
        });
    }

private:
    void look_at(std::size_t point, BonePair pair)
    {
        const auto [known, is_new] = overlaps_.try_emplace(pair, false);
        if (is_new)
            known->second = move_apart(pair) && overlap(pair);
        if (known->second)
            points_[pair].push_back(point);
    }

    /// Whether one of them is posed, or a bone between it and their common ancestor.
    bool move_apart(BonePair pair) const
    {
        std::optional<std::size_t> one = pair.first;
        std::optional<std::size_t> other = pair.second;
        while (one != other) {
            auto& later = one > other ? one : other; // parents come before their children, and no bone first
            if (has_keys(bones_[*later]))
                return true;
            later = bones_[*later].parent;
        }
        return false;
    }

    bool overlap(BonePair pair) const
    {
        const BoneFrame& a = frames_[pair.first];
        const BoneFrame& b = frames_[pair.second];
        return a.length < b.length ? lies_on(a, b) : lies_on(b, a);
    }

    const std::vector<Bone>& bones_;
    std::vector<BoneFrame> frames_;
    std::map<BonePair, bool> overlaps_;
    std::map<BonePair, std::vector<std::size_t>> points_;
};

/// "point 3 follows", "points 7 to 12 follow", "points 4, 5 and 9 to 12 follow"; `points` are counted from 0
/// and rise.
std::string points_follow(const std::vector<std::size_t>& points)
{
    std::vector<std::string> runs;
    for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
        for (end = begin + 1; end < points.size() && points[end] == points[end - 1] + 1;)
            ++end;
        runs.push_back(std::to_string(points[begin] + 1) +
                       (end - begin > 1 ? " to " + std::to_string(points[end - 1] + 1) : std::string{}));
    }
    std::string text = points.size() == 1 ? "point " : "points ";
    for (std::size_t i = 0; i < runs.size(); ++i)
        text += (i == 0 ? "" : i + 1 == runs.size() ? " and " : ", ") + runs[i];
    return text + (points.size() == 1 ? " follows " : " follow ");
}

}

void warn_of_overlapping_bones(const std::vector<Bone>& bones, const std::vector<Binding>& bindings,
                               SourceSpan place, SceneContext& context)
{
    OverlappingBones overlapping{bones};
    for (std::size_t i = 0; i < bindings.size(); ++i)
        overlapping.look_at(i, bindings[i]);
    const auto& points = overlapping.points();
    if (points.empty())
        return;
    const auto& [pair, of_pair] = overlapping.worst();
    std::string message = points_follow(of_pair) + visible(bones[pair.first].name) + " and " +
                          visible(bones[pair.second].name) + " alike, which lie on each other";
    if (points.size() > 1)
        message += ", and so do points of " + counted(points.size() - 1, "other pair") + " of bones";
    context.report.warning(place, message,
                           "let each limb be an object with its own bones=\"NAME …\", or give them weights { "
                           "points FIRST LAST { BONE WEIGHT } }");
}

}
