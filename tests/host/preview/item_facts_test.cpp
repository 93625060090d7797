#include "host/preview/playback/item_facts.hpp"

#include "host/preview/overlay/overlay_source.hpp"
#include "host/walk/every_item.hpp"
#include "tests/host/preview/named_scene.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

constexpr const char* moving = R"kfast(kfast 1
canvas 100 60 frames=40
input gaze min=-1 max=1
bones arm { bone upper 20 20 30 20; pose 0 rest; pose 12 { upper turn=20 } }
object ball x=4 scale=1.5 fill="#ff0000" stroke=white width=2 {
    key 0 law=accelerate { rect 0 0 8 8 }
    key 20 { rect 0 0 16 8 }
    track y law=constant { at 0 10 law="bezier(0.42,0,0.58,1)"; at 10 30 law=hold; at 40 50 }
    track opacity input=gaze { at -1 0; at 1 1 }
}
group pair { key 0 scale=1 rotate=0; key 40 scale=2 rotate=90
    object sleeve fill=blue skin=arm bone=upper { rect 20 18 10 4 }
}
)kfast";

struct Facts {
    ItemFacts of(const char* name, Time moment) { return source.facts(moment, scene.number(name)); }

    NamedScene scene{moving};
    OverlaySource source{{scene.view(), {100, 60}}};
};

/// "x 4, y 10"
std::string in_words(const std::vector<ItemValue>& values)
{
    std::string words;
    for (const ItemValue& value : values)
        words += (words.empty() ? "" : ", ") + value.name + (value.has_keys ? "* " : " ") + value.value;
    return words;
}
}

TEST_CASE("values are those of the moment, in the units of the scene language; those with keys stand out")
{
    Facts facts;
    CHECK(in_words(facts.of("ball", Time::frame(0)).values) ==
          "x 4, y* 10, scale 1.5, rotate 0, opacity* 0.5, pivot-x 4, pivot-y 4, fill #ff0000, stroke "
          "#ffffff, width 2");
    CHECK(in_words(facts.of("ball", Time::frame(5)).values).find("y* 20, ") != std::string::npos);
    CHECK(in_words(facts.of("ball", Time::frame(20)).values).find("y* 30, ") != std::string::npos);
    CHECK(in_words(facts.of("pair", Time::frame(20)).values) ==
          "x 0, y 0, scale* 1.5, rotate* 45, opacity 1");
    facts.source.set_input(0, whole_input);
    CHECK(in_words(facts.of("ball", Time::frame(0)).values).find("opacity* 1, ") != std::string::npos);
    CHECK(facts.source.facts({}, 99).values.empty());
}

TEST_CASE("the keys around a moment have their values and laws, with the numbers of a bezier")
{
    Facts facts;
    const ItemFacts ball = facts.of("ball", Time::frame(5));
    REQUIRE(ball.ways.size() == 3);
    CHECK(ball.ways[0].name == "shape");
    CHECK(ball.ways[0].begin == "0: accelerate");
    CHECK(ball.ways[0].end == "20");
    CHECK(ball.ways[1].name == "y");
    CHECK(ball.ways[1].begin == "0: 10, bezier(0.42,0,0.58,1)");
    CHECK(ball.ways[1].end == "10: 30, hold");
    CHECK(ball.ways[2].name == "opacity by gaze");
    CHECK(ball.ways[2].begin.starts_with("-1: 0, "));
    CHECK(ball.ways[2].end == "1: 1");
    const ItemFacts late = facts.of("ball", Time::frame(40));
    CHECK(late.ways[1].begin == "40: 50");
    CHECK(late.ways[1].end.empty());
}

TEST_CASE("bones are a quantity of what they carry, and two scales that are one have one name")
{
    const NamedScene scene{moving};
    std::vector<std::string> names;
    every_item(scene.view(), [&](const ItemView& item) {
        for (const Quantity& quantity : quantities_of(scene.view(), item))
            names.push_back(quantity.name);
    });
    CHECK(names == std::vector<std::string>{"shape", "y", "opacity", "rotate", "scale", "shape", "bones"});
}
}
