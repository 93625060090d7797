#include "host/walk/scene_clocks.hpp"

#include "host/walk/key_times.hpp"
#include "tests/compiled.hpp"

#include <cstdint>
#include <doctest/doctest.h>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::int32_t frame = Time::ticks_per_frame;

/// A scene of 40 frames with a symbol of 8, and what uses it.
std::vector<std::byte> scene_of(const std::string& uses)
{
    return compiled("kfast 1\ncanvas 99 99 frames=40\nsymbol s frames=8 {\n"
                    "    object o fill=red { key 0 { rect 0 0 9 9 }; key 3 { rect 5 5 9 9 } }\n}\n" +
                    uses);
}

std::vector<double> shown_frames(const std::string& uses)
{
    const auto bytes = scene_of(uses);
    std::vector<double> frames;
    for (const Time time : shown_key_times(*SceneView::parse(bytes)))
        frames.push_back(static_cast<double>(time.ticks) / frame);
    return frames;
}

}

TEST_CASE("keys of a symbol with a time of its own are where the scene first comes to them")
{
    CHECK(shown_frames("use s delay=2 loop=repeat") == std::vector<double>{2, 5});
    CHECK(shown_frames("use s delay=2 speed=0.5 loop=repeat") == std::vector<double>{2, 8});
    CHECK(shown_frames("use s speed=-1 loop=repeat") == std::vector<double>{5, 8});
    CHECK(shown_frames("use s delay=-20 loop=repeat") == std::vector<double>{4, 7});
    CHECK(shown_frames("use s delay=-8 loop=repeat") == std::vector<double>{0, 3});
    CHECK(shown_frames("use s delay=-8 loop=ping-pong") == std::vector<double>{8, 11});
    CHECK(shown_frames("use s delay=39 loop=repeat") == std::vector<double>{39});
}

TEST_CASE("what clocks first come to, they show then and not a tick before")
{
    const auto bytes = scene_of("symbol t frames=20 { use s delay=3 speed=1.5 loop=ping-pong }\n"
                                "use t delay=1 speed=0.75 loop=repeat\nuse s speed=-2 delay=4 loop=once\n");
    const SceneClocks clocks{*SceneView::parse(bytes)};
    REQUIRE(clocks.count() == 3);
    for (std::size_t clock = 0; clock < clocks.count(); ++clock)
        for (std::int32_t ticks = 1; ticks <= clocks[clock].length.ticks; ticks += 1 + ticks / 3) {
            CAPTURE(clock);
            CAPTURE(ticks);
            const auto at = clocks.first_at(clock, {ticks});
            if (!at)
                continue;
            const bool is_backwards = clocks[clock].speed < 0;
            const auto has_come = [&](std::int32_t time) {
                const std::int32_t shown = clocks.at({time})[clock].ticks;
                return is_backwards ? shown <= ticks : shown >= ticks;
            };
            CHECK(has_come(at->ticks));
            CHECK_FALSE((at->ticks > 0 && ticks != clocks[clock].length.ticks && has_come(at->ticks - 1)));
        }
    CHECK_FALSE(clocks.first_at(0, {clocks[0].length.ticks + 1}));
}

TEST_CASE("a clock that goes by another goes by the scene's time in the end")
{
    const auto bytes =
        scene_of("symbol t frames=20 { use s delay=3 loop=repeat }\nuse t delay=1 loop=repeat\n");
    const SceneClocks clocks{*SceneView::parse(bytes)};
    REQUIRE(clocks.count() == 2);
    CHECK(clocks.root_of(1) == 0);
    CHECK(clocks.root_of(0) == 0);
}

}
