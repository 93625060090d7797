#include "host/sound/beam_sound.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace kfast {

LedBeam::LedBeam(const BeamProfile& profile, const Deflection& deflection, const std::string& device)
    : deflection_{deflection},
      player_{profile.travel_step},
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

BeamSound::BeamSound(std::unique_ptr<FrameSource> picture, BeamSource beam, std::shared_ptr<LedBeam> led)
    : picture_{std::move(picture)}, beam_{std::move(beam)}, led_{std::move(led)}
{
}

const Frame& BeamSound::show(Time moment)
{
    accompany(moment);
    return picture_->show(moment);
}

void BeamSound::accompany(Time moment) { led_->show(beam_.show(moment)); }

bool BeamSound::set(std::uint32_t number, const InputContent& content)
{
    const bool fits = picture_->set(number, content);
    return beam_.set(number, content) && fits;
}

}
