#include "host/compiler/scale_bound.hpp"

#include "host/compiler/track_peak.hpp"

#include <algorithm>

namespace kfast {

double scale_bound(const std::vector<scene::Track>& tracks)
{
    return std::max(track_peak(tracks, Property::scale_x, scale_one),
                    track_peak(tracks, Property::scale_y, scale_one)) /
           scale_one;
}

}
