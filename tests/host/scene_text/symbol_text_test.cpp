#include "tests/host/scene_text/art_parts.hpp"
#include "tests/host/scene_text/written.hpp"

#include <utility>
#include <vector>

namespace kfast::test {
namespace {

using art::Node;
using art::Symbol;
using art::Transform;
using art::Use;

Transform moved(double x, double y)
{
    Transform transform;
    transform.x = {x};
    transform.y = {y};
    return transform;
}

Transform grown(double factor)
{
    Transform transform;
    transform.scale_x = transform.scale_y = {factor};
    return transform;
}

Symbol symbol(std::string name, std::vector<Node> nodes)
{
    return {.name = std::move(name), .frames = 60, .loop = {}, .nodes = std::move(nodes)};
}

/// What stands behind the palette.
std::string with_symbols(std::vector<Symbol> symbols, std::vector<Node> nodes)
{
    art::Document made = document(std::move(nodes));
    made.symbols = std::move(symbols);
    const std::string text = written(made);
    return text.substr(text.find("\n\n", text.find("\npalette")) + 2);
}

}

TEST_CASE("symbols are written once, and uses say where they stand and by what time they go")
{
    Symbol turning = symbol("box", {red_box("box")});
    turning.loop = Loop::ping_pong;
    turning.frames = 15;
    CHECK(with_symbols({turning, symbol("other", {red_box("box")})},
                       {node("a", Use{.symbol = 0}), node("b", Use{.symbol = 1, .delay = 2.5}, moved(30, 0)),
                        node("c", Use{.symbol = 1, .delay = -4, .speed = 0.5})}) ==
          R"(symbol box frames=15 loop=ping-pong {
    object box fill=box { rect 10 10 20 20 }
}
symbol other {
    object box-2 fill=box { rect 10 10 20 20 }
}

use box
use other x=30 delay=2.5
use other delay=-4 speed=0.5
)");
}

TEST_CASE("symbols that nothing uses are not written, nor are uses of what draws nothing")
{
    const std::string text =
        with_symbols({symbol("empty", {}), symbol("of-empty", {node("a", Use{.symbol = 0})}),
                      symbol("unused", {red_box("box")})},
                     {node("b", Use{.symbol = 1}), red_box("box")});
    CHECK(text == "object box fill=box { rect 10 10 20 20 }\n");
}

TEST_CASE("copies have a count and steps, and stand in a group if that turns about another point")
{
    const Use five{.symbol = 0,
                   .copies = {.count = 5, .x = 12, .rotation = -30.5, .scale = 0.9, .opacity = -0.125}};
    Transform about = moved(40, 40);
    about.anchor_x = about.anchor_y = {20};
    about.rotate = rising(0, 90);
    CHECK(with_symbols({symbol("box", {red_box("box")})},
                       {node("around", art::Group{{node("", five)}}, about)}) ==
          R"(symbol box {
    object box fill=box { rect 10 10 20 20 }
}

group around pivot-x=40 pivot-y=40 {
    track rotate law=constant { at 0 0; at 30 90 }
    use box x=20 y=20 count=5 x-step=12 rotate-step=-30.5 scale-step=0.9 opacity-step=-0.125
}
)");
}

TEST_CASE("what is used in large is drawn larger, by a power of two, and shrunk where it is used")
{
    const std::string text =
        with_symbols({symbol("box", {red_box("box")})},
                     {node("a", Use{.symbol = 0}), node("b", Use{.symbol = 0}, grown(3))});
    CHECK(text.find("rect 40 40 80 80") != std::string::npos);
    CHECK(text.find("use box scale=0.25\nuse box scale=0.75\n") != std::string::npos);
}

TEST_CASE("what is far away is shrunk about its middle")
{
    const std::string text = with_symbols({symbol("box", {node("box", filled(box(400, 10, 20, 20)))})},
                                          {node("a", Use{.symbol = 0}, grown(0.9))});
    CHECK(text.find("use box x=-41 y=-2 pivot-x=410 pivot-y=20 scale=0.9\n") != std::string::npos);
}

}
