#pragma once

#include "host/scene/model.hpp"

#include <limits>
#include <optional>
#include <span>

namespace kfast::scene {

/// A pattern of dashes in pixels.
struct DashPattern {
    double period = std::numeric_limits<double>::infinity();
    double dashes = 0; ///< in each period; 0: the strokes are not dashed
};

/// The shortest that an object has at its keys, of those that have a length.
DashPattern shortest_pattern(std::span<const Track> tracks);

/// The shortest that it has between two keys, by their laws, and the place of the later one. Nothing if the
/// pattern does not change.
struct MovedPattern {
    DashPattern pattern;
    SourceSpan place;
};
std::optional<MovedPattern> shortest_pattern_between_keys(std::span<const Track> tracks);

/// The dashes of the drawing that has most. What is cut off at both ends of a stroke counts as dashes of
/// their own.
double dashes_of(std::span<const Key> keys, const DashPattern& pattern);

/// No drawing between two of the keys comes to more.
double dashes_between(std::span<const Key> keys, const DashPattern& pattern);

/// How many times as long strokes become where bones bend and stretch them, twice as long for bends alone;
/// infinity where bones move apart.
double growth_by(const Bones& skeleton);
/// Where backbones do.
double growth_by(std::span<const BackboneKey> keys);

}
