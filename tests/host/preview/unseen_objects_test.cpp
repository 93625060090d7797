#include "host/preview/overlay/unseen_objects.hpp"

#include "tests/host/preview/named_scene.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// "moon: hidden\n" for each.
std::string unseen(const std::string& items, int frames = 20)
{
    const NamedScene scene{"kfast 1\ncanvas 100 100 fps=10 frames=" + std::to_string(frames) + '\n' + items};
    std::string list;
    for (const UnseenObject& object : unseen_objects(scene.view()))
        list += scene.names()[object.number] + (object.is_hidden ? ": hidden\n" : ": not there\n");
    return list;
}

}

TEST_CASE("what stands on the canvas once is seen")
{
    CHECK(unseen("object a fill=red { rect 0 0 9 9 }").empty());
    CHECK(unseen("object a fill=red { key 0 { rect 200 0 9 9 }; key 10 { rect 90 0 9 9 } }").empty());
    CHECK(unseen("object a fill=red { key 0 { rect 200 0 9 9 }; key 20 { rect 99 0 9 9 } }").empty());
    CHECK(unseen("object a fill=red { rect 0 0 9 9; track opacity { at 0 0; at 19 0; at 20 0.5 } }").empty());
}

TEST_CASE("what is outside of the canvas, or has no area, is not there")
{
    CHECK(unseen("object a fill=red { rect 0 0 9 9 }\nobject b fill=red { rect 100 0 9 9 }") ==
          "b: not there\n");
    CHECK(unseen("object a stroke=red { line 5 -5 50 -9 }") == "a: not there\n");
    CHECK(unseen("object a fill=red { line 5 5 50 5 }") == "a: not there\n");
    CHECK(unseen("object a fill=red { rect 0 0 9 9; track x { at 0 -200; at 20 -100 } }") ==
          "a: not there\n");
    CHECK(unseen("object a fill=red { key 0 { empty } }") == "a: not there\n");
}

TEST_CASE("what is transparent or not visible is hidden, by itself or by its group")
{
    CHECK(unseen("object a fill=red opacity=0 { rect 0 0 9 9 }") == "a: hidden\n");
    CHECK(unseen("group visible=#false { object a fill=red { rect 0 0 9 9 } }") == "a: hidden\n");
}

TEST_CASE("an object of a symbol is seen if one use shows it")
{
    const std::string symbol =
        "symbol s { object a fill=red { rect 0 0 9 9 }; object b fill=red { rect 50 0 9 9 } }\n";
    CHECK(unseen(symbol + "use s x=300\nuse s x=60") == "b: not there\n");
    CHECK(unseen(symbol + "use s x=300\nuse s x=40").empty());
}

TEST_CASE("an input may bring it")
{
    const std::string input = "input mood min=0 max=4\n";
    const std::string track =
        "object a fill=red { rect 0 0 9 9; track x input=mood { at 0 -200; at 2 -200; at ";
    CHECK(unseen(input + track + "3 0 } }").empty());
    CHECK(unseen(input + track + "3 -100 } }") == "a: not there\n");
    CHECK(unseen("input pen kind=drawing points=4\nobject a stroke=red live=pen").empty());
}

TEST_CASE("an input may bring it for the shortest way, and together with time")
{
    CHECK(
        unseen(
            "input mood min=0 max=120\nobject a fill=red input=mood { key 0 visible=#false { rect 0 0 9 9 }; "
            "key 118.3 visible=#true { rect 0 0 9 9 }; key 118.6 visible=#false { rect 0 0 9 9 } }")
            .empty());
    CHECK(unseen("input mood min=0 max=120\nobject a fill=red { rect 0 0 9 9; track x input=mood { at 50 "
                 "-200; at 51 "
                 "200 } }")
              .empty());
    const std::string lamp =
        "input mood min=0 max=120\ngroup lamp { key 0 visible=#false; key 611 visible=#true; "
        "key 614 visible=#false; object a fill=red { rect 0 0 9 9; track x input=mood { at 0 -99; ";
    CHECK(unseen(lamp + "at 110 -99; at 111 0; at 112 -99 } } }", 1000).empty());
    CHECK(unseen(lamp + "at 120 -99 } } }", 1000) == "a: not there\n");
}

TEST_CASE("a scene of more than five thousand frames is not looked at")
{
    CHECK(unseen("object a fill=red { rect 200 0 9 9 }", 4999) == "a: not there\n");
    CHECK(unseen("object a fill=red { rect 200 0 9 9 }", 5001).empty());
    CHECK(unseen("object a fill=red { rect 200 0 9 9 }", 1'000'000).empty());
}

}
