#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace kfast::fit {

/// How many frames of one turn of a scene a board shows late, or not at all. It begins each frame when it is
/// due, or at once if that has passed (firmware/run/run.hpp).
struct Lateness {
    std::size_t frames = 0;   ///< of the turn
    std::size_t late = 0;     ///< those that are not finished when the next one is due, or are left out
    std::size_t left_out = 0; ///< those of them whose time had passed before they were begun

    bool is_all() const { return late != 0 && late == frames; }
};

/// `seconds` has how long the board takes for each frame of the turn, in their order; more than 1000 s count
/// as 1000 s. `frames_per_second` is the wanted rate, at least 0.001.
Lateness lateness(std::span<const double> seconds, double frames_per_second);

/// Returns "12 of 76 pictures late, 5 of them left out", or nothing if none is late.
std::string late_text(const Lateness& lateness);

}
