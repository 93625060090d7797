#include "host/simulator/simulated_board.hpp"

#include "firmware/settings/controller_facts.hpp"
#include "host/picture/player_source.hpp"
#include "tests/compiled.hpp"

#include <doctest/doctest.h>

#include <random>
#include <vector>

namespace kfast::test {

TEST_CASE("after any leaps through a scene the panel shows what a full redraw would")
{
    const std::vector<std::byte> bytes = compiled(R"(
kfast 1
canvas 128 64 fps=24 frames=48 background="#203040"
object dish fill="#406080" { circle 30 32 r=20.5 }
object morph fill=white stroke=black width=3 {
    key 0 law=accelerate { circle 30 30 r=12 }
    key 20 { rect 70 10 20 30; circle 110 50 r=9.25 }
    key 47 { star 64 32 points=5 r=30 inner=12 }
}
group opacity=0.5 {
    key 0 opacity=0; key 12 opacity=0.7; key 30 opacity=1; key 40 opacity=0
    object a fill=red { key 0 x=0; key 47 x=60; rect 4 40 30 20 }
    object b stroke=white width=2 { line 0 63 127 0 }
})");
    const auto on_board = open_board_source(bytes, facts_of(Controller::ssd0323).default_value);
    PlayerSource drawn{*SceneView::parse(bytes), {128, 64}, Fit::contain, PixelFormat::grey4};
    std::minstd_rand random{5};
    std::int32_t tick = 0;
    for (int i = 0; i < 400; ++i) {
        tick = i % 3 == 0 ? static_cast<std::int32_t>(random() % (48 * 1024)) : tick + 300;
        CAPTURE(tick);
        REQUIRE(on_board->show({tick}).pixels == drawn.show({tick}).pixels);
    }
}

}
