#include "host/sound/led_beam.hpp"

#include <algorithm>
#include <array>

namespace kfast {

LedBeam::LedBeam(const BeamProfile& profile, const Deflection& deflection, const std::string& device)
    : deflection_{deflection}, player_{profile.travel_step},
      card_{SoundCard::open(device, profile.rate, [this](std::span<StereoSample> samples) { next(samples); })}
{
}

void LedBeam::show(std::span<const BeamPoint> points) { player_.show(tour_of(points)); }

void LedBeam::next(std::span<StereoSample> samples)
{
    std::array<FieldPoint, 256> points;
    while (!samples.empty()) {
        const std::span piece{points.data(), std::min(points.size(), samples.size())};
        player_.take(piece);
        std::ranges::transform(piece, samples.begin(),
                               [this](FieldPoint point) { return deflection_.sample(point); });
        samples = samples.subspan(piece.size());
    }
}

}
