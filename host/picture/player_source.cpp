#include "host/picture/player_source.hpp"

namespace kfast {
namespace {

void draw(Player& player, Frame& frame)
{
    with_format(*frame.format,
                [&]<PixelFormat format>() { player.draw_rows<format>(frame.size.height, frame.pixels); });
}

Frame empty_frame(Size size, PixelFormat format)
{
    const std::size_t bytes = row_bytes(format, size.width) * static_cast<std::size_t>(size.height);
    return {format, size, std::vector<std::byte>(bytes)};
}

}

PlayerSource::PlayerSource(const SceneView& scene, Size panel, Fit fit, PixelFormat format)
    : block_{Player::block_bytes(scene, panel)},
      player_{*Player::create(scene, panel, fit, block_.bytes())},
      frame_{empty_frame(panel, format)}
{
}

const Frame& PlayerSource::show(Time moment)
{
    player_.show_moment(moment);
    draw(player_, frame_);
    detail_.add(player_.picture());
    return frame_;
}

}
