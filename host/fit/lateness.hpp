#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace kfast::fit {

/// What becomes of the frames of one turn of a scene on a board, which shows each when it is due
/// (firmware/run.hpp).
struct Lateness {
    std::size_t frames = 0;
    std::size_t late = 0;     ///< are not there when the next one is due, or not at all
    std::size_t left_out = 0; ///< of these: their time has passed before they are begun

    bool is_all() const { return late != 0 && late == frames; }
};

/// `seconds` are those that the frames take, in their order.
Lateness lateness(std::span<const double> seconds, double frames_per_second);

/// "12 of 76 pictures late, 5 of them left out"; empty if none is late.
std::string late_text(const Lateness& lateness);

}
