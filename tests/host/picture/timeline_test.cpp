#include "host/picture/timeline.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace kfast::test {

TEST_CASE("a scene has the frames 0 to L-1, for once also L")
{
    CHECK(Timeline{30000, {{}, Time::frame(10), Loop::repeat}}.frame_count() == 10);
    CHECK(Timeline{30000, {{}, Time::frame(10), Loop::ping_pong}}.frame_count() == 10);
    CHECK(Timeline{30000, {{}, Time::frame(10), Loop::once}}.frame_count() == 11);
    CHECK(Timeline{30000, {{}, Time::frame(10), Loop::once}}.frame_time(10) == Time::frame(10));
}

TEST_CASE("a length between frames counts the frame that has begun; once ends at exactly L")
{
    const Time length{2 * Time::ticks_per_frame + 512};
    CHECK(Timeline{30000, {{}, length, Loop::repeat}}.frame_count() == 3);
    const Timeline once{30000, {{}, length, Loop::once}};
    CHECK(once.frame_count() == 4);
    CHECK(once.frame_time(2) == Time::frame(2));
    CHECK(once.frame_time(3) == length);
}

TEST_CASE("what is shown follows the loop mode")
{
    const std::int64_t frame = Time::ticks_per_frame;
    const Timeline repeat{30000, {{}, Time::frame(10), Loop::repeat}};
    CHECK(repeat.shown_at(10 * frame) == Time{0});
    CHECK(repeat.shown_at(23 * frame) == Time::frame(3));
    const Timeline once{30000, {{}, Time::frame(10), Loop::once}};
    CHECK(once.shown_at(10 * frame) == Time::frame(10));
    CHECK(once.shown_at(23 * frame) == Time::frame(10));
    const Timeline there_and_back{30000, {{}, Time::frame(10), Loop::ping_pong}};
    CHECK(there_and_back.shown_at(10 * frame) == Time::frame(10));
    CHECK(there_and_back.shown_at(11 * frame) == Time::frame(9));
    CHECK(there_and_back.shown_at(20 * frame) == Time{0});
}

TEST_CASE("the longest ping-pong scene does not overflow")
{
    const Timeline longest{30000, {{}, {1'000'000 * 1024}, Loop::ping_pong}};
    CHECK(longest.period_ticks() == 2'048'000'000);
    CHECK(longest.shown_at(2'048'000'000 + 5).ticks == 5);
    CHECK(longest.frame_count() == 1'000'000);
}

TEST_CASE("seconds follow from the frame rate")
{
    CHECK(Timeline{25000, {{}, Time::frame(50), Loop::once}}.seconds(50 * 1024) == doctest::Approx(2.0));
    CHECK(Timeline{23976, {{}, Time::frame(1), Loop::once}}.seconds(23976 * 1024) == doctest::Approx(1000.0));
}

TEST_CASE("a clip has the frames from its beginning on")
{
    const Timeline clip{30000, {{1500}, {1500 + 2500}, Loop::once}};
    CHECK(clip.frame_count() == 4);
    CHECK(clip.frame_time(0) == Time{1500});
    CHECK(clip.frame_time(2) == Time{1500 + 2048});
    CHECK(clip.frame_time(3) == Time{1500 + 2500});
}

TEST_CASE("a speed changes the number of frames and their times")
{
    const PlayRange ten{{}, Time::frame(10), Loop::repeat};
    const Timeline half{30000, ten, Playhead::as_authored / 2};
    CHECK(half.frame_count() == 20);
    CHECK(half.frame_time(3).ticks == 1536);
    CHECK(half.period_ticks() == 20 * 1024);
    const Timeline three{30000, ten, 3 * Playhead::as_authored};
    CHECK(three.frame_count() == 4);
    CHECK(three.frame_time(3) == Time::frame(9));
    CHECK(three.period_ticks() == 3414); // 3413.3
}

TEST_CASE("backwards goes from the end to the beginning; repeat begins at what looks like its end")
{
    const auto frames = [](Loop loop) {
        const Timeline timeline{30000, {Time::frame(2), Time::frame(5), loop}, -Playhead::as_authored};
        std::vector<int> list;
        list.reserve(static_cast<std::size_t>(timeline.frame_count()));
        for (int frame = 0; frame < timeline.frame_count(); ++frame)
            list.push_back(timeline.frame_time(frame).ticks / Time::ticks_per_frame);
        return list;
    };
    CHECK(frames(Loop::once) == std::vector{5, 4, 3, 2});
    CHECK(frames(Loop::repeat) == std::vector{2, 4, 3});
    CHECK(frames(Loop::ping_pong) == std::vector{5, 4, 3});
}

}
