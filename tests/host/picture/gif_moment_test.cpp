#include "host/picture/film.hpp"

#include <doctest/doctest.h>

#include <numeric>

namespace kfast::test {
namespace {

std::vector<int> delays(const Timeline& timeline)
{
    std::vector<int> list;
    for (const GifMoment& moment : gif_moments(timeline))
        list.push_back(moment.centiseconds);
    return list;
}

std::vector<int> frames(const Timeline& timeline)
{
    std::vector<int> list;
    for (const GifMoment& moment : gif_moments(timeline))
        list.push_back(moment.time.ticks / Time::ticks_per_frame);
    return list;
}

int total(const Timeline& timeline)
{
    const std::vector<int> all = delays(timeline);
    return std::accumulate(all.begin(), all.end(), 0);
}

}

TEST_CASE("30 fps is 3, 3, 4 centiseconds")
{
    CHECK(delays({30000, {{}, Time::frame(6), Loop::repeat}}) == std::vector{3, 3, 4, 3, 3, 4});
}

TEST_CASE("delays do not drift from the clock of the scene")
{
    CHECK(total({30000, {{}, Time::frame(3000), Loop::repeat}}) == 10000);
    CHECK(total({24000, {{}, Time::frame(2400), Loop::repeat}}) == 10000);
    CHECK(total({23976, {{}, Time::frame(23976), Loop::repeat}}) == 100000);
    CHECK(total({12500, {{}, Time::frame(125), Loop::repeat}}) == 1000);
}

TEST_CASE("above 50 fps the scene is drawn 50 times a second")
{
    for (const std::uint32_t rate : {50001U, 60000U, 144000U, 1000000U}) {
        const Timeline timeline{rate, {{}, Time::frame(static_cast<int>(rate / 1000) * 2), Loop::repeat}};
        const std::vector<int> all = delays(timeline);
        for (std::size_t i = 0; i + 1 < all.size(); ++i)
            CHECK(all[i] == 2);
        CHECK(total(timeline) <= 202);
        CHECK(total(timeline) >= 199);
    }
}

TEST_CASE("repeat shows 0 to L-1, once also L, ping-pong each end once")
{
    CHECK(frames({25000, {{}, Time::frame(3), Loop::repeat}}) == std::vector{0, 1, 2});
    CHECK(frames({25000, {{}, Time::frame(3), Loop::once}}) == std::vector{0, 1, 2, 3});
    CHECK(frames({25000, {{}, Time::frame(3), Loop::ping_pong}}) == std::vector{0, 1, 2, 3, 2, 1});
    CHECK(delays({25000, {{}, Time::frame(3), Loop::once}}) == std::vector{4, 4, 4, 4});
}

}
