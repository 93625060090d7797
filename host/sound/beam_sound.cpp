#include "host/sound/beam_sound.hpp"

#include <algorithm>
#include <array>
#include <utility>

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

void BeamSound::set_input(std::uint32_t number, Time place)
{
    picture_->set_input(number, place);
    beam_.set_input(number, place);
}

bool BeamSound::set_drawing(std::uint32_t number, std::span<const InputStroke> strokes)
{
    return picture_->set_drawing(number, strokes) && beam_.set_drawing(number, strokes);
}

void BeamSound::set_text(std::uint32_t number, std::string_view text)
{
    picture_->set_text(number, text);
    beam_.set_text(number, text);
}

}
