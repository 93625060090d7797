#pragma once

#include "core/beam/beam_player.hpp"
#include "core/player.hpp"
#include "core/scene/scene_view.hpp"
#include "host/fit/busy_inputs.hpp"
#include "host/fit/frame_cost.hpp"
#include "host/fit/op_counts.hpp"
#include "host/fit/target.hpp"
#include "host/player/word_block.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

namespace kfast::fit {

/// What the core did for one picture, and what went over the bus.
struct FrameOps {
    Time moment;
    const std::unordered_map<std::uint32_t, OpCounts>& by_item; ///< valid during the call
    const raster::Picture& picture;                             ///< valid during the call
    std::size_t areas = 0;
    std::size_t bytes = 0;    ///< of pixels and of the commands for areas
    int unrecorded_bands = 0; ///< Player::unrecorded_bands()

    OpCounts work() const;
};

using VisitFrame = std::function<void(const FrameOps&)>;

/// Plays one round of a scene as a board does, in steps of a frame, and calls visit() for every frame. In a
/// scene that is longer than `max_frames`, frames are left out, but not those behind keys.
class SceneRun {
public:
    static constexpr int max_frames = 4096;

    /// `scene` and `target` must outlive it.
    SceneRun(const SceneView& scene, const Target& target, Fit fit);

    /// Visits the whole panel, as at the beginning of `offset`.
    void visit_first(Time offset, const VisitFrame& visit);
    /// Visits all frames, each `offset` later than in the scene: what changes since the one before.
    void visit_turn(Time offset, const VisitFrame& visit);
    /// Visits three pictures as of buttons that are pressed at once and released: all inputs leap from end to
    /// end. Does nothing if the scene has none; they are at their defaults afterwards.
    void visit_presses(const VisitFrame& visit);
    /// As visit_turn(), while all inputs of the scene are busy (BusyInputs): at least BusyInputs::turn
    /// frames. Does nothing if it has none; they are at their defaults afterwards.
    void visit_turn_with_inputs(const VisitFrame& visit);
    /// Visits a picture in which all drawings among the inputs are noise, after another such picture; nothing
    /// if there are none. They are at their defaults afterwards.
    void visit_noise(const VisitFrame& visit);
    /// Visits the very end, which the scene shows at last if it plays once; does nothing otherwise.
    void visit_end(const VisitFrame& visit);
    /// The outlines of the first picture so far that was not complete for want of room, even if not visited.
    const std::optional<LargestOutlines>& overfull() const { return overfull_; }
    /// The approximate number of frames of visit_turn(), twice, and of visit_turn_with_inputs().
    std::size_t frames_of_all() const;
    /// 1, or the number of frames of which one is visited.
    int stride() const { return stride_; }

private:
    void draw(Time moment, const VisitFrame& visit);
    void put_inputs_and_draw(Time place, const VisitFrame& visit);
    Time moment_of(int frame, Time offset) const;

    const Target& target_;
    PlayRange stretch_;
    int frames_; ///< until the picture repeats
    int stride_;
    std::vector<int> visited_;
    WordBlock block_;
    std::vector<std::byte> band_;
    Player player_;
    BusyInputs inputs_;
    std::optional<LargestOutlines> overfull_;
};

/// What it takes to draw one picture with a beam.
struct BeamPicture {
    Time moment;
    BeamReport report;
    OpCounts work{}; ///< of evaluating the scene

    /// Whether it is another one than before, which is not computed again.
    bool is_new() const { return work[static_cast<std::size_t>(Op::item)] != 0; }
};

using VisitPicture = std::function<void(const BeamPicture&)>;

/// Plays one round of a scene as a board with a beam does, in steps of a frame. In a scene that is longer
/// than `max_frames`, frames are left out, but not those behind keys.
class BeamRun {
public:
    static constexpr int max_frames = 4096;

    /// `scene` must outlive it. `target` has a beam.
    BeamRun(const SceneView& scene, const Target& target);

    /// Visits all frames; those again with busy inputs (BusyInputs), if there are some, three in which all
    /// inputs leap from end to end, and one in which all drawings are noise; and the very end of a scene that
    /// plays once.
    void visit_all(const VisitPicture& visit);
    /// The approximate number of frames of visit_all().
    std::size_t frames_of_all() const;
    /// 1, or the number of frames of which one is visited.
    int stride() const { return stride_; }

private:
    void visit_busy(const VisitPicture& visit);
    void show(Time moment, const VisitPicture& visit);
    Time moment_of(int frame) const;

    PlayRange stretch_;
    int frames_; ///< until the picture repeats
    int stride_;
    std::vector<int> visited_;
    WordBlock block_;
    BeamPlayer player_;
    BusyInputs inputs_;
};

}
