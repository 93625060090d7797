#pragma once

#include "core/beam/beam_player.hpp"
#include "core/scene/scene_view.hpp"
#include "host/fit/busy_inputs.hpp"
#include "host/fit/op_counts.hpp"
#include "host/fit/target.hpp"
#include "host/player/word_block.hpp"

#include <cstddef>
#include <functional>

namespace kfast::fit {

/// What it takes to draw one picture with a beam.
struct BeamPicture {
    Time moment;
    BeamReport report;
    OpCounts work{}; ///< of evaluating the scene

    /// It was not the one before, which is not computed again.
    bool is_new() const { return work[static_cast<std::size_t>(Op::item)] != 0; }
};

using VisitPicture = std::function<void(const BeamPicture&)>;

/// Plays one turn of a scene as a board with a beam does, in steps of a frame. Of a scene that is longer than
/// `max_frames`, some frames are left out.
class BeamRun {
public:
    static constexpr int max_frames = 4096;

    /// `scene` must outlive it. `target` has a beam.
    BeamRun(const SceneView& scene, const Target& target);

    /// All frames; those again with busy inputs (BusyInputs), if there are some, three in which all inputs
    /// leap from end to end, and one in which all drawings are noise; and the very end of a scene that plays
    /// once.
    void visit_all(const VisitPicture& visit);
    /// Of visit_all(), more or less.
    std::size_t frames_of_all() const;
    /// 1, or of how many frames one is visited.
    int stride() const { return stride_; }

private:
    void visit_busy(const VisitPicture& visit);
    void show(Time moment, const VisitPicture& visit);
    Time moment_of(int frame) const;

    PlayRange stretch_;
    int frames_; ///< until the picture comes round again
    int stride_;
    WordBlock block_;
    BeamPlayer player_;
    BusyInputs inputs_;
};

}
