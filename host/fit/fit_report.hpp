#pragma once

#include "host/fit/link_need.hpp"
#include "host/fit/memory_need.hpp"
#include "host/fit/speed.hpp"
#include "host/fit/target.hpp"

#include <span>
#include <string>
#include <vector>

namespace kfast::fit {

/// What is asked of a board.
struct FitWish {
    const SceneView& scene;
    std::span<const std::string> item_names; ///< in the order in which the scene stores items, or none
    const Target& target;
    Fit fit = Fit::contain;
    double frames_per_second = 0; ///< that every second frame reaches at least; 0: those of the scene
};

/// Whether a scene fits a board, and how fast it plays there.
struct FitReport {
    FlashNeed flash;
    RamNeed ram;
    Speed speed;
    std::vector<LinkUpdate> link;     ///< what telling its inputs takes, if it has some
    double wanted_rate = 0;           ///< frames per second
    std::string heaviest_object;      ///< of the dearest frame
    std::string largest_object;       ///< of the frame with the largest outlines
    std::string overfull_object;      ///< of the first frame whose outlines find no room
    std::vector<std::string> reasons; ///< why it does not fit, and by how much; none if it does
    std::vector<std::string> notes;   ///< what one should know besides

    bool fits() const { return reasons.empty(); }
};

FitReport fit_report(const FitWish& wish);

}
