#pragma once

#include "host/scene/model.hpp"

namespace kfast {

/// How far from 0 the value of `track` gets at most, in the unit of its property, also where a velocity law
/// leads beyond the keys.
double track_peak(const scene::Track& track);

/// The peak of the track of `property`, or that of the value `without` if there is none.
double track_peak(const std::vector<scene::Track>& tracks, Property property, double without);

}
