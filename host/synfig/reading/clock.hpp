#pragma once

#include <functional>
#include <vector>

namespace kfast::synfig {

/// From frames of the scene to seconds of a canvas, which may run faster, later, or again and again.
class Driver {
public:
    /// What the time of what is inside is made of that around it, both in seconds.
    struct Gear {
        std::function<double(double)> inside;
        /// The times around, from the first to the second one, that are the third one inside.
        std::function<std::vector<double>(double, double, double)> around;
    };

    Driver(double begin, double frame_rate) : begin_{begin}, frame_rate_{frame_rate} {}

    double seconds(double frame) const;
    /// All frames of the scene, up to `last`, that are a time of the canvas.
    std::vector<double> frames(double seconds, double last) const;
    Driver with(Gear gear) const;
    bool is_plain() const { return gears_.empty(); } ///< goes with the scene

private:
    double begin_;
    double frame_rate_;
    std::vector<Gear> gears_; ///< the outermost first
};

/// Runs `factor` times as fast, and is `offset` at the time 0. Both may change.
Driver::Gear running_gear(std::function<double(double)> factor, std::function<double(double)> offset);
/// Runs from `inside` on for a duration above 0 or below, again and again, since and before `local`.
Driver::Gear looping_gear(double inside, double local, double duration, double shift_before);
/// Is as a value of the file says.
Driver::Gear free_gear(std::function<double(double)> time);

}
