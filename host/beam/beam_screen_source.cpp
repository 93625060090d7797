#include "host/beam/beam_screen_source.hpp"

#include "host/beam/drawn_pictures.hpp"

#include <array>
#include <cstdio>

namespace kfast {
namespace {

double widths(std::uint64_t length) { return static_cast<double>(length) / field_side; }

}

BeamScreenSource::BeamScreenSource(const SceneView& scene, const BeamProfile& profile,
                                   const BeamDisplay& display, Size size)
    : scene_{scene}, source_{scene, profile}, screen_{profile, display, size, default_points(scene, profile)}
{
}

const Frame& BeamScreenSource::show(Time moment)
{
    const std::vector<DrawnPicture> pictures = drawn_pictures(source_, scene_, moment, screen_.memory());
    source_.show(moment);
    report_ = source_.report();
    return screen_.show(pictures);
}

std::string BeamScreenSource::facts() const
{
    std::array<char, 128> text{};
    std::snprintf(text.data(), text.size(), "%u points  %u Hz  lit %.1f  blanked %.1f", report_.points,
                  report_.points > 0 ? source_.profile().rate / report_.points : 0,
                  widths(report_.lit_length), widths(report_.blanked_length));
    return text.data();
}

}
