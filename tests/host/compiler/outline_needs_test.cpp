#include "core/kfb_limits.hpp"
#include "core/player.hpp"
#include "host/compiler/measured_moments.hpp"
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
bool finds_room(const std::vector<std::byte>& bytes, Size panel, Time moment)
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
    CHECK(finds_room(by_keys, {240, 240}, Time::frame(11)));
    for (const std::string hidden : {"visible=#false", "opacity=0"}) {
        CAPTURE(hidden);
        const std::string seen = hidden == "opacity=0" ? "opacity=1" : "visible=#true";
        const auto by_track =
            compiled(scene_with("object z fill=red { " + comb(200, 9, 99) + "; key 0 law=hold " + hidden +
                                    "; key 11 law=hold " + seen + "; key 12 " + hidden + " }",
                                "20000"));
        CHECK(finds_room(by_track, {240, 240}, Time::frame(11)));
    }
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
    const auto scene = [&circles](const std::string& usual) {
        return scene_with("input a" + usual + "; input b" + usual + "; input c" + usual +
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
            CHECK(finds_room(bytes, panel, {}));
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
    std::string steps; // few chains
    for (int i = 0; i < 4000; ++i)
        steps +=
            " L " + std::to_string(i % 200) + " " + std::to_string(i / 20) + "." + std::to_string(i % 20 * 5);
    const std::string text = refusal(scene_with(
        "symbol s { object stairs fill=red { key 0 visible=#false; key 7 visible=#true; path \"M 0 0" +
        steps + " Z\" } }\n" + [] {
            std::string uses;
            for (int i = 0; i < 400; ++i)
                uses += "use s\n";
            return uses;
        }()));
    CAPTURE(text);
    CHECK(text.find("s.kfast:3:") == 0);
    CHECK(text.find("the outlines at frame 7 need ") != std::string::npos);
    CHECK(text.find("object \"stairs\" alone needs 22") != std::string::npos);
}

TEST_CASE("wires find room at any time, whatever the camera")
{
    std::mt19937 random{5};
    const auto any = [&random](int least, int most) {
        return std::to_string(least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1)));
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
            CHECK(finds_room(bytes, {240, 240}, Time{static_cast<std::int32_t>(random() % (30 * 1024))}));
    }
}

}
