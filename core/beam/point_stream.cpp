#include "core/beam/point_stream.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr Colour blanked{.opacity = 0};
constexpr Colour whole_light{255, 255, 255, 255};

}

PointStream::PointStream(const BeamLines& lines, std::span<const BeamLeg> legs, const BeamProfile& profile,
                         const BeamTiming& timing)
    : sequencer_{lines, legs.first(timing.legs), StepProfile{profile, timing.speed_level}, timing.pause},
      places_{sequencer_}, standing_{profile, timing.amount.points}, is_late_{profile.light_delay != 0},
      is_laser_{profile.is_laser}, brightness_{profile.brightness}
{
    for (int ahead = 0; ahead < profile.light_delay; ++ahead)
        next_place();
}

std::size_t PointStream::next(std::span<BeamPoint> points)
{
    std::size_t count = 0;
    while (count < points.size() && (sequencer_.left() != 0 || sequencer_.next_run())) {
        const std::size_t run = std::min<std::size_t>(points.size() - count, sequencer_.left());
        plot_run(points.subspan(count, run));
        count += run;
    }
    return count;
}

void PointStream::plot_run(std::span<BeamPoint> points)
{
    const bool is_guarded = is_laser_ && sequencer_.is_lit();
    const Colour colour = light();
    for (BeamPoint& point : points) {
        const FieldPoint at = sequencer_.next();
        point.at = is_late_ ? next_place() : at;
        point.colour = colour;
        if (is_guarded && !standing_.may_shine(at))
            point.colour = blanked;
    }
}

FieldPoint PointStream::next_place()
{
    while (places_.left() == 0 && !places_.next_run())
        places_.restart();
    return places_.next();
}

Colour PointStream::light() const
{
    if (!sequencer_.is_lit())
        return blanked;
    return brightness_ == BeamBrightness::by_level ? sequencer_.colour() : whole_light;
}

}
