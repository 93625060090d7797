#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

const std::string dot = "\nsymbol dot { object o fill=red { rect -1 -1 2 2 } }";
const std::string tick = "\nsymbol tick { line 0 -4 0 -2 }";

}

TEST_CASE("a use with a count is a group of copies, each a step further")
{
    CHECK(items_read("use dot 10 20 count=3 x-step=4 y-step=-2.5" + dot) ==
          "group x[160] y[320]\n  use dot\n  use dot x[64] y[-40]\n  use dot x[128] y[-80]");
    CHECK(items_read("use dot count=3 rotate-step=-120 scale-step=0.5" + dot) ==
          "group\n  use dot\n  use dot rotation[-21845] scale_x[2048] scale_y[2048]\n"
          "  use dot rotation[-43691] scale_x[1024] scale_y[1024]");
    CHECK(items_read("use dot count=1" + dot) == "group\n  use dot");
}

TEST_CASE("opacities add up within 0 and 1")
{
    CHECK(
        items_read("use dot count=4 opacity=0.5 opacity-step=-0.4" + dot) ==
        "group opacity[128]\n  use dot\n  use dot opacity[153]\n  use dot opacity[51]\n  use dot opacity[0]");
}

TEST_CASE("copies turn about the pivot of their use, whose keys move them all")
{
    CHECK(items_read("use dot count=2 rotate-step=90 pivot-x=3 { key 0 y=0; key 9 y=5 }" + dot) ==
          "group y[0:0 9:80] pivot_x[48]\n  use dot pivot_x[48]\n  use dot rotation[16384] pivot_x[48]");
}

TEST_CASE("copies go along the palette, and what it does not name stays")
{
    const SceneText read = read_on_canvas(
        "palette { a \"#100000\"; b \"#200000\"; c \"#300000\" }\nuse s count=4 colour-step=2\n"
        "symbol s { object o fill=b stroke=lime { rect 0 0 2 2; key 0 fill=b; key 5 fill=c } }");
    CAPTURE(read.findings);
    REQUIRE(read.scene);
    const scene::Scene& scene = *read.scene;
    REQUIRE(scene.symbols.size() == 3); // the fourth copy has the colours of the first
    const auto red_of = [&scene](std::size_t symbol) {
        const auto& object = std::get<scene::Object>(scene.symbols[symbol].items[0].content);
        CHECK(scene.palette[object.stroke->colour].green == 255);
        return scene.palette[*object.fill].red;
    };
    CHECK(red_of(0) == 0x20);
    CHECK(red_of(1) == 0x10);
    CHECK(red_of(2) == 0x30);
    const scene::Track& fill = scene.symbols[1].items[0].tracks.front();
    CHECK(scene.palette[static_cast<std::size_t>(fill.keys[1].value)].red == 0x20);
    const auto& copies = std::get<scene::Group>(scene.items[0].content).items;
    CHECK(std::get<scene::Use>(copies[3].content).symbol == std::get<scene::Use>(copies[0].content).symbol);
}

TEST_CASE("copies with a step of delay have a time each, in a scene long enough for the last")
{
    const SceneText read = read_on_canvas("use s count=3 delay=1 delay-step=4\nsymbol s { object o "
                                          "fill=red { rect 0 0 2 2; key 0 x=0; key 6 x=1 } }");
    CAPTURE(read.findings);
    REQUIRE(read.scene);
    const scene::Scene& scene = *read.scene;
    REQUIRE(scene.clocks.size() == 3);
    CHECK(scene.clocks[0].delay == Time::frame(1));
    CHECK(scene.clocks[2].delay == Time::frame(9));
    CHECK(scene.length == Time::frame(15));
}

TEST_CASE("among shapes, copies are strokes of one drawing")
{
    CHECK(drawn("use tick 10 10 count=2 rotate-step=90 }" + tick + "\nobject p fill=red { rect 0 0 1 1")
              .starts_with("M 10 6 L 10 8 M 14 10 L 12 10"));
    CHECK(
        drawn("use tick 10 10 count=3 scale-step=2 x-step=1 }" + tick + "\nobject p fill=red { rect 0 0 1 1")
            .starts_with("M 10 6 L 10 8 M 11 2 L 11 6 M 12 -6 L 12 2"));
}

TEST_CASE("what is wrong with copies is told")
{
    CHECK(items_read("use dot x-step=1" + dot) ==
          "1:9 error: x-step is that from one copy to the next, and there is one (add count=…)");
    CHECK(items_read("use dot count=0" + dot)
              .starts_with("1:15 error: this number is out of range (allowed: 1 to 1000)"));
    CHECK(items_read("use dot count=3 x-step=1500" + dot) ==
          "1:9 error: the copy with the number 3 is more than 2047 px away, or more than 64 times as large "
          "(take smaller steps, or fewer copies)");
    CHECK(items_read("use dot count=9 scale-step=2" + dot)
              .starts_with("1:9 error: the copy with the number 8 is"));
    CHECK(items_read("use dot count=1000 delay-step=900000" + dot) ==
          "1:9 error: the delay of the copy with the number 3 is more than 1000000 frames "
          "(take a smaller delay-step, or fewer copies)");
    CHECK(items_read("use dot count=2 colour-step=1" + dot)
              .starts_with("1:29 error: these are steps along the palette, and this scene has none"));
    CHECK(items_read("object o fill=red { use tick count=2 opacity-step=-0.1 }" + tick)
              .find("use has no property \"opacity-step\"") != std::string::npos);
    CHECK(drawn("use tick count=1000 rotate-step=0.3; circle 5 5 r=2 }" + tick +
                "\nobject p fill=red { rect 0 0 1 1")
              .find("error") == std::string::npos);
    std::string many =
        "symbol s { object o fill=red { rect 0 0 2 2; key 0 x=0; key 6 x=1 } }\nuse s count=300 delay-step=1";
    CHECK(items_read(many).starts_with("2:1 error: a scene holds at most 223 different times of their own"));
}

}
