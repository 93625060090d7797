// Writes one frame of a compiled scene as a grey picture: play SCENE.kfb FRAME >frame.pgm
#include "core/player.hpp"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <span>
#include <vector>

namespace {

constexpr kfast::Size panel{128, 64};
constexpr int band_rows = 8;

std::vector<std::byte> read(const char* path)
{
    std::ifstream file{path, std::ios::binary};
    const std::vector<char> chars{std::istreambuf_iterator<char>{file}, {}};
    const auto bytes = std::as_bytes(std::span{chars});
    return {bytes.begin(), bytes.end()};
}

// Two pixels a byte, the left one in the high nibble.
void print(const std::vector<std::byte>& pixels)
{
    for (const std::byte pair : pixels)
        std::printf("%d %d\n", std::to_integer<int>(pair >> 4), std::to_integer<int>(pair & std::byte{15}));
}

bool play(const std::vector<std::byte>& bytes, int frame)
{
    const auto scene = kfast::SceneView::parse(bytes);
    if (!scene)
        return false;
    std::vector<std::byte> block(kfast::Player::block_bytes(*scene, panel));
    auto player = kfast::Player::create(*scene, panel, kfast::Fit::contain, block);
    if (!player)
        return false;

    constexpr auto format = kfast::PixelFormat::grey4;
    std::vector<std::byte> band(band_rows * kfast::row_bytes(format, panel.width));
    player->show(kfast::Time::frame(frame));
    std::printf("P2\n%d %d\n15\n", panel.width, panel.height);
    for (int row = 0; row < panel.height; row += band_rows) {
        player->draw_rows<format>(band_rows, band);
        print(band);
    }
    return true;
}

}

int main(int argc, char** argv)
{
    if (argc != 3) {
        std::fprintf(stderr, "usage: play SCENE.kfb FRAME >frame.pgm\n");
        return 2;
    }
    if (!play(read(argv[1]), std::atoi(argv[2]))) {
        std::fprintf(stderr, "play: %s is not a scene that this version plays\n", argv[1]);
        return 1;
    }
}
