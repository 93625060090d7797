#include "host/lottie/values/channel.hpp"

#include "host/lottie/values/json.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <string>

using namespace kfast;
using namespace kfast::lottie;
using art::EaseKind;

namespace {

art::Channel channel(const char* text, std::size_t index = 0, const LayerTime& time = {})
{
    art::Budget budget;
    const Json owner = Json::parse(text);
    return read_channel(owner, "p", index, 7, 1, time, budget);
}

art::Animated<art::Drawing> path(const char* text)
{
    art::Budget budget;
    const Json owner = Json::parse(text);
    return read_path(owner, "ks", {}, budget);
}

}

TEST_CASE("an ease beyond all numbers is refused only where something changes")
{
    const auto keys = [](const char* end) {
        return std::string{R"({"p": {"k": [{"t": 0, "s": [5], "o": {"x": [0.3], "y": [217009073858475]},
                           "i": {"x": [0.6], "y": [1]}}, {"t": 9, "s": [)"} +
               end + "]}]}}";
    };
    CHECK(channel(keys("5").c_str()).at(4) == 5);
    CHECK_THROWS_AS(channel(keys("6").c_str()), WrongMember);
}

TEST_CASE("a loop repeats the keys as long as the layer is seen")
{
    const auto looped = [](const std::string& expression, const LayerTime& time) {
        return channel(
            (R"({"p": {"k": [{"t": 10, "s": [0]}, {"t": 20, "s": [8]}, {"t": 30, "s": [4], "h": 1}], "x": ")" +
             expression + "\"}}")
                .c_str(),
            0, time);
    };
    const LayerTime seen{.seen = {0, 95}};
    const art::Channel cycle = looped("var $bm_rt;\\n$bm_rt = loopOut('cycle', 0);", seen);
    for (double time = 10; time < 95; time += 0.75) {
        CAPTURE(time);
        CHECK(cycle.at(time) == doctest::Approx(cycle.at(10 + std::fmod(time - 10, 20))).epsilon(0.01));
    }
    CHECK(cycle.at(5) == 0);
    const art::Channel there_and_back = looped("loopOut(\\\"pingpong\\\")", seen);
    CHECK(there_and_back.at(35) == 6);
    CHECK(there_and_back.at(45) == 4);
    CHECK(there_and_back.at(55) == 4);
    const art::Channel last = looped("$bm_rt = loopOut('cycle', 1);", seen);
    CHECK(last.at(35) == doctest::Approx(6).epsilon(0.001));
    CHECK(last.at(65) == doctest::Approx(6).epsilon(0.001));
    const art::Channel before = looped("loopIn()", {.seen = {-35, 40}});
    CHECK(before.at(-5) == 4);
    CHECK(before.at(-25) == 4);
    CHECK(before.at(60) == 4);
    for (const char* const same : {"var $bm_rt;\\n$bm_rt = loopOut('Cycle');",
                                   "thisProperty.loopOut('CYCLE') ;", "$bm_rt = loopOut ( 'cycle' , 0 );\\n"})
        CHECK(looped(same, seen) == cycle);
    CHECK(looped("loopOut('PingPong')", seen) == there_and_back);
    CHECK(looped("loopOut('offset')", seen).keys.size() == 3);
    CHECK(looped("loopOut()", {}).keys.size() == 3); // it is not known how long it is seen
    CHECK(looped("loopIn()", {.start = 100, .stretch = -1, .seen = {0, 200}}).at(115) == 6);
}

TEST_CASE("a property that is missing or empty is as usual")
{
    CHECK(channel("{}").value() == 7);
    CHECK(channel(R"({"p": null})").value() == 7);
    CHECK(channel(R"({"p": {"k": []}})").value() == 7);
    CHECK(channel(R"({"p": {"k": [1]}})", 1).value() == 7);
}

TEST_CASE("a property that is still may be a number, a list, or stand alone")
{
    CHECK(channel(R"({"p": {"a": 0, "k": 3}})").value() == 3);
    CHECK(channel(R"({"p": {"k": 3}})", 1).value() == 3);
    CHECK(channel(R"({"p": {"k": [1, 2]}})", 1).value() == 2);
    CHECK(channel(R"({"p": [1, 2]})", 1).value() == 2);
    CHECK(channel(R"({"p": 5})").value() == 5);
}

TEST_CASE("keys have eases of their own for each component")
{
    const char* const text = R"({"p": {"a": 1, "k": [
        {"t": 10, "s": [1, 100], "o": {"x": [0.1, 0.3], "y": [0.2, 0.3]}, "i": {"x": [0.8, 0.6], "y": [1, 0.6]}},
        {"t": 20, "s": [2, 200], "h": 1},
        {"t": 30, "s": [3, 300], "o": {"x": 0.5, "y": 0}, "i": {"x": 0.5, "y": 1}},
        {"t": 40}]}})";
    const art::Channel x = channel(text);
    REQUIRE(x.keys.size() == 4);
    CHECK(x.keys[0] == art::Key<double>{10, 1, {EaseKind::cubic, 0.1, 0.2, 0.8, 1}});
    CHECK(x.keys[1].ease.kind == EaseKind::hold);
    CHECK(x.keys[2] == art::Key<double>{30, 3, {EaseKind::cubic, 0.5, 0, 0.5, 1}});
    CHECK(x.keys[3] == art::Key<double>{40, 3, {}});
    const art::Channel y = channel(text, 1);
    CHECK(y.keys[0] == art::Key<double>{10, 100, {}});
    CHECK(y.keys[2].value == 300);
}

TEST_CASE("keys of old files have the value that they lead to, and need neither eases nor \"a\"")
{
    const art::Channel channel_of_two = channel(R"({"p": {"k": [{"t": 0, "s": [1], "e": [5]}, {"t": 8}]}})");
    REQUIRE(channel_of_two.keys.size() == 2);
    CHECK(channel_of_two.keys[0] == art::Key<double>{0, 1, {}});
    CHECK(channel_of_two.keys[1] == art::Key<double>{8, 5, {}});
    const art::Channel numbers = channel(R"({"p": {"k": [{"t": 0, "s": 1}, {"t": 8, "s": 4}]}})");
    CHECK(numbers.at(4) == 2.5);
}

TEST_CASE(
    "a value jumps where a way leads to another one than the next key has, and between keys of one time")
{
    const art::Channel led = channel(R"({"p": {"k": [{"t": 0, "s": 0, "e": 8}, {"t": 8, "s": 100}]}})");
    REQUIRE(led.keys.size() == 3);
    CHECK(led.at(4) == doctest::Approx(4).epsilon(0.001));
    CHECK(led.at(7.9995) == 8);
    CHECK(led.at(8) == 100);
    const art::Channel equal = channel(R"({"p": {"k": [{"t": 0, "s": 0}, {"t": 8, "s": 8}, {"t": 8, "s": 100},
        {"t": 16, "s": 200}]}})");
    CHECK(equal.at(7.9995) == 8);
    CHECK(equal.at(8) == 100);
    CHECK(equal.at(12) == 150);
    CHECK(channel(R"({"p": {"k": [{"t": 8, "s": 1}, {"t": 8, "s": 2}]}})").at(0) == 1);
    CHECK(channel(R"({"p": {"k": [{"t": 8, "s": 1}, {"t": 8, "s": 2}]}})").at(8) == 2);
}

TEST_CASE("keys stand at frames of the scene")
{
    const art::Channel moved = channel(R"({"p": {"k": [{"t": 0, "s": 0}, {"t": 8, "s": 8}]}})", 0, {5, 2});
    CHECK(moved.keys[0].time == 5);
    CHECK(moved.keys[1].time == 21);
}

TEST_CASE("a negative stretch turns keys round")
{
    const art::Channel turned = channel(R"({"p": {"k": [
        {"t": 0, "s": 0, "o": {"x": 0.4, "y": 0}, "i": {"x": 0.9, "y": 1}}, {"t": 10, "s": 8, "h": 1},
        {"t": 20, "s": 50}]}})",
                                        0, {100, -1});
    CHECK(turned.at(70) == 50);
    CHECK(turned.at(79) == 50);
    CHECK(turned.at(80) == 8);
    CHECK(turned.at(89) == 8);
    CHECK(turned.at(100) == 0);
    const art::Ease ease{EaseKind::cubic, 0.4, 0, 0.9, 1};
    CHECK(turned.at(97) == doctest::Approx(8 * share_of_way(ease, 0.3)));
}

TEST_CASE("colours count to 1, or to 255 in old files, and their opacity is left aside")
{
    art::Budget budget;
    const Json owner = Json::parse(R"({"new": {"k": [1, 0.5, 0, 0.2]}, "old": {"k": [255, 51, 0, 255]}})");
    CHECK(read_colour(owner, "new", {}, budget).value() == art::Rgb{1, 0.5, 0});
    CHECK(read_colour(owner, "old", {}, budget).value() == art::Rgb{1, 0.2, 0});
    CHECK(read_colour(owner, "none", {}, budget).value() == art::Rgb{0, 0, 0});
}

TEST_CASE("a path has lines where it has no tangents")
{
    const auto drawings =
        path(R"({"ks": {"k": {"v": [[0, 0], [10, 0], [10, 10]], "i": [[0, 0], [0, 0], [0, -5]],
        "o": [[0, 0], [3, 0], [0, 0]], "c": true}}})");
    const scene::Outline& outline = drawings.value().outlines.front();
    CHECK(outline.closed);
    REQUIRE(outline.curves.size() == 3);
    CHECK_FALSE(outline.curves[0].cubic);
    CHECK(outline.curves[1].cubic);
    CHECK(outline.curves[1].c1.x == 13);
    CHECK(outline.curves[1].c2.y == 5);
    CHECK_FALSE(outline.curves[2].cubic);
    CHECK(outline.curves[2].to.x == 0);
}

TEST_CASE("a line that becomes a curve has its tangents grow from nothing")
{
    const auto drawings = path(R"({"ks": {"a": 1, "k": [
        {"t": 0, "s": [{"v": [[0, 0], [9, 0]], "i": [[0, 0], [0, 0]], "o": [[0, 0], [0, 0]], "c": false}]},
        {"t": 2, "s": [{"v": [[0, 0], [9, 0]], "i": [[0, 0], [0, 4]], "o": [[0, 4], [0, 0]], "c": false}]}]}})");
    const scene::Curve curve = drawings.at(1).outlines.front().curves.front();
    CHECK(curve.c1.x == 0);
    CHECK(curve.c1.y == 2);
    CHECK(curve.c2.x == 9);
}

TEST_CASE("a path may be empty, a point, or without tangents")
{
    CHECK(path(R"({"ks": {"k": {"v": [], "i": [], "o": [], "c": true}}})").value().outlines.empty());
    CHECK(path(R"({"ks": {"k": {"v": [[1, 2]], "c": false}}})").value().outlines.front().curves.empty());
    CHECK(path(R"({"closed": true, "ks": {"k": {"v": [[1, 2], [3, 4]]}}})").value().outlines.front().closed);
}

TEST_CASE("what is of another kind is refused where it is")
{
    CHECK_THROWS_AS(channel(R"({"p": {"k": "3"}})"), WrongMember);
    CHECK_THROWS_AS(channel(R"({"p": {"k": [true]}})"), WrongMember);
    CHECK_THROWS_AS(channel(R"({"p": {"k": {"s": 1}}})"), WrongMember);
    CHECK_THROWS_AS(channel(R"({"p": {"q": 1}})"), WrongMember);
    CHECK_THROWS_AS(channel(R"({"p": {"k": [{"t": 0}, {"t": 1, "s": 1}]}})"), WrongMember);
    CHECK_THROWS_AS(channel(R"({"p": {"k": [{"t": 0, "s": 1}, 5]}})"), WrongMember);
    CHECK_THROWS_AS(channel(R"({"p": {"k": 1e10}})"), WrongMember);
    CHECK_THROWS_AS(path(R"({"ks": {"k": {"v": [[1]]}}})"), WrongMember);
    CHECK_THROWS_AS(path(R"({"ks": {"k": {"v": 3}}})"), WrongMember);
    CHECK_THROWS_AS(path(R"({"ks": {"k": 3}})"), WrongMember);
}
