#include "core/player.hpp"

#include "host/player/received_drawing.hpp"
#include "tests/core/panel_memory.hpp"
#include "tests/core/player_fixture.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <string>

/// Players of scenes that show drawings from outside.
namespace kfast::test {
namespace {

constexpr Size canvas{60, 40};

const std::string two_plots = R"(
kfast 1
canvas 60 40 frames=30
input plot kind=drawing points=40 strokes=4 { line 5 20 20 5 35 30 55 20 }
input shape kind=drawing points=8 { polygon 10 10 30 12 20 30 }
input dim
object back fill="#203040" { rect 3 3 40 20; key 0 x=0; key 29 x=10 }
object still fill=silver { circle 50 8 r=5 }
object area fill="#00ff0080" stroke=red width=1.5 join=round live=shape rule=even-odd
symbol s { object line stroke=lime width=2 cap=round join=round live=plot }
group one x=2 { track opacity input=dim { at 0 1; at 1 0.3 }
    use s; object dots stroke=white width=3 cap=square live=plot y=6 rotate=10 }
use s rotate-y=40 x=5 scale=0.7
)";

ReceivedDrawing random_drawing(std::size_t max_strokes, std::size_t max_points, int reach,
                               std::mt19937& random)
{
    ReceivedDrawing drawing(1 + random() % max_strokes);
    const auto coordinate = [&] {
        const auto range = static_cast<std::uint32_t>(2 * reach + 1);
        return static_cast<std::int16_t>(static_cast<int>(random() % range) - reach);
    };
    for (std::size_t points = random() % (max_points + 1); points > 0; --points) {
        const std::int16_t x = coordinate();
        drawing[random() % drawing.size()].push_back({x, coordinate()});
    }
    if (random() % 3 == 0 && !drawing[0].empty())
        drawing[0].back() = drawing[0].front();
    return drawing;
}

bool set_drawing(PlayerFixture& fixture, std::uint32_t input, const ReceivedDrawing& drawing)
{
    return fixture.player.set_drawing(input, strokes_of(drawing));
}

std::string polyline(const ReceivedDrawing& drawing)
{
    std::string shapes;
    for (const auto& stroke : drawing) {
        shapes += "path \"";
        for (std::size_t i = 0; i < stroke.size(); ++i)
            shapes += (i == 0 ? "M " : "L ") + std::to_string(stroke[i].x / 16.0) + " " +
                      std::to_string(stroke[i].y / 16.0) + " ";
        shapes += "\"; ";
    }
    return shapes;
}

}

TEST_CASE("a live drawing looks as the same drawing does in an object")
{
    std::mt19937 random{1};
    for (const std::string style :
         {"fill=red", "stroke=red width=3", "stroke=red width=5 join=round cap=round",
          "fill=blue stroke=red rotate=30", "fill=red rule=even-odd rotate-x=50 z=20",
          "stroke=red width=3 cap=square join=bevel rotate-y=60"})
        for (int round = 0; round < 8; ++round) {
            ReceivedDrawing drawing = random_drawing(2, 20, 60 * 16, random);
            std::erase_if(drawing, [](const auto& stroke) { return stroke.size() < 2; });
            if (drawing.empty())
                continue;
            const std::string begin = "kfast 1\ncanvas 60 40\n";
            const std::string place = " pivot-x=30 pivot-y=20 ";
            PlayerFixture live{begin + "input i kind=drawing points=40 strokes=2\nobject o " + style + place +
                                   "live=i",
                               canvas};
            PlayerFixture still{begin + "object o " + style + place + "{ " + polyline(drawing) + "}", canvas};
            CHECK(set_drawing(live, 0, drawing));
            REQUIRE(live.picture({}) == still.picture({}));
        }
}

TEST_CASE("the usual drawing is shown until another is told")
{
    PlayerFixture live{
        "kfast 1\ncanvas 60 40\ninput i kind=drawing points=9 strokes=2 { line 5 5 40 30; polygon 9 9 "
        "30 9 9 30 }\n"
        "object o stroke=red width=3 live=i rotate=20",
        canvas};
    PlayerFixture still{
        "kfast 1\ncanvas 60 40\nobject o stroke=red width=3 rotate=20 { line 5 5 40 30; polygon 9 9 "
        "30 9 9 30 }",
        canvas};
    const Bytes default_value = still.picture({});
    CHECK(live.picture({}) == default_value);
    CHECK(set_drawing(live, 0, {}));
    CHECK(live.picture({}) != default_value);
    CHECK(set_drawing(live, 0, {{{80, 80}, {640, 480}}, {{144, 144}, {480, 144}, {144, 480}, {144, 144}}}));
    CHECK(live.picture({}) == default_value);
}

TEST_CASE("a drawing that finds no room changes nothing")
{
    PlayerFixture fixture{two_plots, canvas};
    const Bytes picture = fixture.picture({});
    CHECK_FALSE(set_drawing(fixture, 1, {{{0, 0}}, {{1, 1}}}));
    CHECK_FALSE(set_drawing(fixture, 1, {std::vector<InputPoint>(9)}));
    CHECK(fixture.picture({}) == picture);
    fixture.player.show_next_drawing(1);
    CHECK(fixture.player.drawing(1).strokes() == 0);
    CHECK(set_drawing(fixture, 1, {std::vector<InputPoint>(8)}));
}

TEST_CASE("the panel shows what a full redraw would, whatever is told and whenever")
{
    for (int seed = 0; seed < rounds(12); ++seed) {
        std::mt19937 random{static_cast<unsigned>(seed)};
        PlayerFixture fixture{two_plots, canvas};
        PanelMemory<PixelFormat::rgb565> memory{canvas};
        Time time;
        for (int round = 0; round < 50; ++round) {
            if (random() % 2 == 0)
                time = {static_cast<std::int32_t>(random() % (30 * 1024))};
            const int reach = random() % 4 == 0 ? 32767 : 1000;
            if (random() % 2 == 0)
                CHECK(set_drawing(fixture, 0, random_drawing(4, 40, reach, random)));
            if (random() % 3 == 0)
                CHECK(set_drawing(fixture, 1, random_drawing(1, 8, reach, random)));
            if (random() % 4 == 0)
                fixture.player.set_input(2, {static_cast<std::int32_t>(random() % 65537)});
            fixture.player.show(time);
            if (random() % 5 == 0)
                continue; // never drawn
            const ReceivedDrawing first = received_drawing(fixture.player.drawing(0));
            const ReceivedDrawing second = received_drawing(fixture.player.drawing(1));
            if (random() % 3 == 0)
                CHECK(set_drawing(fixture, 0,
                                  random_drawing(4, 40, reach, random))); // too late for this picture
            bring_up_to_date(fixture, memory, 5);
            PlayerFixture fresh{fixture.bytes, canvas};
            CHECK(set_drawing(fresh, 0, first));
            CHECK(set_drawing(fresh, 1, second));
            fresh.player.set_input(2, fixture.player.input(2));
            REQUIRE(memory.bytes() == fresh.picture(time));
        }
    }
}

TEST_CASE("a drawing that nobody changes sends nothing, and one that is told point by point neither until it "
          "is shown")
{
    PlayerFixture fixture{two_plots, canvas};
    PanelMemory<PixelFormat::rgb565> memory{canvas};
    const auto areas = [&] {
        fixture.player.show({});
        return bring_up_to_date(fixture, memory, 40).areas;
    };
    areas();
    const ReceivedDrawing drawing{{{100, 100}, {300, 200}}};
    CHECK(set_drawing(fixture, 0, drawing));
    CHECK(areas() > 0);
    CHECK(set_drawing(fixture, 0, drawing));
    CHECK(areas() == 0);
    InputDrawing next = fixture.player.drawing(0);
    next.add({400, 400});
    next.add({300, 400});
    CHECK(areas() == 0);
    fixture.player.show_next_drawing(0);
    CHECK(areas() > 0);
}

TEST_CASE("what is told changes the outlines of its own layers alone")
{
    PlayerFixture fixture{two_plots, canvas};
    fixture.picture({});
    const auto steps = fixture.player.picture().steps();
    const std::vector<raster::PaintStep> before(steps.begin(), steps.end());
    CHECK(set_drawing(fixture, 0, {{{100, 100}, {300, 200}}}));
    fixture.picture({});
    const auto after = fixture.player.picture().steps();
    REQUIRE(after.size() == before.size());
    std::size_t changed = 0;
    for (std::size_t i = 0; i < after.size(); ++i)
        changed += after[i].outlines == before[i].outlines ? 0U : 1U;
    CHECK(changed > 0);
    CHECK(changed < after.size());
}

TEST_CASE("a player of live drawings writes to its block alone, whatever they are told")
{
    constexpr std::size_t guard = 64;
    constexpr std::byte mark{0xA5};
    const Bytes file = compiled(two_plots);
    const SceneView scene = *SceneView::parse(file);
    const std::size_t size = Player::block_bytes(scene, canvas);
    Bytes memory(size + 2 * guard, mark);
    auto player = Player::create(scene, canvas, Fit::cover, std::span{memory}.subspan(guard, size));
    REQUIRE(player);
    Bytes pixels(row_bytes(PixelFormat::rgb565, canvas.width) * static_cast<std::size_t>(canvas.height));
    std::mt19937 random{5};
    for (int frame = 0; frame < 60; ++frame) {
        player->set_drawing(0, strokes_of(random_drawing(6, 60, 32767, random)));
        player->set_drawing(1, strokes_of(random_drawing(2, 12, 900, random)));
        player->show(Time::frame(frame));
        player->draw_rows<PixelFormat::rgb565>(canvas.height, pixels);
    }
    const auto is_untouched = [](std::span<const std::byte> part) {
        return std::ranges::all_of(part, [](std::byte byte) { return byte == mark; });
    };
    CHECK(is_untouched(std::span{memory}.first(guard)));
    CHECK(is_untouched(std::span{memory}.last(guard)));
}

TEST_CASE("a block has room for both drawings of each input")
{
    const auto block_bytes = [](const std::string& input) {
        const Bytes file =
            compiled("kfast 1\ncanvas 60 40\n" + input + "\nobject o fill=red visible=#false live=i\n" +
                     "object p fill=red { rect 1 1 2 2 }");
        return Player::block_bytes(*SceneView::parse(file), canvas);
    };
    CHECK(block_bytes("input i kind=drawing points=100") - block_bytes("input i kind=drawing points=1") ==
          2 * 99 * 4);
    CHECK(block_bytes("input i kind=drawing points=100 strokes=9") -
              block_bytes("input i kind=drawing points=100") ==
          2 * 4 * 4);
}

}
