#include "host/beam/beam_screen_source.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace kfast {

namespace {

constexpr std::uint32_t pictures_a_second = 60;

std::int64_t rounded_up(std::int64_t number, std::int64_t step) { return (number + step - 1) / step * step; }

}

std::vector<DrawnPicture> drawn_pictures(BeamSource& source, const SceneView& scene, Time moment,
                                         std::int64_t memory)
{
    const std::uint32_t rate = source.profile().rate;
    const BeamClock clock{scene.frame_rate(), rate};
    const std::int64_t now = clock.points_at(moment);
    std::vector<DrawnPicture> pictures;
    for (std::int64_t end = now; end > now - memory || pictures.empty();) {
        const Time shown = end == now ? moment : wrap(clock.time_at(end), scene.length(), scene.loop());
        const std::span<const BeamPoint> points = source.show(shown);
        const auto tour = static_cast<std::int64_t>(points.size());
        const std::int64_t begun = pictures.empty() ? now % tour : 0;
        const std::int64_t whole = std::max<std::int64_t>(rate / pictures_a_second - begun, tour);
        const std::int64_t begin = end - begun - rounded_up(whole, tour);
        pictures.push_back({{points.begin(), points.end()}, begin, end});
        end = begin;
    }
    std::ranges::reverse(pictures);
    return pictures;
}

std::int64_t default_points(const SceneView& scene, const BeamProfile& profile)
{
    constexpr int samples = 32;
    BeamSource source{scene, profile};
    std::int64_t points = 0;
    for (int i = 0; i < samples; ++i) {
        const std::int64_t ticks = std::int64_t{scene.length().ticks} * i / samples;
        points += static_cast<std::int64_t>(source.show({static_cast<std::int32_t>(ticks)}).size());
    }
    return std::max<std::int64_t>(points / samples, 1);
}

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
