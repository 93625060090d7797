#include "host/compiler/moments.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace kfast::test {
namespace {

std::vector<Time> frames(int from, int to)
{
    std::vector<Time> times;
    for (int frame = from; frame <= to; ++frame)
        times.push_back(Time::frame(frame));
    return times;
}

}

TEST_CASE("each frame is looked at, and key times between them")
{
    CHECK(moments_between(Time::frame(3), Time::frame(3), {}) == frames(3, 3));
    const auto moments = moments_between(Time::frame(3), Time::frame(23), {Time::frame(1), {20'000}});
    CHECK(std::ranges::is_sorted(moments));
    CHECK(moments.front() == Time::frame(3));
    CHECK(moments.back() == Time::frame(23));
    CHECK(std::ranges::count(moments, Time{20'000}) == 1);
    for (std::size_t i = 1; i < moments.size(); ++i)
        CHECK((moments[i] - moments[i - 1]).ticks <= 1024);
}

TEST_CASE("what moves fast is looked at between frames")
{
    CHECK(moments_between(Time{100}, Time{1700}, {{50}, {100}, {900}, {1700}, {2500}}).size() == 17);
    CHECK(moments_between(Time{100}, Time{103}, {{102}}) == std::vector<Time>{{100}, {101}, {102}, {103}});
}

TEST_CASE("of many frames and keys some are looked at")
{
    CHECK(moments_between(Time{}, Time::frame(100'000), {}).size() < 202);
    const auto moments = moments_between(Time{}, Time::frame(100'000), frames(0, 100'000));
    CHECK(moments.size() > 700);
    CHECK(moments.size() < 1000);
    CHECK(moments.back() == Time::frame(100'000));
}

}
