#pragma once

#include "core/beam/beam_lines.hpp"
#include "core/beam/beam_profile.hpp"
#include "core/beam/beam_route.hpp"
#include "core/beam/point_stream.hpp"
#include "core/bytes/result.hpp"
#include "core/pose/scene_state.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// What it takes to draw one picture. Lengths are in units of the field.
struct BeamReport {
    std::uint32_t points = 0; ///< of the whole picture, including the return to its beginning
    std::uint32_t lit_points = 0;
    std::uint64_t lit_length = 0;
    std::uint64_t blanked_length = 0;
    std::uint32_t lines = 0;    ///< the lines that are drawn
    std::uint32_t corners = 0;  ///< of all lines, including their ends
    std::uint32_t compared = 0; ///< the approximate number of travels compared to find the order of the lines
    int speed_level = 0;        ///< the beam is 2^(speed_level / 4) times as fast, to keep within the budget
    bool is_complete = true;    ///< there was room and time for all lines
    std::uint32_t wider_hatchings = 0; ///< objects whose hatchings are wider than written, for want of room
};

/// Draws a scene at any time as points of a beam, in memory that the caller lends.
///
/// The points depend on scene, time, inputs, profile and budget alone: not on earlier pictures.
class BeamPlayer : public SceneState {
public:
    /// Bytes that create() must be lent: enough for every time of the scene.
    static std::size_t block_bytes(const SceneView& scene, const BeamProfile& profile);

    /// `scene`'s bytes and `block` (aligned to 4 bytes) must outlive the player. A picture has no more than
    /// `budget` points, at least 16, nor more than the profile's refresh leaves time for. Fails with
    /// block_too_small.
    static Result<BeamPlayer> create(const SceneView& scene, const BeamProfile& profile, std::uint32_t budget,
                                     std::span<std::byte> block);

    /// Computes the picture at `time`. Any time is allowed: the scene's loop mode decides what it represents.
    void show(Time time);
    /// As show(), but without loop: the scene's beginning before it and its very end from there on.
    void show_moment(Time moment);

    /// As create(), but `block` has block_bytes(), no more and no less.
    [[gnu::cold, gnu::noinline]] BeamPlayer(const SceneView& scene, const BeamProfile& profile,
                                            std::uint32_t budget, std::span<std::byte> block);

    const BeamReport& report() const { return report_; }
    /// Whether, for want of room in the block, its curves are coarser, hatchings wider, or lines are missing.
    bool is_coarse() const { return is_coarse_; }
    /// The points of the picture, from its beginning. They can be repeated as they are: the last one is
    /// followed by the first one. At least one: where there is nothing to draw, the beam is parked. Valid
    /// until the next call of show().
    PointStream plot() const { return {lines_, legs_, profile_, timing_}; }
    const BeamProfile& profile() const { return profile_; }

private:
    void trace();
    void measure();

    BeamProfile profile_;
    std::uint32_t budget_;
    BeamLines lines_;
    std::span<BeamLeg> leg_storage_;
    std::span<const BeamLeg> legs_;
    BeamTiming timing_;
    BeamReport report_;
    std::uint32_t compared_ = 0;
    std::uint32_t wider_hatchings_ = 0;
    bool is_coarse_ = false;
    Dependence dependence_; ///< what the picture depends on
};

}
