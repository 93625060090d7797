#pragma once

#include "core/math/affine.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"
#include "host/fit/fit_stop.hpp"
#include "host/fit/frame_cost.hpp"
#include "host/fit/largest_outlines.hpp"
#include "host/fit/target.hpp"
#include "host/program/progress_callback.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace kfast::fit {

/// The object that costs most in a picture, by its path (core/scene/item_view.hpp); and its part of the work.
struct HeaviestItem {
    std::uint32_t path = 0;
    double share = 0;
};

/// Seconds that frames take.
struct Limits {
    double median = 0;
    double worst = 0;
};

/// How fast a scene plays: by frames, and by frames half a frame later, for a panel may be faster than the
/// scene; at its very end, if it stops there; and with all of its inputs moving, if it has some.
struct Speed {
    std::vector<FrameCost> frames;           ///< the cheapest first
    FrameCost first;                         ///< at the beginning: the whole panel
    std::optional<FrameCost> noise;          ///< with noise in all drawings among the inputs (Bustle)
    HeaviestItem heaviest;                   ///< of the dearest frame
    LargestOutlines outlines;                ///< of the picture that has most
    std::optional<LargestOutlines> overfull; ///< of the first picture that is not complete for want of room
    std::vector<double> turn;                ///< seconds of the scene's frames, in their order
    std::vector<double> busy_turn;           ///< the same with its inputs moving; empty if it has none
    double leap = 0;                         ///< seconds of the dearest picture in which they leap
    Limits by_cpu;
    Limits by_bus;
    std::size_t coarse_pictures = 0; ///< of the frames: curves have fewer pieces, for want of room
    int unrecorded_bands = 0;        ///< after any picture, at most: drawn whole in the next one (Player)
    int stride = 1;                  ///< of how many frames one was looked at

    const FrameCost& median() const { return frames[frames.size() / 2]; }
    const FrameCost& worst() const { return frames.back(); }
};

/// Throws FitStopped.
Speed measured_speed(const SceneView& scene, const Target& target, Fit fit, const std::stop_token& stop,
                     const ProgressCallback& on_progress);

}
