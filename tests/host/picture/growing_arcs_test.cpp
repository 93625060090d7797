#include "core/player.hpp"
#include "tests/compiled.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

constexpr int last_frame = 40;
constexpr int max_difference = 16; ///< of 255

std::vector<std::byte> picture(const std::string& object, int frame)
{
    const auto bytes = compiled("kfast 1\ncanvas 120 120 frames=41 background=black\n" + object);
    const auto scene = SceneView::parse(bytes);
    REQUIRE(scene);
    std::vector<std::uint32_t> block(Player::block_bytes(*scene, scene->canvas()) / 4 + 1);
    Player player{*scene, scene->canvas(), Fit::contain, std::as_writable_bytes(std::span{block})};
    player.show(Time::frame(frame));
    std::vector<std::byte> pixels(120 * 120 * 3);
    player.draw_rows<PixelFormat::rgb666>(120, pixels);
    return pixels;
}

/// A sector about (60, 60), of degrees from three o'clock, or a line along its arc.
struct Exact {
    double radius = 0;
    double from = 0;
    double to = 0;
    double width = 0; ///< of the line; 0: the sector is filled
    bool has_round_caps = false;

    bool covers(double x, double y) const
    {
        const double distance = std::hypot(x - 60, y - 60);
        const bool is_in_ring = width == 0 ? distance <= radius : std::abs(distance - radius) <= width / 2;
        if (is_in_ring && is_within(std::atan2(y - 60, x - 60) * 180 / std::numbers::pi))
            return true;
        return has_round_caps && (is_at(from, x, y) || is_at(to, x, y));
    }

    int level(int column, int row) const
    {
        constexpr int samples = 16;
        int inside = 0;
        for (int y = 0; y < samples; ++y)
            for (int x = 0; x < samples; ++x)
                inside += covers(column + (x + 0.5) / samples, row + (y + 0.5) / samples) ? 1 : 0;
        return inside * 255 / (samples * samples);
    }

private:
    bool is_within(double angle) const
    {
        const double low = std::min(from, to);
        const double turns = std::floor((angle - low) / 360);
        return angle - turns * 360 <= std::max(from, to);
    }
    bool is_at(double angle, double x, double y) const
    {
        const double turn = angle * std::numbers::pi / 180;
        return std::hypot(x - 60 - radius * std::cos(turn), y - 60 - radius * std::sin(turn)) <= width / 2;
    }
};

int largest_difference(const std::vector<std::byte>& drawn, const Exact& exact)
{
    int largest = 0;
    for (int row = 0; row < 120; ++row)
        for (int column = 0; column < 120; ++column) {
            const auto red = std::to_integer<int>(drawn[static_cast<std::size_t>(3 * (120 * row + column))]);
            largest = std::max(largest, std::abs(red - exact.level(column, row)));
        }
    return largest;
}

/// The most that any frame differs from what it should be, while `to` goes from one angle to another.
int worst(const std::string& object, const std::string& shape, Exact exact, double last_to)
{
    const double first_to = exact.to;
    const auto drawn = [&](double to) {
        return "{ " + shape + " from=" + std::to_string(exact.from) + " to=" + std::to_string(to) + " }";
    };
    const std::string grows = object + " { key 0 " + drawn(first_to) + "\nkey " + std::to_string(last_frame) +
                              " " + drawn(last_to) + " }";
    int largest = 0;
    for (int frame = 0; frame <= last_frame; frame += 4) {
        exact.to = first_to + (last_to - first_to) * frame / last_frame;
        largest = std::max(largest, largest_difference(picture(grows, frame), exact));
    }
    return largest;
}

}

TEST_CASE("a ring gauge that fills is at each frame the arc that it should be")
{
    CHECK(worst("object o stroke=white width=12 cap=round", "arc 60 60 r=44",
                {.radius = 44, .from = 135, .to = 137, .width = 12, .has_round_caps = true},
                405) <= max_difference);
    CHECK(worst("object o stroke=white width=18", "arc 60 60 r=50",
                {.radius = 50, .from = 20, .to = 30, .width = 18}, 300) <= max_difference);
    CHECK(worst("object o stroke=white width=3", "arc 60 60 r=55",
                {.radius = 55, .from = -90, .to = -300, .width = 3}, -100) <= max_difference);
}

TEST_CASE("a pie that grows is at each frame the pie that it should be")
{
    CHECK(worst("object o fill=white", "pie 60 60 r=44", {.radius = 44, .from = -90, .to = -80}, 269) <=
          max_difference);
}

}
