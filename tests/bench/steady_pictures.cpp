#include "tests/bench/steady_pictures.hpp"

#include <utility>

namespace kfast::bench {
namespace {

constexpr PixelFormat format = PixelFormat::rgb565;
constexpr std::size_t pixel_bytes = 2;

std::size_t picture_bytes(Size panel)
{
    return static_cast<std::size_t>(panel.height) * row_bytes(format, panel.width);
}

}

SteadyPictures::SteadyPictures(const SceneView& scene, const PlayRange& stretch)
    : block_(Player::block_bytes(scene, scene.canvas())),
      playhead_{stretch, scene.events()},
      player_{*Player::create(scene, scene.canvas(), Fit::contain, block_)},
      picture_(picture_bytes(scene.canvas())),
      before_(picture_.size())
{
    draw();
}

void SteadyPictures::advance()
{
    playhead_.advance(Time::ticks_per_frame);
    std::swap(picture_, before_);
    draw();
}

std::uint32_t SteadyPictures::changed_bytes() const
{
    std::uint32_t bytes = 0;
    for (std::size_t i = 0; i < picture_.size(); i += pixel_bytes)
        if (picture_[i] != before_[i] || picture_[i + 1] != before_[i + 1])
            bytes += pixel_bytes;
    return bytes;
}

void SteadyPictures::draw()
{
    player_.show_moment(playhead_.moment());
    player_.draw_rows<format>(player_.panel().height, picture_);
}

}
