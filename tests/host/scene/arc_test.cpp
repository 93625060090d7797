#include "tests/host/scene/cubic.hpp"
#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace kfast::test {
namespace {

constexpr double sixteenth = 1.0 / 16;

scene::Stroke stroke_of(const std::string& path)
{
    const auto scene = read_on_canvas("object o fill=red { path \"" + path + "\" }").scene;
    REQUIRE(scene);
    return key_at(*scene).drawing.strokes.at(0);
}

/// The largest distance from the ellipse with that centre, those radii and that rotation, along the radius.
double farthest_from_ellipse(const scene::Stroke& stroke, Exact centre, double rx, double ry, double degrees)
{
    const double angle = degrees * std::numbers::pi / 180;
    double worst = 0;
    scene::Point from = stroke.from;
    for (const scene::Segment& segment : stroke.segments) {
        for (int i = 0; i <= 32; ++i) {
            const Exact at = on_cubic(from, segment, i / 32.0);
            const double x = std::cos(angle) * (at.x - centre.x) + std::sin(angle) * (at.y - centre.y);
            const double y = std::cos(angle) * (at.y - centre.y) - std::sin(angle) * (at.x - centre.x);
            const double reach = std::hypot(x, y);
            worst = std::max(worst, std::abs(reach - reach / std::hypot(x / rx, y / ry)));
        }
        from = segment.to;
    }
    return worst;
}

/// The sum of the turns of the chords' directions as seen from the centre, in degrees, clockwise positive.
double extent_around(const scene::Stroke& stroke, Exact centre)
{
    double sum = 0;
    scene::Point from = stroke.from;
    for (const scene::Segment& segment : stroke.segments) {
        const Exact a = exact(from);
        const Exact b = exact(segment.to);
        const double begin = std::atan2(a.y - centre.y, a.x - centre.x);
        const double end = std::atan2(b.y - centre.y, b.x - centre.x);
        sum += std::remainder(end - begin, 2 * std::numbers::pi);
        from = segment.to;
    }
    return sum * 180 / std::numbers::pi;
}

}

TEST_CASE("the four arcs between two points of a circle")
{
    // Chord from (40, 20) to (20, 40), radius 20: centres (20, 20) and (40, 40).
    const auto arc = [](const std::string& flags) {
        return stroke_of("M 40 20 A 20 20 0 " + flags + " 20 40");
    };
    CHECK(farthest_from_ellipse(arc("0 1"), {20, 20}, 20, 20, 0) <= sixteenth);
    CHECK(extent_around(arc("0 1"), {20, 20}) == doctest::Approx(90));
    CHECK(farthest_from_ellipse(arc("1 0"), {20, 20}, 20, 20, 0) <= sixteenth);
    CHECK(extent_around(arc("1 0"), {20, 20}) == doctest::Approx(-270));
    CHECK(farthest_from_ellipse(arc("0 0"), {40, 40}, 20, 20, 0) <= sixteenth);
    CHECK(extent_around(arc("0 0"), {40, 40}) == doctest::Approx(-90));
    CHECK(farthest_from_ellipse(arc("1 1"), {40, 40}, 20, 20, 0) <= sixteenth);
    CHECK(extent_around(arc("1 1"), {40, 40}) == doctest::Approx(270));
}

TEST_CASE("arcs are cut into pieces of at most a quarter turn")
{
    CHECK(stroke_of("M 40 20 A 20 20 0 0 1 20 40").segments.size() == 1);
    CHECK(stroke_of("M 0 20 A 20 20 0 0 1 40 20").segments.size() == 2);
    CHECK(stroke_of("M 40 20 A 20 20 0 1 0 20 40").segments.size() == 3);
    CHECK(stroke_of("M 40 20 A 20 20 0 1 0 39 26").segments.size() == 4);
}

TEST_CASE("a half circle passes through its top and ends exactly")
{
    CHECK(path_drawn("M 0 16 A 16 16 0 0 1 32 16") ==
          "M 0 16 C 0 7.1875 7.1875 0 16 0 C 24.8125 0 32 7.1875 32 16");
    CHECK(path_drawn("M 0 16 a 16 16 0 0 0 32 0") ==
          "M 0 16 C 0 24.8125 7.1875 32 16 32 C 24.8125 32 32 24.8125 32 16");
}

TEST_CASE("an ellipse may be turned")
{
    // Half an ellipse of radii 40 and 20 turned by 30 degrees about (60, 60): its long axis ends at
    // (60 +- 40 cos 30, 60 +- 40 sin 30).
    const auto stroke = stroke_of("M 25.3590 40 A 40 20 30 0 1 94.6410 80");
    CHECK(farthest_from_ellipse(stroke, {60, 60}, 40, 20, 30) <= sixteenth);
    CHECK(extent_around(stroke, {60, 60}) == doctest::Approx(180).epsilon(0.01));
    // Its short axis ends at the upper right: 60 + 20 sin 30, 60 - 20 cos 30.
    CHECK(std::abs(exact(stroke.segments.at(0).to).x - 70) <= sixteenth);
    CHECK(std::abs(exact(stroke.segments.at(0).to).y - 42.6795) <= sixteenth);
}

TEST_CASE("radii that are too small grow, negative ones count as positive, none gives a line")
{
    const std::string half = path_drawn("M 0 16 A 16 16 0 0 1 32 16");
    CHECK(path_drawn("M 0 16 A 4 4 0 0 1 32 16") == half);
    CHECK(path_drawn("M 0 16 A 1e-8 1e-8 0 1 1 32 16") == half);
    CHECK(path_drawn("M 0 16 A -16 -16 0 0 1 32 16") == half);
    CHECK(path_drawn("M 0 16 A 0 16 0 0 1 32 16") == "M 0 16 L 32 16");
    CHECK(path_drawn("M 0 16 A 16 0 0 0 1 32 16") == "M 0 16 L 32 16");
    CHECK(path_drawn("M 0 16 A 1e-300 1e-300 0 0 1 32 16") == "M 0 16 L 32 16");
}

TEST_CASE("arcs of huge circles are all but straight")
{
    CHECK(path_drawn("M 0 0 A 1e300 1e300 0 0 1 30 0") == "M 0 0 C 10 0 20 0 30 0");
    CHECK(path_drawn("M 0 0 A 1e9 1e9 1e300 0 1 30 0") == "M 0 0 C 10 0 20 0 30 0");
    CHECK(path_drawn("M 0 0 A 1e300 1e300 0 1 1 30 0") ==
          "1:7 error: this curve reaches more than 2047 px from the origin");
}

}
