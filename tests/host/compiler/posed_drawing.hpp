#pragma once

#include "core/math/flatten.hpp"
#include "host/compiler/carry/skinned_drawing.hpp"
#include "host/scene/skeleton/bone_frames.hpp"

#include <vector>

namespace kfast::test {

/// A drawing as bones carry it at one moment (docs/format.md, "Skins").
class PosedDrawing {
public:
    /// `motions` are those of all bones of the skeleton.
    PosedDrawing(const SkinnedDrawing& skinned, const std::vector<scene::BoneMotion>& motions);

    struct Stroke {
        Point start;
        std::vector<Segment> segments;
    };
    const std::vector<Stroke>& strokes() const { return strokes_; }

private:
    std::vector<Stroke> strokes_;
};

}
