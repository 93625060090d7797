#include "host/import/dot_lottie.hpp"

#include "host/program/failure.hpp"
#include "tests/host/archive/packed.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using importing::PackedAnimation;

namespace {

struct Read {
    PackedAnimation animation;
    art::Losses losses;
};

Read read(const test::Files& files, const std::string& wanted = "")
{
    const std::string packed = test::zipped(files);
    Read result;
    result.animation = importing::read_dot_lottie("x.lottie", {"x.lottie", packed}, wanted,
                                                  std::size_t{1} << 20, result.losses);
    return result;
}

bool reports(const art::Losses& losses, std::string_view feature)
{
    return std::ranges::any_of(losses.list(), [&](const art::Loss& loss) { return loss.feature == feature; });
}

const test::Files two{{"manifest.json", R"({"version":"2","animations":[{"id":"one"},{"id":"two"}]})"},
                      {"a/one.json", "1"},
                      {"a/two.json", "2"}};

}

TEST_CASE("version 1 has animations/ID.json")
{
    const Read one = read({{"manifest.json", R"({"version":"1","animations":[{"id":"walk"}]})"},
                           {"animations/walk.json", "text"}});
    CHECK(one.animation.text == "text");
    CHECK(one.losses.empty());
    CHECK_FALSE(one.animation.playing.loop);
    CHECK(one.animation.playing.speed == 1);
}

TEST_CASE("version 2 has a/ID.json")
{
    CHECK(
        read({{"manifest.json", R"({"version":"2","animations":[{"id":"walk"}]})"}, {"a/walk.json", "text"}})
            .animation.text == "text");
}

TEST_CASE("of several, the first is taken, which is told")
{
    const Read first = read(two);
    CHECK(first.animation.text == "1");
    REQUIRE(first.losses.list().size() == 1);
    CHECK(first.losses.list()[0].instead == "'one' of one, two (--animation ID takes another)");
}

TEST_CASE("the manifest tells which one it begins with")
{
    test::Files files = two;
    files[0].second = R"({"initial":{"animation":"two"},"animations":[{"id":"one"},{"id":"two"}]})";
    CHECK(read(files).animation.text == "2");
    files[0].second = R"({"activeAnimationId":"two","animations":[{"id":"one"},{"id":"two"}]})";
    CHECK(read(files).animation.text == "2");
    files[0].second = R"({"activeAnimationId":"nine","animations":[{"id":"one"},{"id":"two"}]})";
    CHECK(read(files).animation.text == "1");
}

TEST_CASE("the one that is wanted is taken, and nothing is lost then")
{
    const Read second = read(two, "two");
    CHECK(second.animation.text == "2");
    CHECK(second.losses.empty());
    CHECK_THROWS_WITH_AS(read(two, "six"), "x.lottie: there is no animation 'six': it has one, two", Failure);
}

TEST_CASE("what is not there is not chosen, and the names of the files do without a manifest")
{
    CHECK(read({{"manifest.json", R"({"animations":[{"id":"gone"},{"id":"here"}]})"}, {"a/here.json", "x"}})
              .animation.text == "x");
    CHECK(read({{"animations/only.json", "y"}}).animation.text == "y");
    CHECK_THROWS_AS(read({{"readme.txt", "hello"}}), Failure);
    CHECK_THROWS_WITH_AS(read({{"manifest.json", "[1"}, {"a/a.json", ""}}),
                         "x.lottie: manifest.json is no JSON object: pack the file again", Failure);
}

TEST_CASE("a manifest says how it is played")
{
    const auto playing = [](const std::string& facts) {
        return read({{"manifest.json", R"({"animations":[{"id":"a",)" + facts + "}]}"}, {"a/a.json", ""}})
            .animation.playing;
    };
    CHECK(playing(R"("loop":true)").loop == Loop::repeat);
    CHECK(playing(R"("loop":false)").loop == Loop::once);
    CHECK(playing(R"("playMode":"bounce","loop":true)").loop == Loop::ping_pong);
    CHECK(playing(R"("speed":1.5)").speed == 1.5);
    CHECK(playing(R"("speed":0)").speed == 1);
    CHECK(playing(R"("speed":"fast")").speed == 1);
    CHECK(playing(R"("background":"#ff0033")").background == art::Rgb{1, 0, 0.2});
    CHECK(playing(R"("background":"#ff003380")").background == art::Rgb{1, 0, 0.2});
    for (const auto* wrong :
         {R"("background":"red")", R"("background":"#ff")", R"("background":"#12345g")", R"("background":7)"})
        CHECK_FALSE(playing(wrong).background);
}

TEST_CASE("what else a manifest wants is told")
{
    const art::Losses losses =
        read({{"manifest.json", R"({"animations":[{"id":"a","direction":-1,"hover":true,
        "intermission":200,"loop":3,"speed":-2}],"themes":[{"id":"t"}],"stateMachines":[{"id":"s"}]})"},
              {"a/a.json", ""}})
            .losses;
    CHECK(losses.list().size() == 7);
    for (const auto* feature :
         {"playing backwards", "playing while a pointer is over it", "a pause between plays",
          "a number of plays", "speed of -2", "themes", "state machines"}) {
        CAPTURE(feature);
        CHECK(reports(losses, feature));
    }
    CHECK(reports(
        read({{"manifest.json", R"({"states":["s"],"animations":[{"id":"a"}]})"}, {"animations/a.json", ""}})
            .losses,
        "state machines"));
}

TEST_CASE("a manifest of other types does no harm")
{
    for (const auto* manifest :
         {R"({"animations":7})", R"({"animations":[7,null,"a",[]]})", R"({"animations":{"id":"a"}})",
          R"({"initial":[],"themes":{},"animations":[{"id":8}]})",
          R"({"animations":[{"id":"a","loop":"yes"}]})"}) {
        CAPTURE(manifest);
        CHECK(read({{"manifest.json", manifest}, {"a/a.json", "x"}}).animation.text == "x");
    }
}
