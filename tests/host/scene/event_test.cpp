#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

SceneText read_events(const std::string& loop, const std::string& nodes)
{
    return read("kfast 1; canvas 9 9 frames=60 loop=" + loop + "\n" + nodes);
}

}

TEST_CASE("events are named moments, sorted by time; those of one time keep their order")
{
    const auto [scene, findings] =
        read_events("once", "event 40 step\nevent 60 end\nevent 40 blink\nevent (s)1 step\nevent 0 begin");
    REQUIRE(scene);
    CHECK(findings == "");
    std::string all;
    for (const scene::Event& event : scene->events)
        all += std::to_string(event.time.ticks / 1024) + ' ' + event.name + ' ';
    CHECK(all == "0 begin 30 step 40 step 40 blink 60 end ");
}

TEST_CASE("an event at the end of a scene that repeats gets a warning")
{
    CHECK(read_events("repeat", "event 60 end").findings ==
          "2:7 warning: a scene that repeats never shows its end, so this event comes with its beginning "
          "(put it at 0, unless it is meant to come just before what stands there)");
    CHECK(read_events("ping-pong", "event 60 end").findings == "");
    CHECK(read_events("repeat", "event 59.999 end").findings == "");
}

TEST_CASE("an event with mistakes")
{
    CHECK(read_events("once", R"(event 1 "two\nlines")").findings ==
          "2:9 error: a name has no line ends or other control characters");
    CHECK(read_events("once", "event 60.001 late").findings ==
          "2:7 error: this event comes after the scene, which ends at frame 60 "
          "(choose an earlier time, or make the scene longer with frames=…)");
    CHECK(read_events("once", "event -1 early").findings == "2:7 error: a time cannot be negative");
    CHECK(read_events("once", "event step 40").findings ==
          "2:7 error: a number is expected here\n2:12 error: a word or a text in quotes is expected here");
    CHECK(read_events("once", "event 40").findings ==
          "2:1 error: event needs more values (write event TIME NAME)");
    CHECK(read_events("once", "event 40 \"\"").findings == "2:10 error: a name cannot be empty");
    CHECK(read_events("once", "event 40 a loop=once").findings ==
          "2:12 error: event has no property \"loop\" (nothing is allowed here)");
}

}
