#include "core/playhead.hpp"

#include "tests/core/played.hpp"
#include "tests/core/slow_playhead.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

/// What a playhead tells of the events that it passes.
namespace kfast::test {
namespace {

constexpr std::int32_t as_authored = Playhead::as_authored;

/// Ten ticks with events at both ends and twice in the middle.
Played ten_ticks(Loop loop)
{
    return {{Time{0}, Time{10}, loop}, {{"a", {0}}, {"b", {4}}, {"c", {4}}, {"d", {10}}}};
}

/// Random stretches, events and ways; the same every time.
class Chance {
public:
    explicit Chance(std::uint32_t seed) : engine_{seed} {}

    /// 0 … `max`, without std's distributions, which differ between libraries.
    int upto(int max) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(max + 1)); }

    PlayRange stretch()
    {
        const int begin = upto(5);
        return {Time{begin}, Time{begin + 1 + upto(11)}, static_cast<Loop>(upto(2))};
    }

    std::vector<EventView> events()
    {
        static constexpr std::string_view letters = "abcdefgh";
        std::vector<EventView> events;
        Time time;
        for (std::size_t i = 0; i < letters.size(); ++i) {
            time = time + Time{upto(3)};
            events.push_back({letters.substr(i, 1), time});
        }
        events.resize(static_cast<std::size_t>(upto(8)));
        return events;
    }

private:
    std::mt19937 engine_;
};

}

TEST_CASE("once passes each event once, the one at the beginning first")
{
    Played played = ten_ticks(Loop::once);
    CHECK(played.passed(0) == "a");
    CHECK(played.passed(3) == "");
    CHECK(played.passed(1) == "bc");
    CHECK(played.passed(0) == "");
    CHECK(played.passed(6) == "d");
    CHECK(played.passed(100) == "");
}

TEST_CASE("repeat passes the end, then the beginning, in every pass")
{
    CHECK(ten_ticks(Loop::repeat).passed(25) == "abcdabcdabc");
    CHECK(ten_ticks(Loop::repeat).passed(20) == "abcdabcda");
    CHECK(ten_ticks(Loop::repeat).passed(19) == "abcdabc");
    Played backwards = ten_ticks(Loop::repeat);
    backwards->set_speed(-as_authored);
    CHECK(backwards.passed(0) == "a");
    CHECK(backwards.passed(10) == "dcba");
    CHECK(backwards.passed(1) == "d");
}

TEST_CASE("ping-pong passes what lies on its turning points once")
{
    CHECK(ten_ticks(Loop::ping_pong).passed(9) == "abc");
    CHECK(ten_ticks(Loop::ping_pong).passed(10) == "abcd");
    CHECK(ten_ticks(Loop::ping_pong).passed(30) == "abcdcbabcd");
}

TEST_CASE("there and back passes an event twice; turning on it, once")
{
    Played past = ten_ticks(Loop::once);
    CHECK(past.passed(5) == "abc");
    past->set_speed(-as_authored);
    CHECK(past.passed(2) == "cb");
    CHECK(past.passed(3) == "a");
    Played onto = ten_ticks(Loop::once);
    CHECK(onto.passed(4) == "abc");
    onto->set_speed(-as_authored);
    CHECK(onto.passed(4) == "a");
}

TEST_CASE("an event is passed when its tick is reached, not a fraction earlier or later")
{
    Played played = ten_ticks(Loop::once);
    played->set_speed(as_authored / 2);
    CHECK(played.passed(7) == "a");
    CHECK(played.passed(1) == "bc");
    played->set_speed(-as_authored / 2);
    CHECK(played.passed(1) == "");
    played->set_speed(as_authored / 2);
    CHECK(played.passed(1) == "bc");
}

TEST_CASE("seeking passes nothing; playing from there begins with what is there")
{
    Played played = ten_ticks(Loop::once);
    played->seek(Time{4});
    CHECK(played.passed(1) == "bc");
    played->seek(Time{9});
    CHECK(played.passed(0) == "");
    played->seek(Time{0});
    CHECK(played.passed(1) == "a");
    played->seek(Time{10});
    played->set_speed(-as_authored);
    CHECK(played.passed(5) == "d");
}

TEST_CASE("a clip passes what lies within it, its ends included")
{
    const std::vector<EventView> events{{"a", {0}}, {"b", {20}}, {"c", {25}}, {"d", {30}}, {"e", {31}}};
    CHECK(Played{{Time{20}, Time{30}, Loop::once}, events}.passed(100) == "bcd");
    CHECK(Played{{Time{20}, Time{30}, Loop::repeat}, events}.passed(15) == "bcdbc");
    CHECK(Played{{Time{21}, Time{24}, Loop::repeat}, events}.passed(100) == "");
}

TEST_CASE("a long sleep loses no pass")
{
    Played played = ten_ticks(Loop::repeat);
    int count = 0;
    played->advance(1'000'000, [&](const EventView&) { ++count; });
    CHECK(count == 400'001);
}

TEST_CASE("places and reports are those of a step-by-step playhead, however the way is divided")
{
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(rounds(3000)); ++seed) {
        CAPTURE(seed);
        Chance chance{seed};
        const PlayRange stretch = chance.stretch();
        const std::vector<EventView> events = chance.events();
        Played played{stretch, events};
        SlowPlayhead slow{stretch, events};
        for (int i = 0; i < 12; ++i) {
            if (chance.upto(5) == 0) {
                const Time moment{stretch.begin.ticks + chance.upto(stretch.length().ticks - 1)};
                played->seek(moment);
                slow.seek(moment);
            }
            const int quarters = chance.upto(16) - 8;
            played->set_speed(quarters * (as_authored / 4));
            std::string passed;
            int ticks = 0;
            for (int parts = chance.upto(3); parts >= 0; --parts) {
                const int part = chance.upto(parts == 0 ? 20 : 3);
                passed += played.passed(part);
                ticks += part;
            }
            REQUIRE(passed == slow.passed(ticks, quarters));
            REQUIRE(played->moment() == slow.moment());
        }
    }
}

}
