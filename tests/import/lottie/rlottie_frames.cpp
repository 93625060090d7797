// rlottie_frames ANIMATION.json WIDTH HEIGHT FRAME PICTURE.png [FRAME PICTURE.png ...]
//
// Draws frames of a Lottie animation on black with rlottie, which owes nothing to kfast.

#include "host/picture/png.hpp"
#include "host/program/failure.hpp"

#include <rlottie.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace {

/// What rlottie draws has premultiplied colours: on black, that is how they look.
kfast::Picture drawn(rlottie::Animation& animation, kfast::Size size, std::size_t frame)
{
    const auto width = static_cast<std::size_t>(size.width);
    const auto height = static_cast<std::size_t>(size.height);
    std::vector<std::uint32_t> pixels(width * height);
    animation.renderSync(frame,
                         rlottie::Surface{pixels.data(), width, height, width * sizeof(std::uint32_t)});
    kfast::Picture picture{size, {}};
    for (const std::uint32_t pixel : pixels)
        picture.pixels.push_back({static_cast<std::uint8_t>(pixel >> 16),
                                  static_cast<std::uint8_t>(pixel >> 8), static_cast<std::uint8_t>(pixel)});
    return picture;
}

void draw(const std::vector<std::string>& arguments)
{
    const auto animation = rlottie::Animation::loadFromFile(arguments[0]);
    if (!animation)
        throw kfast::Failure{arguments[0] + ": rlottie does not read it"};
    const kfast::Size size{std::stoi(arguments[1]), std::stoi(arguments[2])};
    for (std::size_t i = 3; i + 1 < arguments.size(); i += 2)
        write_png(arguments[i + 1], drawn(*animation, size, std::stoul(arguments[i])));
}

}

int main(int count, char** words)
{
    const std::vector<std::string> arguments{words + 1, words + count};
    if (arguments.size() < 5) {
        std::fputs(
            "usage: rlottie_frames ANIMATION.json WIDTH HEIGHT FRAME PICTURE.png [FRAME PICTURE.png ...]\n",
            stderr);
        return 2;
    }
    try {
        draw(arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
