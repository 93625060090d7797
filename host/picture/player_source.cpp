#include "host/picture/player_source.hpp"

namespace kfast {
namespace {

std::vector<std::uint32_t> block_for(const SceneView& scene, Size panel)
{
    return std::vector<std::uint32_t>((Player::block_bytes(scene, panel) + 3) / 4);
}

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
    : block_{block_for(scene, panel)}, player_{*Player::create(scene, panel, fit,
                                                               std::as_writable_bytes(std::span{block_}))},
      frame_{empty_frame(panel, format)}
{
}

const Frame& PlayerSource::show(Time moment)
{
    player_.show_moment(moment);
    draw(player_, frame_);
    return frame_;
}

}
