#include "core/pose/posed_bones.hpp"
#include "host/compiler/compile.hpp"
#include "tests/core/moved_scene.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <random>
#include <string>
#include <vector>

/// Where the tips of arms are in the player.
namespace kfast::test {
namespace {

struct Vec2 {
    double x;
    double y;
};

std::string target_text(int frame, Vec2 spot)
{
    std::string text{"at "};
    return text.append(std::to_string(frame))
        .append(1, ' ')
        .append(std::to_string(spot.x))
        .append(1, ' ')
        .append(std::to_string(spot.y))
        .append("; ");
}

/// `end` begins where the arm ends.
std::vector<std::byte> compiled(const std::string& bend, const std::string& targets)
{
    const std::string text =
        "kfast 1\ncanvas 240 240\nbones s {\n"
        "bone body 40 200 40 140 { bone upper 40 140 90 110 { bone lower 90 110 150 120 {\n"
        "bone end 150 120 160 120 } } }\n"
        "pose 0 law=accelerate-decelerate { body turn=-5; upper length=60 }\n"
        "pose 30 { body turn=5 x=4; upper length=66; lower }\n"
        "reach lower bend=" +
        bend + " { " + targets + "}\n}\nobject o fill=red skin=s { rect 40 140 9 9 }";
    Diagnostics diagnostics;
    const auto bytes = compile({"test.kfast", text}, diagnostics);
    REQUIRE(bytes);
    CHECK(diagnostics.sorted().empty());
    return *bytes;
}

double pixels(Fixed value) { return static_cast<double>(value.raw()) / Fixed::one; }

}

TEST_CASE("the player takes the tip within 1/16 px of its target")
{
    std::mt19937 random{6};
    const auto within = [&random](double low, double high) {
        return std::uniform_real_distribution<double>{low, high}(random);
    };
    for (int round = 0; round < 60; ++round) {
        const Vec2 from{within(70, 130), within(90, 190)};
        const Vec2 to{within(70, 130), within(90, 190)};
        const std::vector<std::byte> bytes =
            compiled(round % 2 == 0 ? "left" : "right", target_text(0, from) + target_text(30, to));
        const auto scene = SceneView::parse(bytes);
        REQUIRE(scene);
        MovedScene moved{*scene};
        double worst = 0;
        for (int sample = 0; sample < 300; ++sample) {
            const Time time{static_cast<std::int32_t>(random() % (30 * 1024))};
            const double share = time.ticks / (30.0 * 1024);
            const Point tip = moved.bones_at(time).back().frame().origin;
            worst = std::max(worst, std::hypot(pixels(tip.x) - std::lerp(from.x, to.x, share),
                                               pixels(tip.y) - std::lerp(from.y, to.y, share)));
        }
        CHECK(worst <= 1.0 / 16);
    }
}

}
