#pragma once

#include "core/beam/beam_profile.hpp"

#include <concepts>
#include <cstdint>
#include <span>

namespace kfast {

// Compound requirements would be torn apart.
// clang-format off

/// Drives the beam of a vector display. It repeats a picture by itself, point by point at the same pace,
/// until another one is ready, and switches to it when the one before has ended. It begins parked.
template <class B>
concept Beam = requires(B& beam, const B& same, std::span<const BeamPoint> points) {
    { same.profile() } -> std::convertible_to<const BeamProfile&>;
    /// The maximum number of points of a picture.
    { same.room() } -> std::same_as<std::uint32_t>;

    /// Whether a picture may be plotted: the one that was shown last has begun.
    { same.takes_picture() } -> std::same_as<bool>;
    /// Adds points to the picture that is being plotted, no more than there is room for. Only while takes_picture().
    { beam.plot(points) } -> std::same_as<void>;
    /// The picture that was plotted, of one point at least, is shown when the one before has ended.
    { beam.show() } -> std::same_as<void>;
    /// The beam is dark at once, and waits where the profile parks it, until show(). Drops what was plotted.
    { beam.park() } -> std::same_as<void>;
};

// clang-format on

}
