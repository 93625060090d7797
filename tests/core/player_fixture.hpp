#pragma once

#include "core/player.hpp"
#include "tests/compiled.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::test {

using Bytes = std::vector<std::byte>;

inline SceneView accepted(const Bytes& file)
{
    const auto scene = SceneView::parse(file);
    if (!scene)
        throw std::invalid_argument{"the scene is refused: " +
                                    std::to_string(static_cast<int>(scene.error()))};
    return *scene;
}

/// A player and what it borrows.
struct PlayerFixture {
    Bytes bytes;
    SceneView scene;
    Bytes block;
    Player player;

    PlayerFixture(std::string_view text, Size panel, Fit fit = Fit::contain)
        : PlayerFixture{compiled(text), panel, fit}
    {
    }

    PlayerFixture(Bytes file, Size panel, Fit fit = Fit::contain)
        : bytes{std::move(file)},
          scene{accepted(bytes)},
          block(Player::block_bytes(scene, panel)),
          player{*Player::create(scene, panel, fit, block)}
    {
    }

    /// The picture at `time`, drawn in bands of `band_rows` rows.
    template <PixelFormat format = PixelFormat::rgb565>
    Bytes picture(Time time, int band_rows = 1000)
    {
        const Size panel = player.panel();
        const std::size_t stride = row_bytes(format, panel.width);
        Bytes pixels(stride * static_cast<std::size_t>(panel.height));
        player.show(time);
        for (int row = 0; row < panel.height; row += band_rows) {
            const int rows = std::min(band_rows, panel.height - row);
            player.draw_rows<format>(rows, std::span{pixels}.subspan(stride * static_cast<std::size_t>(row)));
        }
        return pixels;
    }
};

/// A digit for each pixel.
inline std::string row_text(const Bytes& grey4)
{
    std::string text;
    for (const std::byte pair : grey4) {
        text += "0123456789abcdef"[std::to_integer<int>(pair) >> 4];
        text += "0123456789abcdef"[std::to_integer<int>(pair) & 15];
    }
    return text;
}

}
