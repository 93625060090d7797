#include "core/player.hpp"

#include "host/compiler/write/header.hpp"
#include "tests/core/everything.hpp"
#include "tests/core/moving_scenes.hpp"
#include "tests/core/panel_memory.hpp"
#include "tests/core/player_fixture.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <string>

namespace kfast::test {
namespace {

/// Shows the frames one after the other, with room for `rows` rows at once.
void check_frames(const Bytes& file, Size panel, int frames, int rows)
{
    PlayerFixture fixture{file, panel};
    PanelMemory<PixelFormat::rgb565> memory{panel};
    for (int frame = 0; frame < frames; ++frame) {
        fixture.player.show(Time::frame(frame));
        bring_up_to_date(fixture, memory, rows);
        CHECK(memory.bytes() == PlayerFixture{file, panel}.picture(Time::frame(frame)));
    }
}

/// Random moments, in order and by leaps, unfinished pictures and redraws between them.
template <PixelFormat format>
void check_against_redraws(const Bytes& file, Size panel, Size granularity, unsigned seed)
{
    std::mt19937 random{seed};
    PlayerFixture fixture{file, panel};
    PlayerFixture fresh{file, panel};
    PanelMemory<format> memory{panel};
    std::int32_t moment = 0;
    for (int round = 0; round < rounds(60); ++round) {
        moment = random() % 3 == 0 ? static_cast<std::int32_t>(random() % 60'000)
                                   : moment + static_cast<std::int32_t>(random() % 700);
        fixture.player.show({moment});
        if (random() % 8 == 0)
            fixture.player.redraw();
        if (random() % 8 == 0) { // interrupted: what was drawn does reach the panel
            Bytes pixels(row_bytes(format, panel.width) * 8);
            for (const Change& change : fixture.player.draw_changes<format>(pixels, granularity, 11))
                memory.take(change);
            continue;
        }
        bring_up_to_date(fixture, memory, granularity.height * (1 + static_cast<int>(random() % 3)),
                         granularity, static_cast<int>(random() % 20));
        REQUIRE(memory.bytes() == without_filling(format, panel, fresh.picture<format>({moment})));
    }
}

TEST_CASE("the panel always shows what a full redraw would")
{
    const Bytes file = compiled(everything);
    for (unsigned seed = 0; seed < 3; ++seed) {
        check_against_redraws<PixelFormat::rgb565>(file, {60, 40}, {1, 1}, seed);
        check_against_redraws<PixelFormat::rgb565>(file, {240, 120}, {4, 2}, seed);
        check_against_redraws<PixelFormat::rgb444>(file, {60, 40}, {2, 1}, seed);
        check_against_redraws<PixelFormat::grey4>(file, {64, 40}, {2, 1}, seed);
        check_against_redraws<PixelFormat::mono1_dithered>(file, {64, 40}, {8, 8}, seed);
    }
    for (unsigned seed = 0; seed < 3; ++seed) { // the last pixels of a row do not fill their byte
        check_against_redraws<PixelFormat::rgb444>(file, {61, 40}, {2, 1}, seed);
        check_against_redraws<PixelFormat::grey4>(file, {61, 40}, {2, 1}, seed);
        check_against_redraws<PixelFormat::mono1>(file, {57, 40}, {8, 1}, seed);
        check_against_redraws<PixelFormat::mono1_dithered>(file, {63, 40}, {8, 1}, seed);
    }
    for (const RawScene& scene : moving_scenes())
        check_against_redraws<PixelFormat::rgb565>(scene.file(), {60, 40}, {1, 1}, 7);
}

TEST_CASE("curves that stand still are the same wherever something passes over them")
{
    std::string text = "kfast 1\ncanvas 240 240 frames=24\n";
    std::mt19937 random{5};
    for (int i = 0; i < 30; ++i)
        text += "object o" + std::to_string(i) + " fill=white stroke=red width=2 { circle " +
                std::to_string(random() % 240) + " " + std::to_string(random() % 240) +
                " r=" + std::to_string(4 + random() % 40) + " }\n";
    text += "object bar fill=\"#00ff0060\" { rect 0 0 9 150; key 0 x=0 y=0; key 23 x=230 y=90 }\n";
    check_against_redraws<PixelFormat::rgb565>(compiled(text), {240, 240}, {1, 1}, 11);
    check_against_redraws<PixelFormat::rgb565>(compiled(text), {300, 290}, {1, 1}, 12);
}

TEST_CASE("narrow areas at the panel's edge find room for whole bytes")
{
    PlayerFixture fixture{"kfast 1\ncanvas 9 20 frames=20\n"
                          "object o fill=white { rect 8 0 1 20; key 0 opacity=0; key 10 opacity=1 }\n",
                          {9, 20}};
    PanelMemory<PixelFormat::mono1> memory{{9, 20}};
    for (const int frame : {0, 10, 0}) {
        fixture.player.show(Time::frame(frame));
        bring_up_to_date(fixture, memory, 1, {8, 1}, 11);
        CHECK(memory.bytes().back() == std::byte(frame == 0 ? 0 : 0x80));
    }
}

constexpr std::string_view two_squares = R"(
kfast 1
canvas 100 60 frames=20 background="#102030"
object still fill=red { rect 5 5 30 50 }
object moving fill="#ffffff80" { rect 50 10 20 40; key 0 x=0; key 19 x=10 }
group opacity=0.5 { object dim fill=blue { rect 10 10 10 10 }; object over fill=red { rect 15 15 9 9 } }
)";

TEST_CASE("a picture that equals the last costs nothing")
{
    PlayerFixture fixture{
        "kfast 1\ncanvas 20 20 frames=20\nobject o fill=red {\n  key 0 { rect 2 2 9 9 }\n  key 10 { rect 2 2 "
        "9 9 }\n}\n",
        {20, 20}};
    PanelMemory<PixelFormat::rgb565> memory{{20, 20}};
    CHECK(bring_up_to_date(fixture, memory, 20).bytes == 20 * 20 * 2);
    for (int frame = 1; frame < 20; ++frame) {
        fixture.player.show(Time::frame(frame));
        CHECK(bring_up_to_date(fixture, memory, 20).areas == 0);
    }
}

TEST_CASE("whole rows go together, other areas are no higher than a band")
{
    constexpr Size panel{40, 40};
    PlayerFixture fixture{
        "kfast 1\ncanvas 40 40 frames=20\nobject o fill=red { key 0 { rect 5 0 9 40 }; key 10 { rect "
        "5 0 19 40 } }",
        panel};
    Bytes pixels(row_bytes(PixelFormat::rgb565, panel.width) * static_cast<std::size_t>(panel.height));
    fixture.player.show({});
    const auto first = fixture.player.draw_changes<PixelFormat::rgb565>(pixels, {1, 1}, 11);
    REQUIRE(first.size() == 1);
    CHECK(first[0].area == Rect{0, 0, panel.width, panel.height});
    CHECK(fixture.player.draw_changes<PixelFormat::rgb565>(pixels, {1, 1}, 11).empty());
    fixture.player.show(Time::frame(1));
    int areas = 0;
    for (;;) {
        // Areas are so dear that both sides of the rectangle are in one.
        const auto changes = fixture.player.draw_changes<PixelFormat::rgb565>(pixels, {1, 1}, 400);
        if (changes.empty())
            break;
        for (const Change& change : changes) {
            ++areas;
            CHECK(change.area.height <= 4);
        }
    }
    CHECK(areas == 10);
}

TEST_CASE("a step costs nothing up to the next")
{
    constexpr std::string_view stepping = R"kfast(
kfast 1
canvas 40 40 frames=20
object moving fill=red { rect 2 2 9 9; key 0 x=0 law="steps(5)"; key 20 x=20 }
object bending fill=blue {
    key 0 law="steps(5)" { polygon 2 20 12 20 7 30 }
    key 20 { polygon 22 20 32 20 30 38 }
}
object turning fill=lime { rect 6 30 8 4; key 0 y=0 law-x=ease law-y="steps(5)"; key 20 y=5 }
)kfast";
    PlayerFixture fixture{stepping, {40, 40}};
    PanelMemory<PixelFormat::rgb565> memory{{40, 40}};
    for (int frame = 0; frame < 20; ++frame) {
        fixture.player.show(Time::frame(frame));
        CHECK((bring_up_to_date(fixture, memory, 4).areas != 0) == (frame % 4 == 0));
        CHECK(memory.bytes() == PlayerFixture{stepping, {40, 40}}.picture(Time::frame(frame)));
    }
}

TEST_CASE("what stands still is seen up to its borders, and again further down")
{
    for (int x = 0; x < 40; ++x) {
        const std::string text = "kfast 1\ncanvas 60 40 frames=8\n"
                                 "object still fill=red { circle 30 20 r=10.3 }\n"
                                 "object dot fill=\"#ffffff80\" { rect " +
                                 std::to_string(x) + " 2 12 5; rect 24 27 10 3; key 0 x=0; key 8 x=4 y=4 }\n";
        check_frames(compiled(text), {60, 40}, 8, 2);
    }
}

TEST_CASE("what stands still is not sent again, nor the inside of what moves")
{
    PlayerFixture fixture{two_squares, {100, 60}};
    PanelMemory<PixelFormat::rgb565> memory{{100, 60}};
    bring_up_to_date(fixture, memory, 8);
    fixture.player.show(Time::frame(1));
    const Sent sent = bring_up_to_date(fixture, memory, 8);
    CHECK(sent.areas > 0);
    // The two sides of one square, a pixel wide in 9 bands of 4 rows, and the bands in which it begins and
    // ends.
    CHECK(sent.bytes <= 2 * 4 * (9 * 2 + 2 * 21));
    CHECK(memory.bytes() == PlayerFixture{two_squares, {100, 60}}.picture(Time::frame(1)));
}

TEST_CASE("an opacity that changes is sent wherever its group covers something")
{
    constexpr std::string_view fading = R"(
kfast 1
canvas 40 40 frames=20
group {
    key 0 opacity=0.9; key 19 opacity=0.2
    object one fill=red { rect 4 4 20 20 }
    object two fill=blue { rect 10 10 20 20 }
}
)";
    PlayerFixture fixture{fading, {40, 40}};
    PanelMemory<PixelFormat::rgb565> memory{{40, 40}};
    for (const int frame : {0, 1, 2, 19, 10}) {
        fixture.player.show(Time::frame(frame));
        bring_up_to_date(fixture, memory, 4);
        CHECK(memory.bytes() == PlayerFixture{fading, {40, 40}}.picture(Time::frame(frame)));
    }
}

/// Vertical bars, so many that their spans do not find room.
std::string comb(int teeth)
{
    std::string text = "kfast 1\ncanvas 1000 8 frames=10\nobject comb fill=red { key 0 {";
    for (int i = 0; i < teeth; ++i)
        text += " rect " + std::to_string(2 + 4 * i) + " 1 1.5 6;";
    return text + "}; key 9 x=1 }\n";
}

TEST_CASE("rows with more spans than find room are drawn whole")
{
    check_frames(compiled(comb(200)), {1000, 8}, 10, 3);
}

TEST_CASE("a picture that finds no room is drawn with coarser curves, and writes to its block alone")
{
    Bytes file = compiled(everything);
    const std::uint32_t enough = SceneView::parse(file)->outline_bytes();
    for (const std::uint32_t bytes : {0U, 4U, 64U, enough / 8 / 4 * 4, enough / 2 / 4 * 4}) {
        set_outline_needs(file, {.bytes = bytes, .borders = 200});
        PlayerFixture fixture{file, {60, 40}}; // the end of the block is watched by the address sanitizer
        bool was_coarse = false;
        for (int frame = 0; frame < 20; ++frame) {
            fixture.picture(Time::frame(frame));
            const raster::OutlineStore& outlines = fixture.player.picture().outlines;
            CHECK((outlines.is_full() || outlines.needed_bytes() <= bytes + 4));
            was_coarse = was_coarse || fixture.player.picture().coarseness > 0;
        }
        CHECK(was_coarse);
        check_against_redraws<PixelFormat::rgb565>(file, {60, 40}, {1, 1}, bytes);
    }
}

}
}
