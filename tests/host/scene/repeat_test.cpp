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
    CHECK(items_read("use dot count=4 opacity=0.5 opacity-step=-0.4" + dot)
              .starts_with(
                  "group opacity[128]\n  use dot\n  use dot opacity[153]\n  use dot opacity[51]\n  use dot "
                  "opacity[0]\n"));
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

TEST_CASE("copies of which nothing is seen are told")
{
    CHECK(
        items_read("use dot count=9 opacity-step=-0.25" + dot)
            .ends_with("1:17 warning: with this opacity-step nothing is seen of the copies from number 5 on: "
                       "their opacity is 0 (write count=4, or a step nearer to 0)"));
    CHECK(items_read("use dot count=4 opacity-step=-0.25" + dot).find("warning") == std::string::npos);
    CHECK(
        items_read("use dot count=20 scale-step=0.5" + dot)
            .ends_with("1:18 warning: with this scale-step nothing is seen of the copies from number 15 on: "
                       "they have shrunk to nothing (write count=14, or a step nearer to 1)"));
    CHECK(drawn("use tick count=20 scale-step=0; circle 5 5 r=2 }" + tick +
                "\nobject p fill=red { rect 0 0 1 1")
              .find("from number 2 on") != std::string::npos);
}

TEST_CASE("a step along the palette needs a colour that it names")
{
    const std::string palette = "palette { a \"#ff0000\"; b \"#00ff00\" }\n";
    const auto warns = [&](const std::string& items) {
        return read_on_canvas(palette + items)
                   .findings.find("colour-step does nothing: the symbol has no "
                                  "colour that the palette names") != std::string::npos;
    };
    CHECK(warns("symbol s { object o fill=white { rect 0 0 9 9 } }\nuse s count=3 colour-step=1"));
    CHECK(warns("symbol s { object o fill=white { rect 0 0 9 9 } }\nsymbol t { use s; use s 9 9 }\n"
                "use t count=3 colour-step=1"));
    CHECK_FALSE(warns("symbol s { object o fill=white { rect 0 0 9 9 } }\nuse s count=3 colour-step=0"));
    CHECK_FALSE(warns("symbol s { object o stroke=a { rect 0 0 9 9 } }\nsymbol t { group { use s } }\n"
                      "use t count=3 colour-step=1"));
    CHECK_FALSE(warns("symbol s { object o fill=white { rect 0 0 9 9; key 0; key 9 fill=b } }\n"
                      "use s count=3 colour-step=1"));
}

TEST_CASE("too many colours of symbols in each other are one error")
{
    std::string text = "palette {";
    for (int i = 1; i <= 200; ++i)
        text += " c" + std::to_string(i) + " \"#" + std::to_string(100 + i) + "000\";";
    text += " }\nsymbol a { object o fill=c1 { circle 0 0 r=5 } }\n"
            "symbol b { use a count=200 colour-step=1 }\nsymbol c { use b count=200 colour-step=1 }\n"
            "use c count=200 colour-step=1";
    const std::string findings = read_on_canvas(text).findings;
    CHECK(findings.find("a scene uses at most 255 symbols that hold items (each other time, and each step of "
                        "colours, counts as one)") != std::string::npos);
    CHECK(findings.find('\n') == std::string::npos);
}

TEST_CASE("what is wrong with copies is told")
{
    CHECK(items_read("use dot x-step=1" + dot) ==
          "1:9 error: x-step is that from one copy to the next, and there is only one copy (add count=…)");
    CHECK(items_read("use dot count=0" + dot)
              .starts_with("1:15 error: this number is out of range (allowed: 1 to 1000)"));
    CHECK(items_read("use dot count=3 x-step=1500" + dot) ==
          "1:17 error: with this x-step the copy with the number 3 is more than 2047 px away "
          "(take a smaller step, or fewer copies)");
    CHECK(items_read("use dot count=3 x-step=1 y-step=-1500" + dot)
              .starts_with("1:26 error: with this y-step the copy with the number 3 is"));
    CHECK(items_read("use dot count=50 scale-step=64" + dot).find("shrunk") == std::string::npos);
    CHECK(items_read("use dot count=9 scale-step=2 x-step=3" + dot) ==
          "1:17 error: with this scale-step the copy with the number 8 is more than 64 times as large "
          "(take a smaller step, or fewer copies)");
    CHECK(items_read("use dot count=3000 x-step=1" + dot).find("only one copy") == std::string::npos);
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
