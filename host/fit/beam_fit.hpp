#pragma once

#include "core/beam/beam_player.hpp"
#include "core/scene/scene_view.hpp"
#include "host/fit/scene_needs.hpp"
#include "host/fit/speed.hpp"
#include "host/fit/target.hpp"
#include "host/program/progress_callback.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kfast::fit {

/// The number of points that find room in one of the two buffers of a board with a beam.
std::uint32_t room_for_points(const Target& target);

/// One picture of a scene, as a board draws it.
struct BeamMoment {
    Time moment;
    BeamReport report;
    double instructions = 0; ///< to compute it and to plot it once
    double cpu_seconds = 0;
};

/// Whether a scene fits a board with a beam, and what its pictures take.
struct BeamFit {
    FlashNeed flash;
    RamNeed ram;                         ///< with the buffers for points in place of bands
    std::vector<BeamMoment> pictures;    ///< those with fewest points first
    std::size_t sped_up = 0;             ///< how many of them are drawn faster than in the profile
    std::size_t incomplete = 0;          ///< how many of them lack lines
    double dearest_seconds = 0;          ///< of the CPU
    double wanted_rate = 0;              ///< frames per second
    std::vector<std::string> shortages;  ///< of memory, and how much is missing; none if it can be played
    std::vector<std::string> weaknesses; ///< why it is not drawn as it should be, and what can be done
    std::vector<std::string> notes;      ///< what one should know besides

    /// Why it does not fit: shortages and weaknesses. None if it does.
    std::vector<std::string> reasons() const;
    bool fits() const { return shortages.empty() && weaknesses.empty(); }
    const BeamMoment& busiest() const { return pictures.back(); }
    double mean_points() const;
};

/// How often a picture is drawn in a second.
double refresh(const BeamMoment& picture, const BeamProfile& profile);

/// `target` has a beam. `frames_per_second` is the wanted rate of new pictures; 0: those of the scene.
/// Throws FitStopped.
BeamFit beam_fit(const SceneView& scene, const Target& target, double frames_per_second,
                 const std::stop_token& stop = {}, const ProgressCallback& on_progress = ignore_progress);

}
