#include "core/player.hpp"
#include "tests/core/beam/beam_player_fixture.hpp"
#include "tests/core/everything.hpp"
#include "tests/core/moving_scenes.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

namespace kfast::test {
namespace {

constexpr std::array<BeamProfile, 3> profiles{scope_profile, crt_profile, galvo_profile};

std::vector<BeamPoint> points_of(const BeamPlayer& player)
{
    std::vector<BeamPoint> all;
    std::array<BeamPoint, 100> piece;
    PointStream plot = player.plot();
    while (const std::size_t count = plot.next(piece))
        all.insert(all.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(count));
    return all;
}

/// A player whose block has a border that nothing may be written to.
struct GuardedBeam {
    static constexpr std::size_t border = 64;
    static constexpr std::byte untouched{0xA5};

    Bytes bytes;
    SceneView scene;
    std::uint32_t budget;
    Bytes block;
    BeamPlayer player;

    GuardedBeam(Bytes file, const BeamProfile& profile, std::uint32_t max_points)
        : bytes{std::move(file)},
          scene{accepted(bytes)},
          budget{std::min<std::uint32_t>(max_points, profile.rate / profile.min_refresh)},
          block(BeamPlayer::block_bytes(scene, profile) + 2 * border, untouched),
          player{*BeamPlayer::create(scene, profile, max_points,
                                     std::span{block}.subspan(border, block.size() - 2 * border))}
    {
    }

    /// What holds for every picture.
    void check() const
    {
        const std::vector<BeamPoint> points = points_of(player);
        const BeamReport& report = player.report();
        REQUIRE(!points.empty());
        REQUIRE(points.size() <= budget);
        REQUIRE(points.size() == report.points);
        const auto lit = std::ranges::count_if(points, &BeamPoint::is_lit);
        REQUIRE(static_cast<std::uint32_t>(lit) == report.lit_points);
        const auto is_untouched = [](std::byte byte) { return byte == untouched; };
        REQUIRE(std::all_of(block.begin(), block.begin() + border, is_untouched));
        REQUIRE(std::all_of(block.end() - border, block.end(), is_untouched));
    }
};

/// All that is told from outside, at random.
void set_random_inputs(BeamPlayer& player, std::mt19937& random)
{
    const SceneView& scene = player.scene();
    for (std::uint32_t number = 0; number < scene.input_count(); ++number)
        player.set_input(number, {static_cast<std::int32_t>(random() % 40'000'000) - 1'000'000});
}

/// Whether a pixel of a picture in rgb666, at most one away from the place of a point, differs from the first
/// one, where there is nothing.
bool shows_near(const Bytes& pixels, Size panel, FieldPoint at)
{
    const int column = (at.x - field_min) * panel.width / field_side;
    const int row = (field_max - at.y) * panel.height / field_side;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, panel.height - 1); ++y)
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, panel.width - 1); ++x) {
            const auto pixel =
                std::span{pixels}.subspan(static_cast<std::size_t>(3 * (y * panel.width + x)), 3);
            if (!std::ranges::equal(pixel, std::span{pixels}.first(3)))
                return true;
        }
    return false;
}

std::string text_of(const std::filesystem::path& path)
{
    std::ifstream file{path};
    return {std::istreambuf_iterator<char>{file}, {}};
}

std::string zigzag(int corners, int from, int to)
{
    std::string text = "line";
    for (int i = 0; i < corners; ++i)
        text += " " + std::to_string(i % 2 == 0 ? from : to) + " " + std::to_string(i % 250);
    return text;
}

}

TEST_CASE("the corners of a line are among its points, with y upwards")
{
    BeamPlayerFixture fixture{R"(kfast 1
        canvas 256 256
        object line stroke=white { line 0 0 256 0 256 256 })"};
    const auto points = fixture.points({});
    const auto is_drawn = [&](FieldPoint at) {
        return std::ranges::any_of(points, [at](const BeamPoint& point) { return point.at == at; });
    };
    CHECK(is_drawn({-32768, 32767}));
    CHECK(is_drawn({32767, 32767}));
    CHECK(is_drawn({32767, -32768}));
    CHECK(points.size() == fixture.player.report().points);
}

TEST_CASE("a beam draws what a trim leaves of a line, and goes on across the seam of a closed one")
{
    const auto lit = [](const std::string& object) {
        BeamPlayerFixture fixture{"kfast 1\ncanvas 256 256\nobject o " + object};
        std::vector<FieldPoint> places;
        for (const BeamPoint& point : fixture.points({}))
            if (point.is_lit())
                places.push_back(point.at);
        return places;
    };
    const auto is_left = [](FieldPoint at) { return at.x <= 1; };
    const auto half = lit("stroke=red trim-to=0.5 { line 0 128 256 128 }");
    CHECK_FALSE(half.empty());
    CHECK(std::ranges::all_of(half, is_left));
    const auto corner = lit("stroke=red trim-to=0.25 trim-offset=0.875 { rect 64 64 128 128 }");
    CHECK(std::ranges::find(corner, FieldPoint{-16384, 16384}) != corner.end());
    CHECK(std::ranges::none_of(corner, [](FieldPoint at) { return at.x > 1 || at.y < -1; }));
    CHECK(lit("stroke=red trim-to=0 { line 0 128 256 128 }").empty());
}

TEST_CASE("scenes keep to budget and block at any time")
{
    std::mt19937 random{11};
    std::vector<Bytes> files{compiled(everything)};
    for (const RawScene& scene : moving_scenes())
        files.push_back(scene.file());
    for (const Bytes& file : files)
        for (const BeamProfile& profile : profiles)
            for (const std::uint32_t budget : {16U, 300U, 100'000U}) {
                GuardedBeam beam{file, profile, budget};
                for (int round = 0; round < rounds(60); ++round) {
                    beam.player.show({static_cast<std::int32_t>(random() % 100'000'000) - 50'000'000});
                    beam.check();
                }
            }
}

TEST_CASE("a picture does not depend on those before")
{
    std::mt19937 random{12};
    for (const std::uint32_t budget : {50U, 200U, 100'000U}) {
        BeamPlayerFixture travelled{everything, crt_profile, budget};
        for (int round = 0; round < rounds(60); ++round) {
            const Time time{static_cast<std::int32_t>(random() % (30 * 1024))};
            BeamPlayerFixture fresh{travelled.bytes, crt_profile, budget};
            REQUIRE(travelled.points(time) == fresh.points(time));
        }
    }
}

TEST_CASE("there is room for whatever a scene draws, at every resolution")
{
    for (const std::string& shapes : {zigzag(2000, -100, 400), zigzag(2000, -100, 300) + " -100 0",
                                      std::string{"circle 128 128 r=120; circle 100 100 r=1900"}})
        for (const std::string style : {"stroke=white", "fill=white", "stroke=white width=30 join=round"})
            for (const std::uint16_t resolution :
                 {std::uint16_t{64}, std::uint16_t{256}, std::uint16_t{4096}}) {
                BeamProfile profile = scope_profile;
                profile.resolution = resolution;
                profile.min_refresh = 1;
                GuardedBeam beam{
                    compiled("kfast 1\ncanvas 256 256\nobject o " + style + " { " + shapes + " }"), profile,
                    1'000'000};
                CAPTURE(style);
                CAPTURE(resolution);
                beam.check();
                CHECK(beam.player.report().is_complete);
                CHECK(beam.player.report().lines > 0);
            }
}

TEST_CASE("what lies outside the field parks the beam")
{
    BeamPlayerFixture fixture{
        "kfast 1\ncanvas 100 100\nobject o stroke=white { circle 1000 0 r=300; line 200 -50 0 -9 }"};
    CHECK(fixture.points({}) == std::vector<BeamPoint>{{scope_profile.park}});
    CHECK(fixture.player.report().is_complete);
}

TEST_CASE("huge scales keep to the field")
{
    for (const std::string scale : {"7", "64", "-64"}) {
        GuardedBeam beam{
            compiled("kfast 1\ncanvas 100 100\nobject o stroke=white scale=" + scale +
                     " x=50 y=50 { rect -2000 -2000 4000 4000; circle 0 0 r=1500; line 0 0 9 9 }"),
            galvo_profile, 1500};
        beam.check();
        CHECK(beam.player.report().is_complete);
    }
}

TEST_CASE("live drawings of as many points as there may be keep to budget and block")
{
    std::mt19937 random{13};
    const std::string scene = R"(kfast 1
        canvas 256 256
        input plot kind=drawing points=4096 strokes=2000
        object o )";
    for (const std::string style :
         {"stroke=white", "stroke=white width=4 cap=round join=bevel", "fill=white"})
        for (const BeamProfile& profile : profiles) {
            GuardedBeam beam{compiled(scene + style + " live=plot"), profile, 100'000};
            for (const int max_points : {1, 2, 4000}) {
                std::vector<std::vector<InputPoint>> strokes(max_points < 4000 ? 2000 : 1);
                for (auto& stroke : strokes)
                    for (int i = 0; i < (max_points < 4000 ? max_points : 4096); ++i)
                        stroke.push_back(
                            {static_cast<std::int16_t>(random()), static_cast<std::int16_t>(random())});
                const std::vector<InputStroke> drawing(strokes.begin(), strokes.end());
                REQUIRE(beam.player.set_drawing(0, drawing));
                beam.player.show({});
                beam.check();
            }
        }
}

TEST_CASE("there is room for all of a live drawing")
{
    std::mt19937 random{15};
    BeamProfile patient = scope_profile;
    patient.rate = 1'000'000;
    patient.min_refresh = 1;
    for (const std::string style : {"stroke=white", "fill=white"}) {
        GuardedBeam beam{compiled("kfast 1\ncanvas 256 256\ninput plot kind=drawing points=4096 strokes=99\n"
                                  "object o live=plot " +
                                  style),
                         patient, 1'000'000};
        for (int round = 0; round < rounds(20); ++round) {
            std::vector<InputPoint> stroke;
            stroke.reserve(4096);
            for (int i = 0; i < 4096; ++i)
                stroke.push_back(
                    {static_cast<std::int16_t>(random() >> 16), static_cast<std::int16_t>(random() >> 16)});
            REQUIRE(beam.player.set_drawing(0, std::array{InputStroke{stroke}}));
            beam.player.show({});
            beam.check();
            CHECK(beam.player.report().is_complete);
        }
    }
}

TEST_CASE("inputs may stand anywhere")
{
    std::mt19937 random{14};
    GuardedBeam beam{compiled(R"(kfast 1
        canvas 128 128
        input a; input b
        group rotate-y=40 { track scale input=a { at 0 0; at 1 64 }
            object o stroke=white { track x input=b { at 0 -2000; at 1 2000 }
                rect 0 0 50 50; circle 20 20 r=9 } })"),
                     crt_profile, 2000};
    for (int round = 0; round < rounds(300); ++round) {
        set_random_inputs(beam.player, random);
        beam.player.show({});
        beam.check();
    }
}

TEST_CASE("thousands of dots are drawn as far as there is time")
{
    std::string dots;
    for (int i = 0; i < 3000; ++i)
        dots += "line " + std::to_string(i % 100) + " " + std::to_string(i / 100) + " " +
                std::to_string(i % 100) + " " + std::to_string(i / 100) + "; ";
    GuardedBeam few{compiled("kfast 1\ncanvas 100 100\nobject o stroke=white cap=round { " + dots + " }"),
                    scope_profile, 100'000};
    few.check();
    CHECK(!few.player.report().is_complete);
    CHECK(few.player.report().lines >= 1200);
    BeamProfile slow = scope_profile;
    slow.min_refresh = 10;
    GuardedBeam all{few.bytes, slow, 100'000};
    all.check();
    CHECK(all.player.report().is_complete);
    CHECK(all.player.report().lines == 3000);
}

TEST_CASE(
    "a drawing of 10,000 points is drawn whole within the budget of a board, from the canvas to far outside")
{
    std::mt19937 random{21};
    std::string zigzag = "line";
    for (int i = 0; i < 10'000; ++i)
        zigzag += " " + std::to_string(random() % 200) + " " + std::to_string(random() % 200);
    GuardedBeam beam{compiled("kfast 1\ncanvas 200 200\nobject o stroke=white { " + zigzag +
                              "; key 0 x=0 scale=1; key 30 x=0 scale=64; key 60 x=2000 scale=1 }"),
                     scope_profile, 4096};
    for (int frame = 0; frame < 60; frame += 5) {
        beam.player.show(Time::frame(frame));
        beam.check();
        CHECK((beam.player.report().is_complete || frame > 0));
    }
    beam.player.show_moment(Time::frame(60));
    CHECK(beam.player.report().lines == 0);
}

TEST_CASE("lit points lie where the stroke of the picture on a panel is")
{
    const std::string shapes = R"(
        key 0 { circle 60 60 r=40; path "M 20 20 C 300 0 -100 200 240 200"; line 200 20 240 60 200 100 }
        key 30 { circle 90 60 r=20; path "M 20 90 C 100 0 -100 200 240 30"; line 100 20 140 60 100 240 } })";
    const std::string text =
        "kfast 1\ncanvas 256 256 frames=30\nobject o stroke=white width=2 rotate-y=20 {" + shapes;
    constexpr Size panel{256, 256};
    PlayerFixture raster{text, panel};
    BeamPlayerFixture beam{text};
    for (int frame = 0; frame <= 30; frame += 3) {
        const Bytes pixels = raster.picture<PixelFormat::rgb666>(Time::frame(frame));
        for (const BeamPoint& point : beam.points(Time::frame(frame))) {
            if (!point.is_lit())
                continue;
            const int x = (point.at.x + 32768) / 256;
            const int y = (32767 - point.at.y) / 256;
            const auto pixel = static_cast<std::size_t>(3 * (y * panel.width + x));
            REQUIRE(pixels[pixel] != std::byte{});
        }
    }
}

TEST_CASE("lines of the examples lie on what a panel shows")
{
    constexpr Size panel{256, 256};
    for (const auto& file : std::filesystem::directory_iterator{KFAST_EXAMPLES}) {
        // On a panel the card turned over is as dark as what lies behind it.
        if (file.path().extension() != ".kfast" || file.path().stem() == "card")
            continue;
        CAPTURE(file.path().string());
        const Bytes scene = compiled(text_of(file.path()));
        PlayerFixture raster{scene, panel};
        BeamPlayerFixture beam{scene, scope_profile, 100'000};
        for (int step = 0; step < 8; ++step) {
            const Time time{static_cast<std::int32_t>(std::int64_t{beam.scene.length().ticks} * step / 8)};
            const Bytes pixels = raster.picture<PixelFormat::rgb666>(time);
            for (const BeamPoint& point : beam.points(time))
                REQUIRE((!point.is_lit() || shows_near(pixels, panel, point.at)));
        }
        CHECK(beam.player.report().speed_level == 0);
    }
}

TEST_CASE("a morph between one closed fill and two draws no seams")
{
    BeamPlayerFixture fixture{R"(kfast 1
        canvas 256 256 frames=10
        object o fill=white { key 0 { circle 128 128 r=50 }; key 10 { circle 60 128 r=30; circle 200 128 r=30 } })"};
    fixture.player.show(Time{1});
    const std::uint64_t around = fixture.player.report().lit_length;
    CHECK(around == doctest::Approx(2 * 3.14159 * 50 * 256).epsilon(0.01));
    fixture.player.show_moment(Time::frame(10));
    CHECK(fixture.player.report().lit_length == doctest::Approx(4 * 3.14159 * 30 * 256).epsilon(0.01));
}

}
