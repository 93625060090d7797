#include "core/player.hpp"

#include "core/time/clock.hpp"
#include "tests/core/player_fixture.hpp"

#include <doctest/doctest.h>
#include <string>

namespace kfast::test {
namespace {

const std::string head = "kfast 1\ncanvas 60 40 fps=30 frames=90\n";
const std::string blink =
    "{\n"
    "object eye fill=white { key 0 law=ease { ellipse 12 12 rx=9 ry=9 }; key 7 { ellipse 12 12 rx=9 ry=1 };"
    " key 16 { ellipse 12 12 rx=9 ry=9 } }\n"
    "object lash stroke=red width=2 { line 4 4 20 4; track rotate { at 2 0; at 9 90; at 14 0 } }\n}\n";

/// Whether a scene in which the symbol has a time of its own shows at every time what one shows where it runs
/// on the time of the scene, at the time of the clock.
bool shows_by_clock(const std::string& symbol_and_use, const Clock& clock)
{
    const Size panel{60, 40};
    PlayerFixture timed{head + symbol_and_use, panel};
    PlayerFixture plain{head + "symbol s " + blink + "use s 8 6", panel};
    // Not in the order of time: nothing depends on the pictures before.
    for (std::int32_t i = 0; i < 90 * 4; ++i) {
        const Time time{i * 37 % (90 * 4) * 256};
        if (timed.picture(time) != plain.picture(clock.at(time)))
            return false;
    }
    return true;
}

}

TEST_CASE("what has a time of its own is drawn as its clock says")
{
    constexpr std::int32_t normal = Clock::normal_speed;
    CHECK(shows_by_clock("symbol s frames=20 " + blink + "use s 8 6",
                         {.loop = Loop::repeat, .length = Time::frame(20)}));
    CHECK(shows_by_clock("symbol s loop=ping-pong " + blink + "use s 8 6 delay=11",
                         {.delay = Time::frame(11), .loop = Loop::ping_pong, .length = Time::frame(16)}));
    CHECK(shows_by_clock("symbol s " + blink + "use s 8 6 delay=-4 speed=0.25",
                         {.delay = Time::frame(-4), .speed = normal / 4}));
    CHECK(shows_by_clock("symbol s " + blink + "use s 8 6 speed=-2 loop=repeat",
                         {.speed = -2 * normal, .loop = Loop::repeat, .length = Time::frame(16)}));
    CHECK(shows_by_clock("symbol s frames=10 " + blink + "use s 8 6 loop=once",
                         {.loop = Loop::once, .length = Time::frame(10)}));
}

TEST_CASE("times of their own run within each other")
{
    const std::string nested =
        "symbol s frames=16 " + blink + "symbol outer frames=40 { use s 8 6 delay=3 }\n";
    const Clock outer{.speed = Clock::normal_speed / 2, .loop = Loop::repeat, .length = Time::frame(40)};
    const Clock inner{.delay = Time::frame(3), .loop = Loop::repeat, .length = Time::frame(16)};
    const Size panel{60, 40};
    PlayerFixture timed{head + nested + "use outer speed=0.5", panel};
    PlayerFixture plain{head + "symbol s " + blink + "use s 8 6", panel};
    for (std::int32_t i = 0; i < 90 * 2; ++i) {
        const Time time{i * 512};
        CAPTURE(i);
        REQUIRE(timed.picture(time) == plain.picture(inner.at(outer.at(time))));
    }
}

TEST_CASE("a drawing and the bones that carry it have the time of their use")
{
    const std::string bones =
        "bones arm { bone upper 8 20 30 20; pose 0 rest; pose 8 { upper turn=60 }; pose 16 rest }\n";
    const std::string limb = "{ object limb stroke=white width=4 skin=arm { line 8 20 20 20 30 20 } }\n";
    const std::string drop = " { key 0 { circle 0 0 r=4 }; key 12 { rect -8 -2 16 4 } }\n";
    const Size panel{60, 40};
    PlayerFixture timed{head + bones + "symbol s" + limb + "symbol d" + drop + "use s delay=5 loop=repeat\n" +
                            "object o fill=red { use d 40 30 delay=5 loop=repeat }\nobject still stroke=lime "
                            "skin=arm { line 8 30 30 30 }",
                        panel};
    PlayerFixture plain{
        head + bones + "symbol s" + limb + "symbol d" + drop +
            "use s\nobject o fill=red { use d 40 30 }\nobject still stroke=lime skin=arm { line 8 30 30 30 }",
        panel};
    const auto top = [](const Bytes& picture) {
        return Bytes(picture.begin(), picture.begin() + 2 * 60 * 10);
    };
    for (int frame = 0; frame < 17; ++frame) {
        CAPTURE(frame);
        CHECK(top(timed.picture(Time::frame(frame + 5))) == top(plain.picture(Time::frame(frame % 16))));
    }
    CHECK(timed.scene.records().bones == 2);
}

}
