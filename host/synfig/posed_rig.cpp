#include "host/synfig/posed_rig.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace kfast::synfig {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Degrees, counter-clockwise, without jumps: as all the angles that the bone has in the file say.
double direction_of(const Bone& bone)
{
    const Spot along = bone.to() - bone.from();
    return bone.angle + std::remainder(std::atan2(along.y, along.x) / degree - bone.angle, 360);
}

class RigMaker {
public:
    RigMaker(const Layer& layer, const BoneField& field) : layer_{layer}, field_{field}
    {
        const auto pairs = field.pairs_at(0);
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
        result.rig.name = layer_.name();
        result.place.assign(field_.size(), none);
        for (std::size_t i = 0; i < field_.size(); ++i)
            add(i, result);
        return result;
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /// Parents first.
    void add(std::size_t index, PosedRig& result)
    {
        std::vector<std::size_t> line{index};
        while (parents_[line.back()] && line.size() <= field_.size())
            line.push_back(*parents_[line.back()]);
        for (auto bone = line.rbegin(); bone != line.rend(); ++bone)
            if (result.place[*bone] == none) {
                result.place[*bone] = result.rig.bones.size();
                result.rig.bones.push_back(posed(*bone, result));
            }
    }

    art::Bone posed(std::size_t index, const PosedRig& result) const
    {
        const art::Affine& to_canvas = layer_.reading().to_canvas;
        art::Bone bone;
        bone.name = names_[index];
        bone.from = to_canvas.of(field_.rests()[index].from());
        bone.to = to_canvas.of(field_.rests()[index].to());
        if (parents_[index])
            bone.parent = result.place[*parents_[index]];
        const Tracing turns = layer_.tracing({"bones"}, angle_tolerance);
        const Tracing places = layer_.tracing({"bones"}, place_tolerance);
        const std::function<double(double)> turn = [&](double frame) {
            const auto pairs = field_.pairs_at(frame);
            return turned(pairs, index) - (parents_[index] ? turned(pairs, *parents_[index]) : 0);
        };
        const std::function<double(double)> x = [&](double frame) { return shift(index, frame).x; };
        const std::function<double(double)> y = [&](double frame) { return shift(index, frame).y; };
        bone.turn = traced(turn, turns);
        bone.x = traced(x, places);
        bone.y = traced(y, places);
        return bone;
    }

    /// Clockwise on the canvas, from rest.
    static double turned(const std::vector<BonePair>& pairs, std::size_t index)
    {
        return direction_of(pairs[index].rest) - direction_of(pairs[index].pose);
    }

    /// Of the beginning of a bone, as if its parent had not turned.
    Spot shift(std::size_t index, double frame) const
    {
        const auto pairs = field_.pairs_at(frame);
        const art::Affine& to_canvas = layer_.reading().to_canvas;
        const Spot now = to_canvas.of(pairs[index].pose.from());
        const Spot rest = to_canvas.of(pairs[index].rest.from());
        if (!parents_[index])
            return now - rest;
        const BonePair& parent = pairs[*parents_[index]];
        const art::Affine back = art::turned(-turned(pairs, *parents_[index]));
        return back.of(now - to_canvas.of(parent.pose.from())) - (rest - to_canvas.of(parent.rest.from()));
    }

    const Layer& layer_;
    const BoneField& field_;
    std::vector<std::optional<std::size_t>> parents_;
    std::vector<std::string> names_;
};

}

PosedRig posed_rig(const Layer& layer, const BoneField& field) { return RigMaker{layer, field}.rig(); }

}
