#include "core/player.hpp"
#include "tests/compiled.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

constexpr int frames = 40;
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

int largest_difference(const std::vector<std::byte>& a, const std::vector<std::byte>& b)
{
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(std::to_integer<int>(a[i]) - std::to_integer<int>(b[i])));
    return largest;
}

/// A shape of an object from one angle to two others, and what it is in between.
struct Growing {
    std::string object; ///< "object o stroke=white width=12"
    std::string shape;  ///< "arc 60 60 r=44"
    double from = 0;
    double first_to = 0;
    double last_to = 0;

    std::string drawn(double to) const
    {
        return "{ " + shape + " from=" + std::to_string(from) + " to=" + std::to_string(to) + " }";
    }

    int worst() const
    {
        const std::string grows =
            object + " { key 0 " + drawn(first_to) + "\nkey " + std::to_string(frames) + " " + drawn(last_to) + " }";
        int largest = 0;
        for (int frame = 0; frame <= frames; ++frame) {
            const double to = first_to + (last_to - first_to) * frame / frames;
            largest = std::max(largest,
                               largest_difference(picture(grows, frame), picture(object + drawn(to), frame)));
        }
        return largest;
    }
};

}

TEST_CASE("a ring gauge that fills is at each frame the arc that it should be")
{
    for (const std::string pen : {"cap=butt", "cap=round", "cap=square"}) {
        CAPTURE(pen);
        CHECK(Growing{"object o stroke=white width=12 " + pen, "arc 60 60 r=44", 135, 137, 405}.worst() <=
              max_difference);
        CHECK(Growing{"object o stroke=white width=3 " + pen, "arc 60 60 r=55", -90, -300, -100}.worst() <=
              max_difference);
    }
}

TEST_CASE("a pie that grows is at each frame the pie that it should be")
{
    CHECK(Growing{"object o fill=white", "pie 60 60 r=44", -90, -80, 269}.worst() <= max_difference);
    CHECK(Growing{"object o stroke=white width=4 join=round", "pie 60 60 r=44", 0, 300, 20}.worst() <=
          max_difference);
}

}
