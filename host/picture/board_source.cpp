#include "host/picture/board_source.hpp"

#include "firmware/run.hpp"
#include "host/failure.hpp"

namespace kfast {
namespace {

std::vector<std::byte> packed(const Ssd0323Model::Picture& levels)
{
    std::vector<std::byte> bytes(levels.size() / 2);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::byte>(levels[2 * i] << 4 | levels[2 * i + 1]);
    return bytes;
}

}

BoardSource::BoardSource(std::span<const std::byte> scene)
    : board_{scene, 0}, player_{*Player::create(*SceneView::parse(scene), board_.panel().size(), Fit::contain,
                                                board_.block())},
      frame_{PixelFormat::grey4, board_.panel().size(), {}}
{
    begin_panel(board_);
}

const Frame& BoardSource::show(Time moment)
{
    player_.show_moment(moment);
    draw_frame(board_, player_);
    if (const auto mistake = board_.bus_error())
        throw Failure("the simulated panel was driven wrongly: " + *mistake);
    frame_.pixels = packed(board_.picture());
    return frame_;
}

}
