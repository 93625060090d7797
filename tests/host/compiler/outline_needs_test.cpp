#include "core/player.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/compiler/limits/measured_moments.hpp"
#include "tests/compiled.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <string>

namespace kfast::test {
namespace {

std::string scene_with(const std::string& objects, const std::string& length = "10")
{
    return "kfast 1\ncanvas 240 240 frames=" + length + "\n" + objects;
}

/// A closed path of `teeth` teeth, each two chains, between two heights.
std::string comb(int teeth, int top, int bottom)
{
    std::string path = "path \"M 0 " + std::to_string(bottom);
    for (int i = 0; i < teeth; ++i)
        path += " L " + std::to_string(i % 240) + (i % 2 == 0 ? ".2 " : ".7 ") + std::to_string(top) + " L " +
                std::to_string(i % 240) + ".4 " + std::to_string(bottom);
    return path + " L 0 " + std::to_string(bottom + 9) + " Z\"";
}

/// Whether a player of this shape draws the picture at `moment` as finely as it wants to.
bool fits(const std::vector<std::byte>& bytes, Size panel, Time moment)
{
    const SceneView scene = *SceneView::parse(bytes);
    std::vector<std::uint32_t> block((Player::block_bytes(scene, panel) + 3) / 4);
    auto player = Player::create(scene, panel, Fit::contain, std::as_writable_bytes(std::span{block}));
    player->show_moment(moment);
    return !player->picture().outlines.is_full() && player->picture().coarseness == 0;
}

std::string refusal(const std::string& text)
{
    Diagnostics diagnostics;
    const SourceText source{"s.kfast", text};
    CHECK_FALSE(compile(source, diagnostics));
    REQUIRE(diagnostics.sorted().size() == 1);
    return format(diagnostics.sorted().front(), source);
}

std::string layers_of(int count, const std::string& drawing)
{
    std::string objects;
    for (int i = 0; i < count; ++i)
        objects += "object z" + std::to_string(i) + " fill=red { " + drawing + " }\n";
    return objects;
}

}

TEST_CASE("a drawing that one frame of a long scene shows has room")
{
    const auto by_keys =
        compiled(scene_with("object z fill=red { key 0 law=hold { rect 0 0 9 9 }; key 11 law=hold { " +
                                comb(200, 9, 99) + " }; key 12 { rect 0 0 9 9 } }",
                            "20000"));
    CHECK(fits(by_keys, {240, 240}, Time::frame(11)));
    for (const std::string hidden : {"visible=#false", "opacity=0"}) {
        CAPTURE(hidden);
        const std::string seen = hidden == "opacity=0" ? "opacity=1" : "visible=#true";
        const auto by_track =
            compiled(scene_with("object z fill=red { " + comb(200, 9, 99) + "; key 0 law=hold " + hidden +
                                    "; key 11 law=hold " + seen + "; key 12 " + hidden + " }",
                                "20000"));
        CHECK(fits(by_track, {240, 240}, Time::frame(11)));
    }
}

TEST_CASE("a symbol that goes by its own time has room in a scene, however long")
{
    const std::string symbol = "symbol s frames=25 { object z fill=red { key 0 law=hold { rect 0 0 9 9 }; "
                               "key 12 law=hold { " +
                               comb(200, 9, 99) + " }; key 13 { rect 0 0 9 9 } } }\n";
    const auto alone = compiled(scene_with(symbol + "use s loop=repeat", "100000"));
    CHECK(fits(alone, {240, 240}, Time::frame(12)));
    CHECK(fits(alone, {240, 240}, Time::frame(99'987)));
    // All four show it at frame 27487, and at no other of the first 36,000.
    const auto meeting =
        compiled(scene_with(symbol + "use s loop=repeat\nuse s loop=repeat speed=0.96\n"
                                     "use s loop=repeat speed=0.93\nuse s loop=repeat speed=1.111",
                            "36000"));
    CHECK(fits(meeting, {240, 240}, Time::frame(27'487)));
}

TEST_CASE("copies that keep their distance need no room for meeting")
{
    const std::string copies =
        "symbol s frames=25 { object z fill=red { key 0 law=hold { rect 0 0 9 9 }; key 12 "
        "law=hold { " +
        comb(200, 9, 99) + " }; key 13 { rect 0 0 9 9 } } }\nuse s loop=repeat count=4 delay-step=3";
    const auto block_bytes = [&copies](const std::string& frames) {
        const auto bytes = compiled(scene_with(copies, frames));
        return Player::block_bytes(*SceneView::parse(bytes), {240, 240});
    };
    CHECK(block_bytes("36000") == block_bytes("100"));
}

TEST_CASE("moments are even, at changes and just before them")
{
    const auto bytes =
        compiled(scene_with("object z fill=red { track x { at 0 0; at 5.3 9; at 99 0 }; rect 0 0 9 9 }"));
    const auto moments = measured_moments(*SceneView::parse(bytes));
    CHECK(moments.size() == 4 * 10 + 1 + 2);
    CHECK(std::ranges::is_sorted(moments, {}, &MeasuredMoment::time));
    for (const std::int32_t ticks : {0, 256, 5426, 5427, 10'240})
        CHECK(std::ranges::count(moments, Time{ticks}, &MeasuredMoment::time) == 1);
}

TEST_CASE("moments are thinned out evenly, and of a scene that takes long there are fewer")
{
    const auto dear =
        compiled(scene_with("input a default=0.25\nobject z fill=red { track x input=a { at 0 0; "
                            "at 1 9 }; " +
                            comb(2'500, 9, 99) + " }"));
    const auto view = SceneView::parse(dear);
    const std::vector<MeasuredMoment> all = measured_moments(*view);
    std::vector<MeasuredMoment> some = all;
    thin_out(some, 7);
    REQUIRE(some.size() == 7);
    for (std::size_t i = 0; i < some.size(); ++i) {
        const MeasuredMoment& expected = all[i * (all.size() - 1) / 6];
        CHECK(some[i].time == expected.time);
        CHECK(some[i].inputs == expected.inputs);
    }
    thin_out(some, 0);
    CHECK(some.size() == 2);
    some = all;
    thin_out(some, all.size());
    CHECK(some.size() == all.size());
    CHECK(some[1].inputs == all[1].inputs);
    const auto cheap = compiled(scene_with("object z fill=red { rect 0 0 9 9 }"));
    CHECK(affordable_pictures(*view, 1'000) < 3'000);
    const auto cheap_view = SceneView::parse(cheap);
    CHECK(affordable_pictures(*cheap_view, 1'000) > 250'000);
    CHECK(affordable_pictures(*cheap_view, 4'000'000) < 150); // what it draws is large
}

TEST_CASE("what a scene costs grows with what it shows")
{
    const auto cost = [](const std::string& items) {
        const auto bytes = compiled(scene_with(items));
        return SceneView::parse(bytes)->cost();
    };
    const auto line = [](const std::string& between, const std::string& behind) {
        std::string all;
        for (int i = 0; i < 1024; ++i)
            all += " " + std::to_string(i % 60) + between + (i % 2 == 0 ? behind : " 0");
        return all + " }";
    };
    const std::string drawn = "{ line" + line("", " 30");
    const std::uint32_t filled = cost("object o fill=red " + drawn);
    const std::uint32_t stroked = cost("object o stroke=red " + drawn);
    CHECK(stroked >= filled + 512);
    CHECK(cost("object o fill=red stroke=red " + drawn) >= stroked + 513);
    CHECK(cost("bones b { bone c 0 0 60 0 }\nobject o stroke=red skin=b bone=c " + drawn) >= stroked + 256);
    CHECK(cost("object o stroke=red { wire" + line(" 0", " 30")) >=
          cost("object o stroke=red { line" + line("", " 0")) + 1000);
    const auto label = [&cost](int max) {
        return cost("input t kind=text max=" + std::to_string(max) +
                    " default=\"0\" glyphs=\"0-9\"\nobject o fill=red { text input=t at=\"9,9\" size=20 }");
    };
    CHECK(label(60) > label(10) + 50);
    const auto live = [&cost](int max) {
        return cost("input d kind=drawing points=" + std::to_string(max) +
                    " { line 0 0 9 9 }\nobject o stroke=red live=d");
    };
    CHECK(live(2048) >= live(1024) + 1024);
    std::string way = "M 0 0";
    for (int i = 0; i < 800; ++i)
        way += " L " + std::to_string(i % 2 * 60) + " " + std::to_string(i % 60);
    CHECK(cost("object o fill=red { rect 0 0 9 9; track along \"" + way + "\" { at 0 0; at 9 1 } }") >= 100);
}

TEST_CASE("inputs stand as usual at all moments, then each goes its way, and all of them anywhere")
{
    const auto bytes =
        compiled(scene_with("input a default=0.25; input b\n"
                            "object z fill=red { track x input=a { at 0 0; at 0.3 9; at 1 0 }\n"
                            "track y input=b { at 0 0; at 1 9 }; rect 0 0 9 9 }"));
    const auto moments = measured_moments(*SceneView::parse(bytes));
    constexpr int times = 4 * 10 + 1;
    CHECK(moments.size() == times + (32 + 1 + 2 + 1) + (32 + 1 + 1) + 4 + 1500);
    for (int i = 0; i < times; ++i)
        CHECK(moments[static_cast<std::size_t>(i)].inputs == std::vector<Time>{{16384}, {0}});
    const auto has = [&moments](std::int32_t a, std::int32_t b) {
        return std::ranges::any_of(moments, [&](const MeasuredMoment& moment) {
            return moment.inputs == std::vector<Time>{{a}, {b}};
        });
    };
    for (const std::int32_t ticks : {0, 2048, 19660, 19661, 65535, 65536})
        CHECK(has(ticks, 0));
    for (const std::int32_t ticks : {0, 2048, 65535, 65536})
        CHECK(has(16384, ticks));
    for (const std::int32_t a : {0, 19660, 19661, 65536})
        CHECK(has(a, 65536));
}

TEST_CASE("what is seen only when several inputs are at their ends has room")
{
    std::string circles;
    for (int i = 0; i < 60; ++i)
        circles += "circle " + std::to_string(4 * i) + " 50 r=9; ";
    const auto scene = [&circles](const std::string& default_value) {
        return scene_with("input a" + default_value + "; input b" + default_value + "; input c" +
                          default_value +
                          "\ngroup input=a { key 0 visible=#false; key 1 visible=#true\n"
                          "group input=b { key 0 visible=#false; key 1 visible=#true\n"
                          "group input=c { key 0 visible=#true; key 1 visible=#false\n"
                          "object o fill=red { " +
                          circles + "} } } }");
    };
    const auto bytes = [](const std::string& text) {
        return SceneView::parse(compiled(text))->outline_bytes();
    };
    const std::string shown = scene_with("object o fill=red { " + circles + "}");
    CHECK(bytes(scene("")) == bytes(shown));
    CHECK(bytes(scene(" default=1")) == bytes(shown));
}

TEST_CASE("what lies above and below of the canvas has room on panels of all shapes")
{
    for (const auto& [top, bottom] : {std::pair{-50, -10}, std::pair{250, 290}}) {
        const auto bytes = compiled(scene_with("object z fill=red { " + comb(400, top, bottom) + " }"));
        for (const Size panel : {Size{240, 240}, Size{120, 240}, Size{60, 240}, Size{240, 480}})
            CHECK(fits(bytes, panel, {}));
    }
}

TEST_CASE("outlines of too many bytes are an error at the largest object")
{
    const std::string text =
        refusal(scene_with("object small fill=red { rect 0 0 9 9 }\n" + layers_of(20, comb(2000, 9, 99)) +
                           "group { object large fill=red { " + comb(2500, 9, 99) + " } }"));
    CAPTURE(text);
    CHECK(text.find("s.kfast:24:") == 0);
    CHECK(text.find("the outlines at frame 0 need ") != std::string::npos);
    CHECK(text.find(" bytes, ") != std::string::npos);
    CHECK(text.find(" more than the format holds; object \"large\" alone needs 34") != std::string::npos);
}

TEST_CASE("outlines of too many bytes are an error at the largest object in a symbol, too")
{
    std::string uses;
    for (int i = 0; i < 20; ++i)
        uses += "use s\n";
    const std::string text =
        refusal(scene_with("symbol s { object comb fill=red { key 0 visible=#false; key 7 "
                           "visible=#true; " +
                           comb(2500, 9, 99) + " } }\n" + uses));
    CAPTURE(text);
    CHECK(text.find("s.kfast:3:") == 0);
    CHECK(text.find("the outlines at frame 7 need ") != std::string::npos);
    CHECK(text.find("object \"comb\" alone needs 34") != std::string::npos);
}

TEST_CASE("wires find room at any time, whatever the camera")
{
    std::mt19937 random{5};
    const auto any = [&random](int min, int max) {
        return std::to_string(min + static_cast<int>(random() % static_cast<unsigned>(max - min + 1)));
    };
    for (int round = rounds(40); round > 0; --round) {
        std::string wires;
        for (int key = 0; key < 3; ++key) {
            wires += "key " + std::to_string(10 * key) + " {";
            for (int left = 1 + static_cast<int>(random() % 3); left > 0; --left) {
                wires += " wire";
                for (int point = 2 + static_cast<int>(random() % 20); point > 0; --point)
                    wires += " " + any(-300, 500) + " " + any(-300, 500) + " " + any(-500, 500);
                wires += ";";
            }
            wires += " }\n";
        }
        const auto bytes =
            compiled("kfast 1\ncanvas 240 240 frames=30 camera=" + any(16, 2000) +
                     "\nobject o stroke=red width=" + any(1, 30) + " join=round cap=round {\n" + wires +
                     "track rotate-y { at 0 0; at 30 " + any(0, 1000) +
                     " }\ntrack rotate-x { at 0 0; at 30 " + any(0, 1000) + " }\n}");
        for (int i = 0; i < 60; ++i)
            CHECK(fits(bytes, {240, 240}, Time{static_cast<std::int32_t>(random() % (30 * 1024))}));
    }
}

}
