#pragma once

#include "host/fit/scene_needs.hpp"
#include "host/fit/speed.hpp"
#include "host/fit/target.hpp"
#include "host/program/progress_callback.hpp"

#include <span>
#include <string>
#include <vector>

namespace kfast::fit {

/// What is required of a board.
struct FitWish {
    const SceneView& scene;
    std::span<const std::string> item_names; ///< in the order in which the scene stores items, or none
    const Target& target;
    Fit fit = Fit::contain;
    double frames_per_second = 0; ///< that every second frame reaches at least; 0: those of the scene
    std::stop_token stop = {};    ///< is set when it is not wanted any more
    ProgressCallback on_progress = ignore_progress;
};

/// Whether a scene fits a board, and how fast it plays there.
struct FitReport {
    FlashNeed flash;
    RamNeed ram;
    Speed speed;
    std::vector<LinkUpdate> link;       ///< what setting its inputs takes, if it has some
    double wanted_rate = 0;             ///< frames per second
    Lateness late;                      ///< at that rate
    Lateness late_with_inputs;          ///< while its inputs move; of no frames if it has none
    std::string heaviest_object;        ///< of the dearest frame
    std::string largest_object;         ///< of the frame with the largest outlines
    std::string overfull_object;        ///< of the first frame whose outlines find no room
    std::vector<std::string> shortages; ///< of memory, and how much is missing; none if it can be played
    std::string hang;     ///< why the board's watchdog would end the scene; empty if it does not
    std::string slowness; ///< why it plays slower than wanted, and how fast it can; empty if it does not
    std::vector<std::string> notes; ///< what one should know besides

    /// Why it does not fit: shortages, a hang and slowness. None if it does.
    std::vector<std::string> reasons() const;
    /// "12 of 76 pictures late": although it fits, and whether only while its inputs move or leap.
    /// Empty if none is late.
    std::string lateness_text() const;
    bool fits() const { return shortages.empty() && hang.empty() && slowness.empty(); }
};

/// Throws FitStopped.
FitReport fit_report(const FitWish& wish);

}
