#include "core/beam/beam_plot.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr Colour blanked{.opacity = 0};
constexpr Colour whole_light{255, 255, 255, 255};

}

BeamPlot::BeamPlot(const BeamLines& lines, std::span<const BeamLeg> legs, const BeamProfile& profile,
                   const BeamPace& pace)
    : course_{lines, legs.first(pace.legs), BeamGait{profile, pace.haste}, pace.pause}, places_{course_},
      standing_{profile, pace.amount.points}, is_late_{profile.light_delay != 0}, is_laser_{profile.is_laser},
      brightness_{profile.brightness}
{
    for (int ahead = 0; ahead < profile.light_delay; ++ahead)
        next_place();
}

std::size_t BeamPlot::next(std::span<BeamPoint> points)
{
    std::size_t count = 0;
    while (count < points.size() && (course_.left() != 0 || course_.next_run())) {
        const std::size_t run = std::min<std::size_t>(points.size() - count, course_.left());
        plot_run(points.subspan(count, run));
        count += run;
    }
    return count;
}

void BeamPlot::plot_run(std::span<BeamPoint> points)
{
    const bool is_guarded = is_laser_ && course_.is_lit();
    const Colour colour = light();
    for (BeamPoint& point : points) {
        const FieldPoint at = course_.next();
        point.at = is_late_ ? next_place() : at;
        point.colour = colour;
        if (is_guarded && !standing_.may_shine(at))
            point.colour = blanked;
    }
}

FieldPoint BeamPlot::next_place()
{
    while (places_.left() == 0 && !places_.next_run())
        places_.restart();
    return places_.next();
}

Colour BeamPlot::light() const
{
    if (!course_.is_lit())
        return blanked;
    return brightness_ == BeamBrightness::by_level ? course_.colour() : whole_light;
}

}
