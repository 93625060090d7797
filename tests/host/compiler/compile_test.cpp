#include "host/compiler/compile.hpp"

#include "core/player.hpp"
#include "tests/compiled.hpp"

#include <doctest/doctest.h>
#include <string>

namespace kfast::test {
namespace {

std::string with_object(const std::string& object) { return "kfast 1\ncanvas 64 64\n" + object; }

}

TEST_CASE("a drawing that is shown again is stored once, also in another object")
{
    const std::string shape = "{ path \"M 1 1 C 9 1 1 9 9 9 L 40 3 30 33 12 60 Z\" }";
    const auto once = compiled(with_object("object a fill=white { key 0 " + shape + " }")).size();
    const auto again =
        compiled(with_object("object a fill=white { key 0 " + shape + "; key 9 " + shape + " }")).size();
    CHECK(again == once + 4); // key times in place of the usual ones
    const auto twice = compiled(with_object("object a fill=white { key 0 " + shape + " }\n" +
                                            "object b fill=white { key 0 " + shape + " }"))
                           .size();
    CHECK(twice == once + 4); // style, colour, key times, drawing
}

TEST_CASE("times of every kind come back as they were written")
{
    const auto bytes =
        compiled("kfast 1\ncanvas 8 8 fps=25\nobject a fill=white { key 0.5 { rect 0 0 1 1 }; "
                 "key (s)1 { rect 0 0 2 1 }; key (ms)1500 { rect 0 0 3 1 }; key 1000000 { empty } }");
    const SceneView scene = *SceneView::parse(bytes);
    KeyCursor keys = scene.items().next().object.keys();
    CHECK(keys.next().time.ticks == 512);
    CHECK(keys.next().time == Time::frame(25));
    CHECK(keys.next().time.ticks == 37 * 1024 + 512);
    CHECK(keys.next().time == Time::frame(1'000'000));
    CHECK(keys.at_end());
}

TEST_CASE("whatever compiles can be parsed and played")
{
    const auto bytes =
        compiled(with_object("object a stroke=white width=200 cap=round join=round { key 0 { path "
                             "\"M -2047 -2047 C 2047 -2047 -2047 2047 2047 2047\" }; key 1 { empty } }"));
    const auto scene = SceneView::parse(bytes);
    REQUIRE(scene);
    std::vector<std::byte> block(Player::block_bytes(*scene, {4, 4}));
    CHECK(Player::create(*scene, {4, 4}, Fit::cover, block));
}

TEST_CASE("a syntax error is reported without errors that only follow from it")
{
    Diagnostics diagnostics;
    const SourceText source{"s.kfast", "kfast 1\ncanvas 64 64 fps=\nobject a fill=nothing { circle 1 1 }\n"};
    CHECK(!compile(source, diagnostics));
    CHECK(diagnostics.sorted().size() == 1);
}

}
