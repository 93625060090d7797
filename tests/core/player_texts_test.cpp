#include "core/player.hpp"

#include "tests/core/panel_memory.hpp"
#include "tests/core/player_fixture.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Players of scenes with texts from outside.
namespace kfast::test {
namespace {

constexpr Size canvas{120, 60};

std::string with_text(const std::string& glyphs, int max, const std::string& object)
{
    return "kfast 1\ncanvas 120 60 frames=20\ninput t kind=text glyphs=\"" + glyphs +
           "\" max=" + std::to_string(max) + "\n" + object;
}

/// The same object around a label, and around a text that is written.
struct Frame {
    std::string before;
    std::string after;
};

/// In the fonts of Hershey in even sizes, all points lie on 1/16 px.
const std::vector<Frame> frames{
    {"object o fill=red stroke=white width=1.5 { text ", " at=\"3,40\" size=32 font=hershey-sans }"},
    {"object o stroke=white width=2 cap=round { text ",
     " at=\"60,40\" size=14 font=hershey-sans align=center }"},
    {"object o stroke=white { text ", " at=\"117,40\" size=22 font=hershey-sans align=right spacing=-1.25 }"},
    {"object o fill=red rule=even-odd { text ", " at=\"5,40\" size=18 font=hershey-gothic }"},
    {"object o fill=red stroke=white width=2 opacity=0.6 { text ",
     " at=\"6,40\" size=18 font=hershey-sans }"}, // blended
    {"group rotate=-20 opacity=0.5 { object o stroke=aqua width=3 scale=0.7 rotate=11 pivot-x=40 "
     "pivot-y=30 { text ",
     " at=\"10,50\" size=24 font=hershey-sans; key 0 x=0; key 20 x=9 } }"},
    {"object o stroke=lime width=2 rotate-y=40 rotate-x=20 pivot-x=60 pivot-y=30 { text ",
     " at=\"60,44\" size=30 font=hershey-sans align=center }"},
    {"symbol s { object o stroke=red { text ",
     " at=\"4,9\" size=10 font=hershey-sans } }\nuse s 9 20 { key 0 scale=2 }"},
};

}

TEST_CASE("a label has the same bits as a text that is written")
{
    for (const Frame& frame : frames) {
        CAPTURE(frame.before);
        PlayerFixture label{with_text("0-9A-Za-z:%,-", 12, frame.before + "input=t" + frame.after), canvas};
        for (const std::string text : {"12:30", "W,i", "  -7 %", "AVAToy", "x"}) {
            PlayerFixture fixed{
                "kfast 1\ncanvas 120 60 frames=20\n" + frame.before + '"' + text + '"' + frame.after, canvas};
            label.player.set_text(0, text);
            for (const int time : {0, 7})
                REQUIRE(label.picture(Time::frame(time)) == fixed.picture(Time::frame(time)));
        }
    }
}

TEST_CASE("a label of a number has the same bits as a text that is written")
{
    const std::string start = "kfast 1\ncanvas 120 60 frames=20\n";
    for (const Frame& frame : frames) {
        CAPTURE(frame.before);
        PlayerFixture label{start + "input t min=-64 max=64\n" + frame.before +
                                "input=t format=\"v=00.0 %\"" + frame.after,
                            canvas};
        for (const auto& [value, text] : std::vector<std::pair<int, std::string>>{
                 {12'500, "v=12.5 %"}, {-63'960, "v=-64.0 %"}, {0, "v=00.0 %"}, {-40, "v=00.0 %"}}) {
            PlayerFixture fixed{start + frame.before + '"' + text + '"' + frame.after, canvas};
            label.player.set_input(0, label.player.scene().input(0).place_of(value));
            for (const int time : {0, 7})
                REQUIRE(label.picture(Time::frame(time)) == fixed.picture(Time::frame(time)));
        }
    }
}

TEST_CASE("the panel shows what a full redraw would, however numbers and time move")
{
    const std::string scene =
        "kfast 1\ncanvas 120 60 frames=20\ninput a max=99 default=17\ninput b min=-5 max=5\n"
        "object one stroke=white width=2 { text input=a format=\"_0\" at=\"60,30\" size=20 font=hershey-sans "
        "}\n"
        "group { track x input=a { at 0 0; at 99 30 }\n"
        "object two fill=\"#00ff0080\" stroke=red { text input=b format=\"0.00 V\" at=\"4,50\" size=12 "
        "font=hershey-sans; key 0 y=0; key 20 y=5 } }";
    for (int seed = 0; seed < rounds(8); ++seed) {
        std::mt19937 random{static_cast<unsigned>(seed)};
        PlayerFixture fixture{scene, canvas};
        PanelMemory<PixelFormat::rgb565> memory{canvas};
        for (int round = 0; round < 40; ++round) {
            const Time time{static_cast<std::int32_t>(random() % (20 * 1024))};
            for (const std::uint32_t input : {0U, 1U})
                if (random() % 2 == 0)
                    fixture.player.set_input(input, {static_cast<std::int32_t>(random() % 65'537)});
            fixture.player.show(time);
            if (random() % 5 == 0)
                continue; // never drawn
            bring_up_to_date(fixture, memory, 5);
            PlayerFixture fresh{fixture.bytes, canvas};
            for (const std::uint32_t input : {0U, 1U})
                fresh.player.set_input(input, fixture.player.input(input));
            REQUIRE(memory.bytes() == fresh.picture(time));
        }
    }
}

TEST_CASE("a number that stays what it is on the panel sends nothing")
{
    PlayerFixture fixture{"kfast 1\ncanvas 120 60\ninput n max=9\nobject o stroke=white { text input=n "
                          "at=\"4,40\" size=20 font=hershey-sans }",
                          canvas};
    PanelMemory<PixelFormat::rgb565> memory{canvas};
    fixture.player.set_input(0, {30'000}); // 4.12
    fixture.player.show({});
    bring_up_to_date(fixture, memory, 40);
    fixture.player.set_input(0, {32'000}); // 4.39
    fixture.player.show({});
    CHECK(bring_up_to_date(fixture, memory, 40).areas == 0);
    fixture.player.set_input(0, {33'000}); // 4.53
    fixture.player.show({});
    CHECK(bring_up_to_date(fixture, memory, 40).areas > 0);
}

TEST_CASE("outlines have room for any number")
{
    for (const std::string format : {"#", "000.000", "n=0.0 %%%"}) {
        CAPTURE(format);
        PlayerFixture fixture{
            "kfast 1\ncanvas 120 60 frames=20\ninput t min=-99 max=999\n"
            "object o fill=red stroke=white width=3 cap=round join=round { text input=t "
            "format=\"" +
                format +
                "\" at=\"60,40\" size=30 align=center font=hershey-gothic; key 0 scale=0.1; "
                "key 20 scale=3 }",
            canvas};
        for (std::int32_t place = 0; place <= 65'536; place += 97) {
            fixture.player.set_input(0, {place});
            for (const int ticks : {0, 5000, 20'479}) {
                fixture.player.show_moment({ticks});
                REQUIRE_FALSE(fixture.player.picture().outlines.is_full());
                REQUIRE(fixture.player.picture().coarseness == 0);
            }
        }
    }
}

TEST_CASE("a label shows its usual text until another is told")
{
    const std::string object = "object o stroke=red { text input=t at=\"9,40\" size=32 font=hershey-sans }";
    PlayerFixture default_value{
        "kfast 1\ncanvas 120 60\ninput t kind=text glyphs=ab max=3 default=ab\n" + object, canvas};
    PlayerFixture empty{with_text("ab", 3, object), canvas};
    CHECK(default_value.picture({}) != empty.picture({}));
    empty.player.set_text(0, "ab");
    CHECK(default_value.picture({}) == empty.picture({}));
    default_value.player.set_text(0, "");
    empty.player.set_text(0, "  ");
    CHECK(default_value.picture({}) == empty.picture({}));
}

TEST_CASE("what texts take is known to its last byte, whatever the memory held")
{
    const Bytes file = compiled(
        with_text("ab", 5, "object o stroke=red { text input=t at=\"9,40\" size=9 font=hershey-sans }"));
    const SceneView scene = accepted(file);
    Bytes clean(InputTexts::bytes_for(scene));
    Bytes used(clean.size(), std::byte{0xA5});
    const InputTexts of_clean{scene, clean};
    const InputTexts of_used{scene, used};
    CHECK(clean == used);
}

TEST_CASE("what has no glyph and what is too long is left out")
{
    const std::string text =
        with_text("ab", 3, "object o stroke=red { text input=t at=\"9,40\" size=20 font=hershey-sans }");
    PlayerFixture fixture{text, canvas};
    PlayerFixture clean{text, canvas};
    const auto shows = [&](std::string_view sent_text, std::string_view seen) {
        fixture.player.set_text(0, sent_text);
        clean.player.set_text(0, seen);
        return fixture.picture({}) == clean.picture({});
    };
    CHECK(shows("abab", "aba"));
    CHECK(shows("xa\nyb\xC3\xA4z", "ab"));
    CHECK(shows("\xFF"
                "a\xC3",
                "a"));
    CHECK(shows(std::string_view{"a\0b", 3}, "ab"));
    CHECK(shows("xxxxxxxxxxxxb", "b"));
    CHECK_FALSE(shows("ab", "ba"));
    CHECK_FALSE(shows("a", ""));
}

TEST_CASE("a text that stays costs nothing, and one that changes sends its borders")
{
    PlayerFixture fixture{
        with_text("0-9", 8,
                  "object still fill=blue { rect 0 0 20 9 }\n"
                  "object o stroke=white { text input=t at=\"4,40\" size=20 font=hershey-sans }"),
        canvas};
    PanelMemory<PixelFormat::rgb565> memory{canvas};
    fixture.player.set_text(0, "12345678");
    fixture.player.show({});
    bring_up_to_date(fixture, memory, 40);
    fixture.player.set_text(0, "12345678");
    fixture.player.show(Time::frame(3));
    CHECK(bring_up_to_date(fixture, memory, 40).areas == 0);
    fixture.player.set_text(0, "12345679");
    fixture.player.show(Time::frame(3));
    const auto sent = bring_up_to_date(fixture, memory, 40);
    CHECK(sent.areas > 0);
    CHECK(sent.bytes < 8 * 10 * 20 * 2); // of 8 digits, with less than what lies around them
}

TEST_CASE("the panel shows what a full redraw would, however texts and time move")
{
    const std::string scene =
        "kfast 1\ncanvas 120 60 frames=20\n"
        "input a kind=text glyphs=\"0-9\" max=4 default=\"17\"\ninput n\n"
        "input b kind=text glyphs=\"a-z\" max=9\n"
        "object one stroke=white width=2 { text input=a at=\"60,30\" size=20 font=hershey-sans align=center "
        "}\n"
        "group { track x input=n { at 0 0; at 1 30 }\n"
        "object two fill=\"#00ff0080\" stroke=red { text input=b at=\"4,50\" size=12 font=hershey-sans } }\n"
        "object three stroke=aqua { text input=a at=\"4,20\" size=9 font=hershey-sans; key 0 y=0; key 20 "
        "y=30 }";
    for (int seed = 0; seed < rounds(8); ++seed) {
        std::mt19937 random{static_cast<unsigned>(seed)};
        PlayerFixture fixture{scene, canvas};
        PanelMemory<PixelFormat::rgb565> memory{canvas};
        std::string a = "17";
        std::string b;
        for (int round = 0; round < 40; ++round) {
            const Time time{static_cast<std::int32_t>(random() % (20 * 1024))};
            if (random() % 2 == 0)
                a = std::to_string(random() % 20'000);
            if (random() % 2 == 0)
                b = std::string(random() % 12, static_cast<char>('a' + random() % 26));
            fixture.player.set_text(0, a);
            fixture.player.set_text(2, b);
            fixture.player.set_input(1, {static_cast<std::int32_t>(random() % 65537)});
            fixture.player.show(time);
            if (random() % 5 == 0)
                continue; // never drawn
            bring_up_to_date(fixture, memory, 5);
            PlayerFixture fresh{fixture.bytes, canvas};
            fresh.player.set_text(0, a);
            fresh.player.set_text(2, b);
            fresh.player.set_input(1, fixture.player.input(1));
            REQUIRE(memory.bytes() == fresh.picture(time));
        }
    }
}

TEST_CASE("an input that is no text stays what it is, and so does a text that a place is told")
{
    PlayerFixture fixture{
        "kfast 1\ncanvas 120 60\ninput t kind=text glyphs=ab max=3 default=ab\ninput n default=1\n"
        "object o stroke=red { text input=t at=\"9,40\" size=32 font=hershey-sans; track x input=n { "
        "at 0 0; at 1 9 } }",
        canvas};
    const Bytes picture = fixture.picture({});
    fixture.player.set_text(1, "a");
    fixture.player.set_input(0, whole_input);
    CHECK(fixture.picture({}) == picture);
    CHECK(fixture.player.input(1) == whole_input);
}

TEST_CASE("outlines have room for any text")
{
    const std::vector<std::string> objects{
        "object o stroke=white width=1 { text input=t at=\"2,20\" size=9 font=hershey-sans }",
        "object o fill=red stroke=white width=3 cap=round join=round { text input=t at=\"60,40\" size=30 "
        "align=center font=hershey-gothic; key 0 scale=0.1; key 20 scale=3 }",
        "object o stroke=white rotate-y=60 { text input=t at=\"60,40\" size=12 font=hershey-sans "
        "align=right; key 0 "
        "visible=#false; "
        "key 19.9 visible=#true }",
        "object a stroke=red { text input=t at=\"2,20\" size=9 font=hershey-sans }\nobject b stroke=red "
        "width=2 { text input=t "
        "at=\"2,40\" size=11 font=hershey-script }",
    };
    std::mt19937 random{7};
    for (const std::string& object : objects) {
        CAPTURE(object);
        PlayerFixture fixture{with_text("!-~", 20, object), canvas};
        for (int round = 0; round < rounds(101 + 94); ++round) { // any texts, then each character by itself
            std::string text;
            for (int i = 0; i < 20; ++i)
                text +=
                    static_cast<char>('!' + (round < 101 ? static_cast<int>(random() % 94) : round - 101));
            fixture.player.set_text(0, text);
            for (const int ticks : {0, 5000, 20'450, 20'479}) {
                fixture.player.show_moment({ticks});
                REQUIRE_FALSE(fixture.player.picture().outlines.is_full());
                REQUIRE(fixture.player.picture().coarseness == 0);
            }
        }
    }
}

}
