#include "core/playhead.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/core/played.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace kfast::test {
namespace {

constexpr std::int32_t as_authored = Playhead::as_authored;

constexpr Loop loops[]{Loop::once, Loop::repeat, Loop::ping_pong};

Playhead silent(Time length, Loop loop) { return {{Time{0}, length, loop}, EventCursor{ByteReader{}}}; }

std::vector<int> ticks(Time length, Loop loop, int frames)
{
    Playhead playhead = silent(length, loop);
    std::vector<int> result;
    for (int i = 0; i < frames; ++i) {
        result.push_back(playhead.moment().ticks);
        playhead.advance(Time::ticks_per_frame);
    }
    return result;
}

}

TEST_CASE("repeat shows the end as the beginning")
{
    CHECK(ticks(Time::frame(3), Loop::repeat, 7) == std::vector{0, 1024, 2048, 0, 1024, 2048, 0});
    CHECK(ticks(Time::frame(1), Loop::repeat, 3) == std::vector{0, 0, 0});
}

TEST_CASE("repeat of a length between two frames keeps the pace")
{
    CHECK(ticks({2500}, Loop::repeat, 6) == std::vector{0, 1024, 2048, 572, 1596, 120});
}

TEST_CASE("once stops at exactly its length and holds")
{
    CHECK(ticks(Time::frame(2), Loop::once, 5) == std::vector{0, 1024, 2048, 2048, 2048});
    CHECK(ticks({1500}, Loop::once, 4) == std::vector{0, 1024, 1500, 1500});
}

TEST_CASE("ping-pong shows each end once")
{
    CHECK(ticks(Time::frame(2), Loop::ping_pong, 8) == std::vector{0, 1024, 2048, 1024, 0, 1024, 2048, 1024});
    CHECK(ticks(Time::frame(1), Loop::ping_pong, 4) == std::vector{0, 1024, 0, 1024});
}

TEST_CASE("frames that are left out still pass")
{
    Playhead playhead = silent(Time::frame(5), Loop::repeat);
    playhead.advance(1003 * Time::ticks_per_frame);
    CHECK(playhead.moment() == Time::frame(3));
}

TEST_CASE("the longest scenes and ways do not overflow")
{
    constexpr Time longest{kfb::max_time};
    constexpr std::int64_t longest_way = std::int64_t{1} << 40;
    for (const Loop loop : loops)
        for (const std::int32_t speed : {as_authored, -as_authored, Playhead::fastest, -Playhead::fastest}) {
            const std::int64_t way = longest_way * speed / as_authored;
            const std::int64_t there_and_back = 2 * std::int64_t{longest.ticks};
            const std::int64_t turned = way % there_and_back + (way < 0 ? there_and_back : 0);
            const Time expected = loop == Loop::once ? (speed < 0 ? Time{0} : longest)
                                  : loop == Loop::repeat
                                      ? Time{static_cast<std::int32_t>(turned % longest.ticks)}
                                      : wrap({static_cast<std::int32_t>(turned)}, longest, loop);
            Playhead playhead = silent(longest, loop);
            playhead.set_speed(speed);
            playhead.advance(longest_way);
            CHECK(playhead.moment() == expected);
            Played one_event{{Time{0}, longest, loop}, {{"x", longest}}};
            one_event->set_speed(speed);
            one_event->advance(longest_way);
            CHECK(one_event->moment() == expected);
        }
}

TEST_CASE("a speed carries its fractions along: a third of the way is a third, however it is divided")
{
    Playhead playhead = silent(Time::frame(1000), Loop::once);
    playhead.set_speed(as_authored / 3); // 21845/65536
    for (int i = 0; i < 65536; ++i)
        playhead.advance(3);
    CHECK(playhead.moment().ticks == 3 * 21845);
}

TEST_CASE("a negative speed runs backwards, 0 stands")
{
    Playhead playhead = silent(Time{10}, Loop::once);
    playhead.seek(Time{9});
    playhead.set_speed(-2 * as_authored);
    playhead.advance(3);
    CHECK(playhead.moment() == Time{3});
    CHECK_FALSE(playhead.finished());
    playhead.set_speed(0);
    playhead.advance(1000);
    CHECK(playhead.moment() == Time{3});
    playhead.set_speed(-as_authored);
    playhead.advance(3);
    CHECK(playhead.moment() == Time{0});
    CHECK(playhead.finished());
    playhead.set_speed(as_authored);
    CHECK_FALSE(playhead.finished());
    playhead.advance(11);
    CHECK(playhead.moment() == Time{10});
    CHECK(playhead.finished());
}

TEST_CASE("only once is ever finished")
{
    for (const Loop loop : {Loop::repeat, Loop::ping_pong}) {
        Playhead playhead = silent(Time{10}, loop);
        playhead.advance(10);
        CHECK_FALSE(playhead.finished());
    }
}

TEST_CASE("backwards, repeat goes on at its end and ping-pong turns at its beginning")
{
    Playhead repeat = silent(Time{10}, Loop::repeat);
    repeat.set_speed(-as_authored);
    repeat.advance(3);
    CHECK(repeat.moment() == Time{7});
    repeat.advance(7);
    CHECK(repeat.moment() == Time{0});
    Playhead ping_pong = silent(Time{10}, Loop::ping_pong);
    ping_pong.set_speed(-as_authored);
    ping_pong.advance(3);
    CHECK(ping_pong.moment() == Time{3});
}

TEST_CASE("any moment can be sought; the loop brings in what lies outside")
{
    const auto sought = [](Loop loop, int moment) {
        Playhead playhead{{Time{20}, Time{30}, loop}, EventCursor{ByteReader{}}};
        playhead.seek(Time{moment});
        return playhead.moment().ticks;
    };
    for (const Loop loop : loops) {
        CHECK(sought(loop, 20) == 20);
        CHECK(sought(loop, 29) == 29);
    }
    CHECK(sought(Loop::once, 30) == 30);
    CHECK(sought(Loop::once, 1000) == 30);
    CHECK(sought(Loop::once, -1000) == 20);
    CHECK(sought(Loop::repeat, 30) == 20);
    CHECK(sought(Loop::repeat, 19) == 29);
    CHECK(sought(Loop::repeat, -2'147'483'647) == 23);
    CHECK(sought(Loop::ping_pong, 30) == 30);
    CHECK(sought(Loop::ping_pong, 33) == 27);
    CHECK(sought(Loop::ping_pong, 42) == 22);
    CHECK(sought(Loop::ping_pong, 2'147'483'647) == 27);
}

TEST_CASE("behind the end of ping-pong lies the way back")
{
    Playhead playhead = silent(Time{10}, Loop::ping_pong);
    playhead.seek(Time{13});
    playhead.advance(2);
    CHECK(playhead.moment() == Time{5});
    playhead.seek(Time{7});
    playhead.advance(2);
    CHECK(playhead.moment() == Time{9});
}

}
