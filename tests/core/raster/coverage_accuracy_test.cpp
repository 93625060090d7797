#include "core/raster/renderer.hpp"
#include "tests/core/raster/true_area.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace kfast::raster {
namespace {

/// The levels of a polygon in white on black, 0 … 255.
std::vector<int> drawn(const std::vector<Corner>& corners, Size panel)
{
    const RendererNeeds needs{.outline_bytes = 20000, .record_bytes = 0, .steps = 1, .group_depth = 0};
    std::vector<std::uint32_t> block(Renderer::block_bytes(needs, panel) / 4);
    Renderer renderer{needs, panel, {}, std::as_writable_bytes(std::span{block})};
    renderer.picture().add_layer({.colour = {255, 255, 255}}, 0, {}, [&] {
        for (const Corner corner : corners)
            renderer.picture().outlines.add(corner);
        renderer.picture().outlines.close();
    });
    renderer.begin();
    std::vector<std::byte> pixels(row_bytes(PixelFormat::rgb666, panel.width) *
                                  static_cast<std::size_t>(panel.height));
    renderer.draw_rows<PixelFormat::rgb666>(0, panel.height, pixels);
    std::vector<int> levels;
    for (std::size_t i = 0; i < pixels.size(); i += 3)
        levels.push_back(static_cast<int>(widen_channel(std::to_integer<std::uint32_t>(pixels[i]) >> 2, 63)));
    return levels;
}

int largest_error(const std::vector<Corner>& corners, Size panel)
{
    const std::vector<int> levels = drawn(corners, panel);
    int largest = 0;
    for (int y = 0; y < panel.height; ++y)
        for (int x = 0; x < panel.width; ++x) {
            const int wanted = static_cast<int>(std::lround(255 * std::abs(test::true_area(corners, x, y))));
            largest =
                std::max(largest, std::abs(levels[static_cast<std::size_t>(y * panel.width + x)] - wanted));
        }
    return largest;
}

constexpr int bend_error = 16;  ///< in levels of 255
constexpr int format_error = 3; ///< of 6 bits a channel, in levels of 255

}

TEST_CASE("straight edges are covered by their areas")
{
    std::mt19937 random{11};
    const auto within = [&](int size) {
        return static_cast<std::int32_t>(random() % static_cast<unsigned>(size * 64));
    };
    int largest = 0;
    for (int round = 0; round < test::rounds(300); ++round) {
        // Corners that are further than a row from each other: no row has more than one of them.
        std::vector<Corner> triangle{
            {within(40), within(8)}, {within(40), within(8) + 12 * 64}, {within(40), within(8) + 24 * 64}};
        largest = std::max(largest, largest_error(triangle, {40, 32}));
    }
    CHECK(largest <= bend_error + format_error);
}

TEST_CASE("bends of a curve are off by a sixteenth of a pixel, at most")
{
    for (int radius = 1; radius < 20; ++radius) {
        CAPTURE(radius);
        std::vector<Corner> circle;
        const int count = 6 + 4 * radius;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * 3.14159265358979 * i / count;
            circle.push_back(
                {static_cast<std::int32_t>(std::lround(64 * (20.3 + radius * std::cos(angle)))),
                 static_cast<std::int32_t>(std::lround(64 * (20.7 + radius * std::sin(angle))))});
        }
        CHECK(largest_error(circle, {42, 42}) <= bend_error + format_error);
    }
}

}
