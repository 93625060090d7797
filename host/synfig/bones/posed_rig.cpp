#include "host/synfig/bones/posed_rig.hpp"

#include "host/art/geometry/affine.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace kfast::synfig {

namespace {

/// Degrees, counter-clockwise, without jumps: from all the angles that the bone has in the file.
double direction_of(const Bone& bone)
{
    const Vec2 along = bone.to() - bone.from();
    return bone.angle + std::remainder(std::atan2(along.y, along.x) / art::degree - bone.angle, 360);
}

class RigMaker {
public:
    RigMaker(const PosedBones& bones, const Reading& reading)
        : bones_{bones}, reading_{reading}, first_{bones.pairs_at(0)}
    {
        const auto& pairs = first_;
        for (const BonePair& pair : pairs) {
            const auto found = std::ranges::find_if(pairs, [&](const BonePair& other) {
                return !pair.pose.parent.empty() && other.pose.guid == pair.pose.parent;
            });
            parents_.push_back(found == pairs.end() ? std::optional<std::size_t>{}
                                                    : static_cast<std::size_t>(found - pairs.begin()));
            names_.push_back(pair.pose.name);
        }
    }

    PosedRig rig()
    {
        PosedRig result;
        result.rig.name = bones_.name;
        result.place.assign(first_.size(), none);
        for (std::size_t i = 0; i < first_.size(); ++i)
            add(i, result);
        return result;
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    static constexpr std::size_t max_kept_pairs = 100'000;

    /// Parents first.
    void add(std::size_t index, PosedRig& result)
    {
        std::vector<std::size_t> line{index};
        while (parents_[line.back()] && line.size() <= first_.size())
            line.push_back(*parents_[line.back()]);
        for (auto bone = line.rbegin(); bone != line.rend(); ++bone)
            if (result.place[*bone] == none) {
                result.place[*bone] = result.rig.bones.size();
                result.rig.bones.push_back(posed(*bone, result));
            }
    }

    art::Bone posed(std::size_t index, const PosedRig& result) const
    {
        const art::Affine& to_canvas = reading_.to_canvas;
        art::Bone bone;
        bone.name = names_[index];
        bone.from = to_canvas.of(first_[index].rest.from());
        bone.to = to_canvas.of(first_[index].rest.to());
        if (parents_[index])
            bone.parent = result.place[*parents_[index]];
        const Tracing turns = tracing(angle_tolerance);
        const Tracing places = tracing(place_tolerance);
        const std::function<double(double)> rotation = [&](double frame) {
            const auto& pairs = pairs_at(frame);
            return turned(pairs, index) - (parents_[index] ? turned(pairs, *parents_[index]) : 0);
        };
        const std::function<double(double)> x = [&](double frame) { return shift(index, frame).x; };
        const std::function<double(double)> y = [&](double frame) { return shift(index, frame).y; };
        bone.rotation = traced(rotation, turns);
        bone.x = traced(x, places);
        bone.y = traced(y, places);
        const std::function<double(double)> length = [&](double frame) {
            return reading_.pixels_per_unit * length_of(pairs_at(frame)[index].pose);
        };
        bone.length = traced(length, places);
        if (bone.length->is_still() &&
            std::abs(bone.length->value() - scene::distance(bone.from, bone.to)) < 0.01)
            bone.length.reset();
        return bone;
    }

    /// As many as at the beginning: lists of bones may change over time. Valid until the next call. They are
    /// kept, as all values of all bones are traced at much the same frames.
    const std::vector<BonePair>& pairs_at(double frame) const
    {
        if (const auto known = pairs_.find(frame); known != pairs_.end())
            return known->second;
        if (pairs_.size() * first_.size() > max_kept_pairs)
            pairs_.clear();
        auto pairs = bones_.pairs_at(frame);
        pairs.resize(first_.size());
        return pairs_.emplace(frame, std::move(pairs)).first->second;
    }

    static double length_of(const Bone& bone) { return scene::distance(bone.from(), bone.to()); }

    Tracing tracing(double tolerance) const
    {
        return {0, reading_.frames, bones_.bends, tolerance, &reading_.budget};
    }

    /// The rotation from rest, clockwise on the canvas.
    static double turned(const std::vector<BonePair>& pairs, std::size_t index)
    {
        return direction_of(pairs[index].rest) - direction_of(pairs[index].pose);
    }

    /// The shift of the beginning of a bone, as if its parent had not rotated.
    Vec2 shift(std::size_t index, double frame) const
    {
        const auto& pairs = pairs_at(frame);
        const art::Affine& to_canvas = reading_.to_canvas;
        const Vec2 now = to_canvas.of(pairs[index].pose.from());
        const Vec2 rest = to_canvas.of(pairs[index].rest.from());
        if (!parents_[index])
            return now - rest;
        const BonePair& parent = pairs[*parents_[index]];
        const art::Affine back = art::turned(-turned(pairs, *parents_[index]));
        return back.of(now - to_canvas.of(parent.pose.from())) - (rest - to_canvas.of(parent.rest.from()));
    }

    const PosedBones& bones_;
    const Reading& reading_;
    std::vector<BonePair> first_;
    std::vector<std::optional<std::size_t>> parents_;
    std::vector<std::string> names_;
    mutable std::map<double, std::vector<BonePair>> pairs_;
};

}

PosedRig posed_rig(const PosedBones& bones, const Reading& reading) { return RigMaker{bones, reading}.rig(); }

}
