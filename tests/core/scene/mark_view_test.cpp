#include "core/scene/scene_view.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/bytes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("clips are read in their order, and what follows are the events")
{
    const auto marks = bytes({3, 'o', 'n', 'e', 4, 20, 0, // frames 2 … 12
                              2, 0xC3, 0xB6, 3, 7, 2,     // "ö": ticks 1 … 4
                              6, 1, 'e'});
    ClipCursor clips{ByteReader{marks}, 2};
    const ClipView one = clips.next();
    CHECK(one.name == "one");
    CHECK(one.begin == Time::frame(2));
    CHECK(one.end == Time::frame(12));
    CHECK(one.loop == Loop::once);
    CHECK_FALSE(clips.at_end());
    const ClipView two = clips.next();
    CHECK(two.name == "\xC3\xB6");
    CHECK(two.begin == Time{1});
    CHECK(two.end == Time{4});
    CHECK(two.loop == Loop::ping_pong);
    CHECK(clips.at_end());
    CHECK(clips.rest().left() == 3);

    EventCursor events{clips.rest()};
    const EventView event = events.next();
    CHECK(event.name == "e");
    CHECK(event.time == Time::frame(3));
    CHECK(events.at_end());
    CHECK_FALSE(events.overrun());
}

TEST_CASE("each event counts its time from the one before")
{
    const auto marks = bytes({6, 1, 'a', 0, 1, 'b', 2, 1, 'c', 11, 1, 'd'});
    EventCursor events{ByteReader{marks}};
    CHECK(events.next().time == Time::frame(3));
    CHECK(events.next().time == Time::frame(3));
    CHECK(events.next().time == Time::frame(4));
    const EventView last = events.next();
    CHECK(last.name == "d");
    CHECK(last.time == Time{4 * 1024 + 5});
    CHECK(events.at_end());
}

TEST_CASE("marks that break off are noticed")
{
    const auto event = bytes({6, 5, 'a', 'b'});
    EventCursor events{ByteReader{event}};
    CHECK(events.next().name == "ab");
    CHECK(events.overrun());
    CHECK(events.at_end());

    const auto clip = bytes({1, 'a', 2});
    ClipCursor clips{ByteReader{clip}, 1};
    clips.next();
    CHECK(clips.rest().overrun());
}

TEST_CASE("a sum of two times beyond the limit does not overflow")
{
    const auto clip = bytes({1, 'a', 0xFF, 0xFF, 0xFF, 0xFF, 0x0F, 0xFF, 0xFF, 0xFF, 0xFF, 0x0F, 0});
    const ClipView view = ClipCursor{ByteReader{clip}, 1}.next();
    CHECK(view.end.ticks == 2 * (kfb::max_time + 1));
}

}
