#include "host/beam/drawn_pictures.hpp"

#include "host/beam/beam_clock.hpp"

#include <algorithm>

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

}
