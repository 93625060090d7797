#pragma once

#include "core/pose/posed_bones.hpp"
#include "tests/core/moved_scene.hpp"
#include "tests/core/raw_bones.hpp"

#include <array>
#include <vector>

namespace kfast::test {

/// All bones of a scene, set up.
class Puppet {
public:
    /// Of all its keys, by their numbers.
    static constexpr std::array<LawPair, 5> laws{
        LawPair{}, LawPair{VelocityLaw::accelerate, VelocityLaw::decelerate},
        LawPair{VelocityLaw::accelerate_decelerate, VelocityLaw::constant},
        LawPair{VelocityLaw::hold, VelocityLaw::accelerate},
        LawPair{VelocityLaw::decelerate, VelocityLaw::hold}};
    /// The number of one more pair; both swing beyond their ends.
    static constexpr int wild = 5;

    explicit Puppet(const std::vector<RawSkeleton>& skeletons)
        : file_{scene_with(skeletons).file()}, scene_{*SceneView::parse(file_)}, moved_{scene_}
    {
    }
    Puppet(const Puppet&) = delete;

    const std::vector<PosedBone>& at(Time time) { return moved_.bones_at(time); }

private:
    static RawScene scene_with(const std::vector<RawSkeleton>& skeletons)
    {
        RawScene scene;
        scene.law_count = 5;
        scene.laws = bytes({0x21, 0x03, 0x14, 0x42,                               //
                            0x66, 0,    0,    0x00, 0xC0, 0,    0x20, 0x00, 0x60, // y from -2 to 3
                            0,    0,    0x00, 0xC0, 0,    0x20, 0x00, 0x60});
        for (const RawSkeleton& skeleton : skeletons)
            scene.bones = joined({scene.bones, skeleton_bytes(skeleton)});
        return scene;
    }

    Bytes file_;
    SceneView scene_;
    MovedScene moved_;
};

}
