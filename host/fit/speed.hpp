#pragma once

#include "core/math/affine.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"
#include "host/fit/frame_cost.hpp"
#include "host/fit/target.hpp"
#include "host/program/progress_callback.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace kfast::fit {

/// For numbers that were rounded, as a factor: 16.667 ms are 60 fps.
inline constexpr double slack = 1.0001;

/// Thrown by a report that is not wanted any more, after the current picture.
struct FitStopped {};

inline void go_on(const std::stop_token& stop)
{
    if (stop.stop_requested())
        throw FitStopped{};
}

/// How many frames of one round of a scene a board shows late, or not at all. It begins each frame when it is
/// due, or at once if that has passed (firmware/run/run.hpp).
struct Lateness {
    std::size_t frames = 0;   ///< of the round
    std::size_t late = 0;     ///< those that are not finished when the next one is due, or are left out
    std::size_t left_out = 0; ///< those of them whose time had passed before they were begun

    bool is_all() const { return late != 0 && late == frames; }
};

/// `seconds` has how long the board takes for each frame of the round, in their order; more than 1000 s count
/// as 1000 s. `frames_per_second` is the wanted rate, at least 0.001.
Lateness lateness(std::span<const double> seconds, double frames_per_second);

/// Returns "12 of 76 pictures late, 5 of them left out", or nothing if none is late.
std::string late_text(const Lateness& lateness);

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
    int unrecorded_bands = 0;        ///< the maximum after any picture: drawn whole in the next one (Player)
    int stride = 1;                  ///< of how many frames one was measured

    const FrameCost& median() const { return frames[frames.size() / 2]; }
    const FrameCost& worst() const { return frames.back(); }
};

/// Throws FitStopped.
Speed measured_speed(const SceneView& scene, const Target& target, Fit fit, const std::stop_token& stop,
                     const ProgressCallback& on_progress);

}
