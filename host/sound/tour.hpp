#pragma once

#include "core/beam/beam_profile.hpp"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace kfast {

/// Where a beam is, sample by sample, once along a picture. A sound card cannot control whether it shines.
using Tour = std::vector<FieldPoint>;

Tour tour_of(std::span<const BeamPoint> points);

/// The distance in units of the field.
double distance(FieldPoint from, FieldPoint to);

/// The points between two points so that no step is longer than `step`; 0: none, the beam jumps.
Tour travel(FieldPoint from, FieldPoint to, std::uint32_t step);

/// `count` points, at least as many as `tour` has, evenly spread along the path from its beginning to `next`,
/// where the beam is afterwards. No step is longer than the longest one before.
Tour stretched(std::span<const FieldPoint> tour, FieldPoint next, std::size_t count);

/// Plays tours one after another without a pause: the one that was shown last, again and again, whole each
/// time. One thread shows, another one, that of the sound, takes the points.
class TourPlayer {
public:
    /// Between tours the beam travels in such steps; 0: it jumps. Begins in the middle of the field.
    explicit TourPlayer(std::uint32_t travel_step) : step_{travel_step} {}

    /// Shows it from the end of the tour that is being played. `tour` has at least one point.
    void show(Tour tour);
    /// Fills all of `points` with the next ones.
    void take(std::span<FieldPoint> points);

private:
    void begin_tour();

    std::uint32_t step_;
    std::mutex mutex_;         ///< of `next_`
    std::optional<Tour> next_; ///< shown, but not begun
    Tour tour_{FieldPoint{}};
    Tour travel_;               ///< to the beginning of the tour
    std::size_t travelled_ = 0; ///< points of it
    std::size_t at_ = 0;        ///< points of the tour
};

}
