#include "core/playhead.hpp"

#include "core/kfb_limits.hpp"
#include "tests/event_bytes.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::int32_t as_authored = Playhead::as_authored;

/// Plays events that it keeps itself, and writes their names as they are passed.
class Played {
public:
    Played(const Stretch& stretch, const std::vector<EventView>& events)
        : bytes_{event_bytes(events)}, playhead_{stretch, EventCursor{ByteReader{bytes_}}}
    {
    }
    Played(const Played&) = delete;

    Playhead& operator*() { return playhead_; }
    Playhead* operator->() { return &playhead_; }

    std::string passed(std::int64_t ticks)
    {
        std::string names;
        playhead_.advance(ticks, [&](const EventView& event) { names += event.name; });
        return names;
    }

private:
    std::vector<std::byte> bytes_;
    Playhead playhead_;
};

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

constexpr Loop loops[]{Loop::once, Loop::repeat, Loop::ping_pong};

/// Ten ticks with events at both ends and twice in the middle.
Played ten_ticks(Loop loop)
{
    return {{Time{0}, Time{10}, loop}, {{"a", {0}}, {"b", {4}}, {"c", {4}}, {"d", {10}}}};
}

/// What a playhead must do, in steps of a quarter of a tick.
class SlowPlayhead {
public:
    SlowPlayhead(const Stretch& stretch, const std::vector<EventView>& events)
        : stretch_{stretch}, events_{events}, quarter_{4 * stretch.begin.ticks}
    {
    }

    void seek(Time moment)
    {
        quarter_ = 4 * moment.ticks;
        there_ = false;
        returning_ = false;
    }

    /// `quarters` of the authored speed.
    std::string passed(int ticks, int quarters)
    {
        names_.clear();
        quarters_ = quarters;
        if (!there_)
            arrive();
        there_ = true;
        for (int i = 0; i < ticks * std::abs(quarters); ++i)
            step();
        return names_;
    }

    Time moment() const { return {quarter_ / 4}; }

private:
    int begin() const { return 4 * stretch_.begin.ticks; }
    int end() const { return 4 * stretch_.end.ticks; }
    bool runs_back() const { return (quarters_ < 0) != returning_; }

    void step()
    {
        const bool at_border = quarter_ == (runs_back() ? begin() : end());
        if (at_border && stretch_.loop == Loop::once)
            return;
        if (at_border && stretch_.loop == Loop::ping_pong)
            returning_ = !returning_;
        else if (at_border)
            jump(end());
        quarter_ += runs_back() ? -1 : 1;
        arrive();
        if (stretch_.loop == Loop::repeat && quarter_ == end())
            jump(begin());
    }

    void jump(int quarter)
    {
        quarter_ = quarter;
        arrive();
    }

    void arrive()
    {
        std::string here;
        for (const EventView& event : events_)
            if (4 * event.time.ticks == quarter_)
                here.append(event.name);
        names_ += runs_back() ? std::string{here.rbegin(), here.rend()} : here;
    }

    Stretch stretch_;
    std::vector<EventView> events_;
    int quarter_;
    int quarters_ = 0;
    bool returning_ = false;
    bool there_ = false;
    std::string names_;
};

/// Random stretches, events and ways; the same every time.
class Chance {
public:
    explicit Chance(std::uint32_t seed) : engine_{seed} {}

    /// 0 … `most`, without std's distributions, which differ between libraries.
    int upto(int most) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(most + 1)); }

    Stretch stretch()
    {
        const int begin = upto(5);
        return {Time{begin}, Time{begin + 1 + upto(11)}, loops[upto(2)]};
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
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        CAPTURE(seed);
        Chance chance{seed};
        const Stretch stretch = chance.stretch();
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
