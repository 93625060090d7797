#pragma once

#include "library/kfast.h"

#include "tests/core/player_fixture.hpp"

#include <doctest/doctest.h>
#include <string_view>
#include <vector>

namespace kfast::test {

inline constexpr std::string_view moving = R"(
kfast 1
canvas 30 20 fps=25 background="#203040" loop=repeat
object dot fill="#ff8000" { key 0 { rect 1 1 8 8 }; key 10 { rect 20 10 8 8 } }
clip back from=4 to=8 loop=once
)";

/// The dot goes by one input, and blinks by another.
inline constexpr std::string_view steered = R"(
kfast 1
canvas 30 20 background="#203040"
input gaze min=-1 max=1 default=0.5
input open min=0 max=100
group look {
    track x input=gaze { at -1 0; at 1 20 }
    object dot fill="#ff8000" input=open { key 0 { rect 1 1 8 2 }; key 100 { rect 1 1 8 12 } }
}
)";

inline constexpr int width = 30;
inline constexpr int height = 20;
/// kfast_draw_rgb565() and its like.
using Draw = kfast_error (*)(kfast_player*, void*, size_t, kfast_draw_rectangle, void*);

/// A player on a block of its own, and a display that remembers what it is handed.
class Screen {
public:
    explicit Screen(std::string_view text, std::size_t gap = 0)
        : scene_{compiled(text)},
          block_(gap + kfast_block_bytes(scene_.data(), scene_.size(), width, height)),
          pixels_(2 * width * height)
    {
        CHECK(kfast_create(&player, block_.data() + gap, block_.size() - gap, scene_.data(), scene_.size(),
                           width, height) == KFAST_OK);
    }

    void draw(std::size_t buffer_bytes)
    {
        std::vector<std::byte> buffer(buffer_bytes);
        rectangles = 0;
        CHECK(kfast_draw_rgb565(player, buffer.data(), buffer.size(), take, this) == KFAST_OK);
    }

    const std::vector<std::byte>& pixels() const { return pixels_; }

    kfast_player* player = nullptr;
    int rectangles = 0;

private:
    static void take(int x, int y, int columns, int rows, const void* pixels, void* user)
    {
        Screen& screen = *static_cast<Screen*>(user);
        const auto* from = static_cast<const std::byte*>(pixels);
        for (int row = y; row < y + rows; ++row, from += 2 * columns)
            std::copy_n(from, 2 * columns, screen.pixels_.begin() + 2 * (row * width + x));
        ++screen.rectangles;
    }

    Bytes scene_;
    std::vector<std::byte> block_;
    std::vector<std::byte> pixels_;
};

inline Bytes picture(std::string_view text, Time moment)
{
    return PlayerFixture{text, {width, height}}.picture<PixelFormat::rgb565>(moment);
}

/// With inputs at these places.
inline Bytes picture(std::string_view text, Time gaze, Time open)
{
    PlayerFixture fixture{text, {width, height}};
    fixture.player.set_input(0, gaze);
    fixture.player.set_input(1, open);
    return fixture.picture<PixelFormat::rgb565>({});
}

}
