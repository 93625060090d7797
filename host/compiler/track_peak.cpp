#include "host/compiler/track_peak.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kfast {
namespace {

class RangeFinder {
public:
    explicit RangeFinder(const scene::Track& track) : track_{track}, range_{value(0), value(0)} {}

    TrackRange range()
    {
        for (std::size_t i = 0; i + 1 < track_.keys.size(); ++i) {
            add(value(i + 1));
            if (track_.is_smooth)
                add_curve(i);
            else
                add_swing(i);
        }
        return range_;
    }

private:
    double value(std::size_t i) const { return track_.keys[i].value; }
    double time(std::size_t i) const { return track_.keys[i].time.ticks; }

    void add(double value)
    {
        range_.least = std::min(range_.least, value);
        range_.most = std::max(range_.most, value);
    }

    void add_swing(std::size_t i)
    {
        const LawPair& laws = track_.keys[i].laws;
        const WayRange range = way_range(goes_by_y(track_.property) ? laws.y : laws.x);
        for (const Way way : {range.least, range.most})
            add(std::lerp(value(i), value(i + 1), static_cast<double>(way.raw) / Way::one));
    }

    /// Of a smooth track, per tick.
    double slope(std::size_t i) const
    {
        if (i == 0 || i + 1 == track_.keys.size())
            return 0;
        return (value(i + 1) - value(i - 1)) / (time(i + 1) - time(i - 1));
    }

    /// With u from 0 to 1 on the way from key i, the curve is value + start u + b u^2 + a u^3.
    void add_curve(std::size_t i)
    {
        const double duration = time(i + 1) - time(i);
        const double way = value(i + 1) - value(i);
        const double start = slope(i) * duration;
        const double end = slope(i + 1) * duration;
        const double b = 3 * way - 2 * start - end;
        const double a = start + end - 2 * way;
        const double square = b * b - 3 * a * start;
        if (square < 0)
            return;
        const double root = -b - std::copysign(std::sqrt(square), b);
        for (const double u : {root / (3 * a), start / root}) // not a number where there is no turn
            if (u > 0 && u < 1)
                add(value(i) + u * (start + u * (b + u * a)));
    }

    const scene::Track& track_;
    TrackRange range_;
};

double peak(TrackRange range) { return std::max(std::abs(range.least), std::abs(range.most)); }

}

TrackRange track_range(const scene::Track& track) { return RangeFinder{track}.range(); }

TrackRange track_range(const std::vector<scene::Track>& tracks, Property property, double without)
{
    const auto track = std::ranges::find(tracks, property, &scene::Track::property);
    return track == tracks.end() ? TrackRange{without, without} : track_range(*track);
}

double track_peak(const scene::Track& track) { return peak(track_range(track)); }

double track_peak(const std::vector<scene::Track>& tracks, Property property, double without)
{
    return peak(track_range(tracks, property, without));
}

}
