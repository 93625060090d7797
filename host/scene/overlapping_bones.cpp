#include "host/scene/overlapping_bones.hpp"

#include "host/counted.hpp"
#include "host/scene/bone_frames.hpp"
#include "host/text/glyph.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

namespace kfast::scene {
namespace {

constexpr int alike = 16;         ///< by how many 1/256 the weights of both differ at most
constexpr double closeness = 1;   ///< px by which bones that lie on each other are apart at most
constexpr double slant = 1.0 / 8; ///< or this share of the shorter one

using BonePair = std::pair<std::size_t, std::size_t>;

bool lies_on(const BoneFrame& bone, const BoneFrame& longer)
{
    const double most = std::max(closeness, slant * bone.length);
    return std::max(distance_to_line(bone.origin, longer.origin, longer.tip()),
                    distance_to_line(bone.tip(), longer.origin, longer.tip())) <= most;
}

bool has_keys(const Bone& bone)
{
    return std::ranges::any_of(bone.keys, [](const auto& keys) { return !keys.empty(); });
}

/// Finds the points that follow two bones alike.
class OverlappingBones {
public:
    explicit OverlappingBones(const std::vector<Bone>& bones)
        : bones_{bones}, frames_{frames_as_set_up(bones)}
    {
    }

    void look_at(std::size_t point, const Binding& binding)
    {
        for (std::size_t i = 0; i < binding.size(); ++i)
            for (std::size_t j = i + 1; j < binding.size(); ++j)
                if (std::abs(binding[i].weight - binding[j].weight) <= alike)
                    look_at(point, std::minmax(binding[i].bone, binding[j].bone));
    }

    /// By the bones between which they cannot decide.
    const std::map<BonePair, std::vector<std::size_t>>& points() const { return points_; }

private:
    void look_at(std::size_t point, BonePair pair)
    {
        const auto [known, is_new] = overlaps_.try_emplace(pair, false);
        if (is_new)
            known->second = move_apart(pair) && overlap(pair);
        if (known->second)
            points_[pair].push_back(point);
    }

    bool move_apart(BonePair pair) const
    {
        const Bone& a = bones_[pair.first];
        const Bone& b = bones_[pair.second];
        return a.parent != b.parent || has_keys(a) || has_keys(b);
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
                               Place place, Reading& reading)
{
    OverlappingBones overlapping{bones};
    for (std::size_t i = 0; i < bindings.size(); ++i)
        overlapping.look_at(i, bindings[i]);
    const auto& points = overlapping.points();
    if (points.empty())
        return;
    const auto& [pair, of_pair] = *points.begin();
    std::string message = points_follow(of_pair) + visible(bones[pair.first].name) + " and " +
                          visible(bones[pair.second].name) + " alike, which lie on each other";
    if (points.size() > 1)
        message += ", and so do points of " + counted(points.size() - 1, "other pair") + " of bones";
    reading.report.warning(place, message,
                           "give them weights { points FIRST LAST { BONE WEIGHT } }, or let each limb be an "
                           "object with its own bone=NAME");
}

}
