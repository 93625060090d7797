#include "host/picture/film.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

constexpr std::int32_t frame = Time::ticks_per_frame;

Timeline timeline(Loop loop, std::int32_t ticks) { return {30000, {{}, Time{ticks}, loop}}; }

TEST_CASE("a film has every frame once, and the last of what repeats ends with the period")
{
    const auto moments = film_moments(timeline(Loop::repeat, 2 * frame + 100));
    REQUIRE(moments.size() == 3);
    CHECK(moments[1].time == Time::frame(1));
    CHECK(moments[2].begin == 2 * frame);
    CHECK(moments[2].end == 2 * frame + 100);
}

TEST_CASE("what plays once shows its end for a frame")
{
    const auto moments = film_moments(timeline(Loop::once, 2 * frame));
    REQUIRE(moments.size() == 3);
    CHECK(moments[2].time == Time::frame(2));
    CHECK(moments[2].end == 3 * frame);
}

TEST_CASE("ping-pong goes there and back")
{
    const auto moments = film_moments(timeline(Loop::ping_pong, 2 * frame));
    REQUIRE(moments.size() == 4);
    CHECK(moments[1].time == moments[3].time);
    CHECK(moments[3].end == 4 * frame);
}

}
}
