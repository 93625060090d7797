// Plays a clip of the robot eyes on a display, which here is an array: wink >frames.rgb565
#include "robot_eyes.h" // kfast export --header ../robot-eyes.kfast -o robot_eyes.h

#include <array>
#include <cstdio>
#include <kfast.hpp>

namespace {

constexpr int width = robot_eyes_width;
std::array<std::byte, 2 * width * robot_eyes_height> display;

void draw_rectangle(kfast::Rect area, std::span<const std::byte> pixels)
{
    const auto stride = static_cast<std::size_t>(2 * area.width);
    for (int y = area.y; y < area.y + area.height; ++y, pixels = pixels.subspan(stride))
        std::ranges::copy(pixels.first(stride), &display[static_cast<std::size_t>(2 * (y * width + area.x))]);
}

alignas(4) std::array<std::byte, robot_eyes_block_bytes> block;
std::array<std::byte, 16 * 2 * width> buffer;

}

int main()
{
    const auto scene = std::as_bytes(std::span{robot_eyes});
    constexpr kfast::Features features = ROBOT_EYES_FEATURES;
    auto eyes =
        kfast::Animation::create(scene, {width, robot_eyes_height}, block, kfast::Fit::contain, features);
    if (!eyes || !eyes->choose_clip("blink"))
        return 1;
    for (int frame = 0; frame <= 10; ++frame) {
        eyes->show(kfast::Time::frame(frame));
        eyes->draw<kfast::PixelFormat::rgb565>(buffer, draw_rectangle);
        std::fwrite(display.data(), display.size(), 1, stdout);
    }
}
