#pragma once

#include "host/scene/model.hpp"

namespace kfast {

struct TrackRange {
    double least;
    double most;
};

/// Between what the value of `track` lies at every moment, in the unit of its property, also where a velocity
/// law or a smooth curve leads beyond the keys.
TrackRange track_range(const scene::Track& track);

/// That of the track of `property`, or of the value `without` if there is none.
TrackRange track_range(const std::vector<scene::Track>& tracks, Property property, double without);

/// How far from 0 the value gets at most.
double track_peak(const scene::Track& track);
double track_peak(const std::vector<scene::Track>& tracks, Property property, double without);

}
