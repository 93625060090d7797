#include "core/player.hpp"

#include "tests/core/panel_memory.hpp"
#include "tests/core/player_fixture.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <string>
#include <vector>

/// Players of scenes that inputs move.
namespace kfast::test {
namespace {

constexpr Size canvas{60, 40};

/// Scenes whose keys stand at 0 … 64, of the time if `by` is empty. An input of that range stands at a tick
/// where the time does: 64 frames are 65536 ticks.
std::vector<std::string> scenes_by(const std::string& by)
{
    const std::string begin =
        "kfast 1\ncanvas 60 40 frames=65\n" + (by.empty() ? std::string{} : "input knob min=0 max=64\n");
    const std::string shape = "circle 12 12 r=7";
    return {
        begin + "object o fill=red { " + shape + "; track x" + by + " { at 0 0; at 20 30; at 64 9 } }",
        begin + "object o fill=red { " + shape + "; track y law=accelerate" + by + " { at 0 0; at 64 9 } }",
        begin + "object o fill=red rule=even-odd" + by + " { key 0 law=ease { " + shape +
            " }; key 40 match=length { rect 20 10 30 20 }; key 64 { empty } }",
        begin + "group" + by +
            " { key 0 law=\"steps(5)\" rotate=0; key 64 rotate=90 opacity=0.3\n"
            "object o fill=red stroke=blue { " +
            shape + " } }",
        begin + "symbol s { object o fill=red { " + shape + " } }\nuse s" + by +
            " { key 0 x=0 order=2; key 30 x=20 visible=#false; key 33 x=22 visible=#true }\n"
            "object p fill=lime { rect 8 8 30 9 }",
        begin +
            "bones s { bone a 10 20 30 20 { bone b 30 20 50 20 }\n"
            "pose 0" +
            by + " { a turn=9; b turn=3 }\npose 64" + by +
            " { a x=4; b turn=40 } }\n"
            "object o fill=red skin=s { rect 10 14 40 12 }",
        begin + "object o fill=red" + by +
            " {\nkey 0 { skeleton { backbone 10 20 30 20 50 20; width 8 }\n"
            "rect 10 14 40 12 }\nkey 64 { skeleton { backbone 10 30 30 10 50 30; width 8 } } }",
    };
}

constexpr std::string_view two_inputs = R"(
kfast 1
canvas 60 40 frames=30
input a min=-1 max=1
input b
object still fill=silver stroke=red { rect 3 3 20 9 }
group { track x input=a { at -1 -5; at 1 15 }
    object one fill=red { circle 20 20 r=8 } }
object two fill="#00ff0080" input=b { key 0 { rect 20 20 9 9 }; key 0.5 { circle 40 20 r=9 }; key 1 { empty } }
object three fill=blue { rect 0 30 8 8; key 0 x=0; key 29 x=50; track y input=b { at 0 0; at 1 -20 } }
object held fill=lime input=a { rect 40 2 9 9; key -1 law=hold x=0; key 1 x=7 }
)";

std::vector<Time> some_places(unsigned seed)
{
    std::mt19937 random{seed};
    std::vector<Time> places{{0}, {65536}, {1}, {65535}, {20 * 1024}};
    for (int i = 0; i < 12; ++i)
        places.push_back({static_cast<std::int32_t>(random() % 65537)});
    return places;
}

}

TEST_CASE("what goes by an input stands where the time would have brought it")
{
    const std::vector<std::string> by_time = scenes_by("");
    const std::vector<std::string> by_input = scenes_by(" input=knob");
    for (std::size_t i = 0; i < by_time.size(); ++i) {
        CAPTURE(by_input[i]);
        PlayerFixture timed{by_time[i], canvas};
        PlayerFixture put{by_input[i], canvas};
        for (const Time place : some_places(static_cast<unsigned>(i))) {
            put.player.set_input(0, place);
            REQUIRE(put.picture(Time::frame(7)) == timed.picture(place));
        }
    }
}

TEST_CASE("an input does not move with the time, and stays where it was put")
{
    PlayerFixture fixture{scenes_by(" input=knob").front(), canvas};
    fixture.player.set_input(0, {30'000});
    const Bytes picture = fixture.picture({});
    CHECK(fixture.picture(Time::frame(40)) == picture);
    CHECK(fixture.player.input(0) == Time{30'000});
    fixture.player.set_input(0, {30'001 + 2000});
    CHECK(fixture.picture(Time::frame(40)) != picture);
}

TEST_CASE("an input stands at its usual place at first, and is held within its range")
{
    PlayerFixture fixture{two_inputs, canvas};
    CHECK(fixture.player.input(0) == Time{32768});
    CHECK(fixture.player.input(1) == Time{0});
    fixture.player.set_input(0, {-5});
    CHECK(fixture.player.input(0) == Time{0});
    fixture.player.set_input(0, {70'000});
    CHECK(fixture.player.input(0) == whole_input);
}

TEST_CASE("the panel shows what a full redraw would, however inputs and time move")
{
    for (unsigned seed = 0; seed < static_cast<unsigned>(rounds(12)); ++seed) {
        std::mt19937 random{seed};
        PlayerFixture fixture{two_inputs, canvas};
        PanelMemory<PixelFormat::rgb565> memory{canvas};
        Time time;
        for (int round = 0; round < 60; ++round) {
            if (random() % 2 == 0)
                time = {static_cast<std::int32_t>(random() % (30 * 1024))};
            for (std::uint32_t input = 0; input < 2; ++input)
                if (random() % 3 == 0)
                    fixture.player.set_input(input, {static_cast<std::int32_t>(random() % 65537)});
            fixture.player.show(time);
            if (random() % 5 == 0)
                continue; // never drawn
            if (random() % 5 == 0)
                fixture.player.set_input(random() % 2,
                                         {static_cast<std::int32_t>(random() % 65537)}); // too late
            PlayerFixture fresh{fixture.bytes, canvas};
            bring_up_to_date(fixture, memory, 5);
            fixture.player.show(time);
            for (std::uint32_t input = 0; input < 2; ++input)
                fresh.player.set_input(input, fixture.player.input(input));
            bring_up_to_date(fixture, memory, 5);
            REQUIRE(memory.bytes() == fresh.picture(time));
        }
    }
}

TEST_CASE("an input that moves nothing that is seen sends nothing, and one that stays put neither")
{
    PlayerFixture fixture{two_inputs, canvas};
    PanelMemory<PixelFormat::rgb565> memory{canvas};
    fixture.player.show({});
    bring_up_to_date(fixture, memory, 40);
    fixture.player.set_input(0, fixture.player.input(0));
    fixture.player.show({});
    CHECK(bring_up_to_date(fixture, memory, 40).areas == 0);
    fixture.player.set_input(1, {1});
    fixture.player.show({});
    CHECK(bring_up_to_date(fixture, memory, 40).bytes < 100 * 2);
    fixture.player.set_input(0, {40'000});
    fixture.player.show({});
    CHECK(bring_up_to_date(fixture, memory, 40).areas > 0);
}

TEST_CASE("outlines have room wherever inputs stand")
{
    const std::string comb = [] {
        std::string text = "kfast 1\ncanvas 60 40 frames=2\ninput teeth\nobject o fill=red input=teeth {\n"
                           "key 0 { rect 0 0 9 9 }\nkey 0.999 law=hold { rect 0 0 9 9 }\nkey 1 {";
        for (int i = 0; i < 40; ++i)
            text += " circle " + std::to_string(i) + " 20 r=6;";
        return text + "} }";
    }();
    PlayerFixture fixture{comb, canvas};
    fixture.player.set_input(0, whole_input);
    fixture.picture({});
    CHECK_FALSE(fixture.player.picture().outlines.is_full());
    CHECK(fixture.player.picture().coarseness == 0);
}

}
