#include "host/compiler/track_peak.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kfast {
namespace {

double value_at(const scene::TrackKey& from, const scene::TrackKey& to, Way way)
{
    return std::lerp(static_cast<double>(from.value), static_cast<double>(to.value),
                     static_cast<double>(way.raw) / Way::one);
}

}

double track_peak(const scene::Track& track)
{
    double peak = std::abs(static_cast<double>(track.keys.back().value));
    for (std::size_t i = 0; i + 1 < track.keys.size(); ++i) {
        const scene::TrackKey& from = track.keys[i];
        const WayRange range = way_range(goes_by_y(track.property) ? from.laws.y : from.laws.x);
        for (const Way way : {range.least, range.most})
            peak = std::max(peak, std::abs(value_at(from, track.keys[i + 1], way)));
    }
    return peak;
}

double track_peak(const std::vector<scene::Track>& tracks, Property property, double without)
{
    const auto track = std::ranges::find(tracks, property, &scene::Track::property);
    return track == tracks.end() ? std::abs(without) : track_peak(*track);
}

}
