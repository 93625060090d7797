#include "firmware/link/restart_counter.hpp"
#include "firmware/link/restart_notice.hpp"
#include "firmware/link/restarts.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <initializer_list>
#include <string>

namespace kfast::test {

using namespace link;

namespace {

std::uint32_t kept = 0;
void keep(std::uint32_t word) { kept = word; }

constexpr Microseconds second{1'000'000};

/// As the watchdog does it.
Restarts restarted() { return restarts_at_start(kept, true); }

Microseconds seconds(std::uint32_t count) { return {count * second.count}; }

std::string words_of(Home home, std::uint8_t slot = no_slot)
{
    const RestartNotice notice{{.count = 2, .home = home, .slot = slot}};
    return std::string{notice.notice().words};
}

}

TEST_CASE("restarts come back from the word in which they are kept")
{
    for (const Home home : {Home::built_in, Home::slot, Home::ram, Home::start})
        for (const std::uint8_t slot : {std::uint8_t{0}, std::uint8_t{7}, no_slot})
            for (std::uint8_t count = 0; count < 16; ++count) {
                const auto back = restarts_in(word_of({.count = count, .home = home, .slot = slot}));
                REQUIRE(back);
                CHECK(back->count == count);
                CHECK(back->home == home);
                CHECK(back->slot == slot);
            }
    CHECK(restarts_in(word_of({.count = 200}))->count == 15);
}

TEST_CASE("a word of somebody else is none")
{
    for (const std::uint32_t word :
         {0U, 0xFFFF'FFFFU, 0xB007'C0D3U, 0x6AB7'3121U, 0x4B47'1102U, 0x4B46'1502U})
        CHECK_FALSE(restarts_in(word));
}

TEST_CASE("only restarts by the watchdog are counted, and only by a board that kept them")
{
    const std::uint32_t word = word_of({.count = 3, .home = Home::slot, .slot = 2});
    CHECK(restarts_at_start(word, true).count == 4);
    CHECK(restarts_at_start(word, true).slot == 2);
    CHECK(restarts_at_start(word, false).count == 0);
    CHECK(restarts_at_start(0, true).count == 0);
}

TEST_CASE("what played when the board was restarted is known afterwards")
{
    RestartCounter counter{{}, keep};
    CHECK(restarted().count == 1);
    CHECK(restarted().home == Home::start);
    counter.begins(Home::slot, 2);
    CHECK(restarted().count == 1);
    CHECK(restarted().home == Home::slot);
    CHECK(restarted().slot == 2);
    RestartCounter next{restarted(), keep};
    next.begins(Home::built_in, no_slot);
    CHECK(restarted().count == 2);
    CHECK(restarted().home == Home::built_in);
    CHECK(restarted().is_safe_mode());
}

TEST_CASE("restarts are forgotten when a scene has played for a minute")
{
    RestartCounter counter{{.count = 1, .home = Home::slot, .slot = 2}, keep};
    counter.begins(Home::slot, 2);
    const Microseconds first{0xFFFF'F000}; // the clock wraps soon
    counter.pass(first);
    counter.pass(first + seconds(59));
    CHECK(restarted().count == 2);
    counter.begins(Home::slot, 3); // has a minute of its own
    counter.pass(first + seconds(59));
    counter.pass(first + seconds(61));
    CHECK(restarted().count == 2);
    counter.pass(first + seconds(119));
    CHECK(restarted().count == 1);
    CHECK(restarted().slot == 3);
    counter.begins(Home::ram, no_slot);
    counter.pass(first + seconds(120));
    CHECK(restarted().count == 1);
}

TEST_CASE("a board without a watchdog keeps nothing")
{
    RestartCounter counter{{}, nullptr};
    counter.begins(Home::slot, 1);
    counter.pass(Microseconds{});
}

TEST_CASE("two restarts in a row make safe mode, which plays what was not the reason")
{
    CHECK_FALSE(Restarts{}.is_safe_mode());
    CHECK_FALSE(Restarts{.count = 1, .home = Home::built_in}.is_safe_mode());
    CHECK(Restarts{.count = 1, .home = Home::built_in}.allows_built_in());
    for (const std::uint8_t count : {std::uint8_t{2}, std::uint8_t{15}}) {
        CHECK(Restarts{.count = count}.is_safe_mode());
        CHECK(Restarts{.count = count, .home = Home::slot, .slot = 0}.allows_built_in());
        CHECK(Restarts{.count = count, .home = Home::ram}.allows_built_in());
        CHECK_FALSE(Restarts{.count = count, .home = Home::built_in}.allows_built_in());
        CHECK_FALSE(Restarts{.count = count, .home = Home::start}.allows_built_in());
    }
}

TEST_CASE("the notice of safe mode names what hung")
{
    CHECK(words_of(Home::slot, 5) == "slot 5 hung: it is not played");
    CHECK(words_of(Home::ram) == "a scene in RAM hung");
    CHECK(words_of(Home::built_in) == "the built-in scene hung: nothing plays");
    CHECK(words_of(Home::start) == "it hung before it played: nothing plays");
    CHECK(RestartNotice{{.count = 2}}.notice().title == "safe mode");
    CHECK(RestartNotice{{.count = 1}}.notice().title.empty());
}

}
