#include "host/picture/board_source.hpp"

#include "firmware/run.hpp"
#include "host/failure.hpp"

#include <algorithm>
#include <string>

namespace kfast {
namespace {

constexpr int longest_scene = 10'000;

std::vector<std::byte> packed(const std::vector<std::uint8_t>& levels)
{
    std::vector<std::byte> bytes(levels.size() / 2);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::byte>(levels[2 * i] << 4 | levels[2 * i + 1]);
    return bytes;
}

}

BoardSource::BoardSource(std::span<const std::byte> scene, const Timeline& timeline)
    : timeline_{timeline}, board_{scene}, frame_{PixelFormat::grey4,
                                                 {Ssd0323Model::width, Ssd0323Model::height},
                                                 {}}
{
    if (timeline.frame_count() > longest_scene)
        throw Failure("a simulated board keeps every frame, at most " + std::to_string(longest_scene) +
                      "; the scene has " + std::to_string(timeline.frame_count()) + ": leave out --panel");
    run(board_);
    if (board_.error())
        throw Failure("the simulated board cannot play this scene");
    if (const auto mistake = board_.bus_error())
        throw Failure("the simulated panel was driven wrongly: " + *mistake);
}

const Frame& BoardSource::show(Time time)
{
    const Time shown = timeline_.shown_at(std::max(time.ticks, 0));
    const auto& frames = board_.frames();
    const auto later = std::ranges::upper_bound(frames, shown, {}, &ShownFrame::time);
    frame_.pixels = packed(std::prev(later)->picture);
    return frame_;
}

}
