#include "host/beam/beam_screen_source.hpp"
#include "host/beam/profile_choice.hpp"
#include "host/picture/picture.hpp"
#include "tests/compiled.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <string>

namespace kfast::test {
namespace {

constexpr Size small{201, 201};
constexpr Colour white{255, 255, 255};
constexpr std::int64_t default_value = 10; // of a fast and therefore light picture: a single tour is dark

int green_at(const Picture& picture, int x, int y) { return picture.at(x, y).green; }

/// That of a scope whose points are where they are told to be, with a half-life of 800 points.
BeamScreen scope_screen(Size size = small)
{
    return {scope_profile, display_of("scope"), size, default_value};
}

/// In the middle of the screen.
DrawnPicture dot(std::int64_t lit, std::int64_t dark)
{
    DrawnPicture picture{{}, 0, lit + dark};
    picture.points.assign(static_cast<std::size_t>(lit), {{}, white});
    picture.points.resize(static_cast<std::size_t>(lit + dark), {{}});
    return picture;
}

int dot_light(std::int64_t lit, std::int64_t dark)
{
    BeamScreen screen = scope_screen();
    const DrawnPicture picture = dot(lit, dark);
    return green_at(widen(screen.show({&picture, 1})), 100, 100);
}

/// A line from left to right with a travel back, 201 pixels wide.
std::string line_scene(const std::string& lines)
{
    return "kfast 1\ncanvas 100 100 loop=repeat\nobject o stroke=\"#ffffff\" {\n key 0 {\n" + lines +
           "\n }\n}\n";
}

Picture shown(const std::string& scene_text, const BeamProfile& profile, std::string_view display,
              Size size = small)
{
    const std::vector<std::byte> bytes = compiled(scene_text);
    BeamScreenSource source{*SceneView::parse(bytes), profile, display_of(display), size};
    return widen(source.show(Time{0}));
}

/// Where the canvas, 100 units wide, lies on the screen of 201 pixels: the field has 0.92 of it.
int pixel_of(double place) { return static_cast<int>(std::lround(100 + (place - 50) / 100 * 0.92 * 201)); }

int lightest(const Picture& picture, int left, int right, int top, int bottom)
{
    int max = 0;
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x)
            max = std::max(max, green_at(picture, x, y));
    return max;
}

}

TEST_CASE("where the beam stays longer it is lighter, until it is as light as can be")
{
    CHECK(dot_light(0, 10) == 0);
    CHECK(dot_light(1, 0) > 0);
    CHECK(dot_light(2, 0) > dot_light(1, 0));
    CHECK(dot_light(4, 0) > dot_light(2, 0));
    CHECK(dot_light(4000, 0) == 255);
}

TEST_CASE("half of the light is gone after the half-life")
{
    const auto half_life =
        static_cast<std::int64_t>(display_of("scope").half_life / 1000 * scope_profile.rate);
    for (const std::int64_t lit : {2, 4, 8}) {
        CHECK(std::abs(dot_light(2 * lit, half_life) - dot_light(lit, 0)) <= 1);
        CHECK(std::abs(dot_light(4 * lit, 2 * half_life) - dot_light(lit, 0)) <= 2);
        CHECK(dot_light(lit, half_life) < dot_light(lit, 0) - 10);
    }
    CHECK(dot_light(8, scope_screen().memory()) <= 4);
}

TEST_CASE("the spot is as wide as it is told")
{
    for (const double percent : {1.0, 3.0}) {
        BeamDisplay display = display_of("scope");
        display.spot = percent;
        BeamScreen screen{scope_profile, display, {1001, 1001}, default_value};
        const DrawnPicture picture = dot(1, 0);
        const Picture seen = widen(screen.show({&picture, 1}));
        const int radius = static_cast<int>(std::lround(percent / 100 * 0.92 * 1001 / 2));
        // half the light, where little of it is the same as its share; the picture has a gamma of 2.2
        const double share =
            std::pow(static_cast<double>(green_at(seen, 500 + radius, 500)) / green_at(seen, 500, 500), 2.2);
        CAPTURE(percent);
        CHECK(share == doctest::Approx(0.5).epsilon(0.15));
    }
}

TEST_CASE("a slow tour is lighter where the beam was last")
{
    DrawnPicture tour{{}, 0, 8000};
    for (int i = 0; i < 4000; ++i)
        tour.points.push_back({{static_cast<std::int16_t>(i * 16 - 32000), 0}, white});
    BeamScreen screen = scope_screen();
    const Picture seen = widen(screen.show({&tour, 1}));
    CHECK(green_at(seen, 180, 100) > 1.5 * green_at(seen, 20, 100));
    CHECK(green_at(seen, 100, 100) > green_at(seen, 60, 100));
}

TEST_CASE("a light that is told too early or too late leaves tails, and one that is told rightly none")
{
    const std::string scene = line_scene("line 30 30 70 30\n line 70 70 30 70");
    BeamProfile profile = galvo_profile;
    profile.arrival_dwell = 20;
    profile.leave_dwell = 10;
    const auto tail = [&](std::uint8_t delay) {
        profile.light_delay = delay;
        const Picture picture = shown(scene, profile, "galvo");
        return std::max(lightest(picture, 0, 200, pixel_of(36), pixel_of(64)),
                        std::max(lightest(picture, 0, pixel_of(24), 0, 200),
                                 lightest(picture, pixel_of(76), 200, 0, 200)));
    };
    const auto shortest = [&](std::uint8_t delay) { // the line's end is dark where light goes too early
        profile.light_delay = delay;
        profile.lit_dwell = 0;
        const Picture picture = shown(scene, profile, "galvo");
        return std::min(
            {green_at(picture, pixel_of(31), pixel_of(30)), green_at(picture, pixel_of(69), pixel_of(30)),
             green_at(picture, pixel_of(31), pixel_of(70)), green_at(picture, pixel_of(69), pixel_of(70))});
    };
    CHECK(tail(galvo_profile.light_delay) < 40);
    CHECK(tail(24) > 120);
    CHECK(shortest(galvo_profile.light_delay) > 120);
    CHECK(shortest(0) < 80);
}

TEST_CASE("a slow beam rounds corners, unless it waits there")
{
    const std::string scene = line_scene("path \"M 30 30 L 70 30 L 70 70 L 30 70 Z\"");
    BeamProfile profile = galvo_profile;
    const auto corner = [&](std::uint8_t dwell) {
        profile.corner_dwell = dwell;
        const Picture picture = shown(scene, profile, "galvo", {401, 401});
        const auto place = [](double at) { return static_cast<int>(std::lround(200 + (at - 50) * 3.689)); };
        return green_at(picture, place(69.5), place(69.5));
    };
    CHECK(corner(0) < corner(8));
    CHECK(corner(0) < 160);
    CHECK(corner(30) > 200);
}

TEST_CASE("a picture is upright, in the middle of the screen")
{
    const Picture picture = shown(line_scene("line 20 10 60 10"), scope_profile, "scope");
    CHECK(green_at(picture, pixel_of(40), pixel_of(10)) > 150);
    CHECK(lightest(picture, 0, 200, pixel_of(20), 200) < 40);
    CHECK(lightest(picture, pixel_of(70), 200, 0, 200) < 40);
}

TEST_CASE("the beam of a monitor leaves nothing where it jumps, and what would be seen is shown on demand")
{
    const std::vector<std::byte> bytes = compiled(line_scene("line 30 30 70 30\n line 30 70 70 70"));
    BeamScreenSource source{*SceneView::parse(bytes), crt_profile, display_of("crt"), small};
    const Picture hidden = widen(source.show(Time{0}));
    CHECK(lightest(hidden, 0, 200, pixel_of(45), pixel_of(55)) < 40);
    source.reveal(true);
    const Picture revealed = widen(source.show(Time{0}));
    CHECK(revealed.pixels != hidden.pixels);
    CHECK(source.facts().find(" points  ") != std::string::npos);
    CHECK(source.facts().find("lit 0.8") != std::string::npos);
    source.reveal(false);
    CHECK(widen(source.show(Time{0})).pixels == hidden.pixels);
}

TEST_CASE("a picture of the screen depends on nothing that was shown before")
{
    const std::vector<std::byte> bytes = compiled(R"(kfast 1
canvas 100 100 loop=ping-pong
object o stroke="#ff8000" { key 0 { circle 50 50 r=20 } ; key 40 { circle 40 50 r=45 } }
)");
    for (const ProfileChoice& choice : profile_choices()) {
        const SceneView scene = *SceneView::parse(bytes);
        BeamScreenSource played{scene, choice.profile, display_of(choice.name), small};
        for (int frame = 0; frame < 5; ++frame)
            played.show(Time::frame(frame));
        BeamScreenSource fresh{scene, choice.profile, display_of(choice.name), small};
        CHECK(played.show(Time::frame(20)).pixels == fresh.show(Time::frame(20)).pixels);
    }
}

TEST_CASE("a screen can have any size, and shows nothing of an empty scene")
{
    for (const Size size : {Size{1, 1}, Size{2, 300}, Size{300, 2}, Size{128, 64}}) {
        const Picture lit = shown(line_scene("circle 50 50 r=30"), galvo_profile, "galvo", size);
        CHECK(lit.size == size);
        CHECK(std::ranges::any_of(lit.pixels, [](Colour c) { return c.green > 20; }));
        const Picture dark = shown("kfast 1\ncanvas 10 10\n", galvo_profile, "galvo", size);
        CHECK(std::ranges::all_of(dark.pixels, [](Colour c) { return c == Colour{0, 0, 0}; }));
    }
}

TEST_CASE("without levels every lit line is as light as can be")
{
    BeamProfile profile = scope_profile;
    const std::string dark =
        "kfast 1\ncanvas 100 100\nobject o stroke=\"#404040\" { key 0 { line 20 50 80 50 } }\n";
    const int by_level = green_at(shown(dark, profile, "scope"), 100, 100);
    profile.brightness = BeamBrightness::none;
    CHECK(green_at(shown(dark, profile, "scope"), 100, 100) > by_level + 60);
}

}
