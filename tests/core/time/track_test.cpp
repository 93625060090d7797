#include "core/time/track.hpp"

#include "tests/core/time/exact_hermite.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::int32_t latest = (1 << 30) - 1;

/// Values 0 … range, whose key times are all different, in the order of their times.
std::vector<KeySample> random_keys(std::mt19937& random, std::int32_t range)
{
    std::vector<KeySample> keys(1 + random() % 12);
    Time time{static_cast<std::int32_t>(random() % 100'000) - 50'000};
    for (KeySample& key : keys) {
        key = {time, static_cast<std::int32_t>(random() % static_cast<unsigned>(range + 1))};
        time.ticks += 1 + static_cast<std::int32_t>(random() % 40'000);
    }
    return keys;
}

void add_all(Track& track, std::vector<KeySample> keys, std::mt19937& random)
{
    std::ranges::shuffle(keys, random);
    for (const KeySample& key : keys)
        REQUIRE(track.add(key.time, key.value));
}

}

TEST_CASE("a track without key times is 0 everywhere")
{
    std::array<KeySample, 4> storage{KeySample{{5}, 6}};
    const Track track{storage};
    CHECK(track.count() == 0);
    CHECK(track.keys().empty());
    CHECK(track.value_at({5}) == 0);
}

TEST_CASE("key times may come in any order and lie in the order of their times")
{
    std::array<KeySample, 8> storage;
    Track track{storage};
    for (const int frame : {30, 0, 20, -7, 10})
        CHECK(track.add(Time::frame(frame), frame + 100));
    CHECK(track.count() == 5);
    CHECK(track.first_time() == Time::frame(-7));
    CHECK(track.last_time() == Time::frame(30));
    CHECK(std::ranges::is_sorted(track.keys(), {}, &KeySample::time));
    for (const KeySample& key : track.keys())
        CHECK(track.value_at(key.time) == (key.time.ticks / 1024 + 100) * 256);
}

TEST_CASE("a key time that is there already gets the new value")
{
    std::array<KeySample, 3> storage;
    Track track{storage};
    for (const int frame : {0, 1, 2})
        track.add(Time::frame(frame), frame);
    CHECK(track.add(Time::frame(1), 50)); // though the array is full
    CHECK(track.count() == 3);
    CHECK(track.value_at(Time::frame(1)) == 50 * 256);
    CHECK(track.value_at(Time::frame(2)) == 2 * 256);
}

TEST_CASE("a full array takes no more, and is left as it was")
{
    std::array<KeySample, 2> storage;
    Track track{storage};
    CHECK(track.add({0}, 1));
    CHECK(track.add({10}, 2));
    for (const int ticks : {-5, 5, 15})
        CHECK_FALSE(track.add({ticks}, 3));
    CHECK(track.count() == 2);
    CHECK(track.first_time() == Time{0});
    CHECK(track.last_time() == Time{10});
    CHECK(track.value_at({0}) == 256);
    CHECK(track.value_at({10}) == 512);
    Track none{std::span<KeySample>{}};
    CHECK_FALSE(none.add({0}, 1));
    CHECK(none.value_at({0}) == 0);
}

TEST_CASE("times and values out of range are refused")
{
    std::array<KeySample, 8> storage;
    Track track{storage};
    constexpr auto min = std::numeric_limits<std::int32_t>::min();
    for (const int ticks : {latest + 1, -latest - 1, min, std::numeric_limits<std::int32_t>::max()})
        CHECK_FALSE(track.add({ticks}, 0));
    for (const int value : {(1 << 20) + 1, -(1 << 20) - 1, min})
        CHECK_FALSE(track.add({0}, value));
    CHECK(track.count() == 0);
    CHECK(track.add({-latest}, 1 << 20));
    CHECK(track.add({latest}, -(1 << 20)));
    CHECK(track.count() == 2);
    CHECK(track.value_at({0}) == 0); // half of the longest way
}

TEST_CASE("outside of its key times a track is held, at any time")
{
    std::array<KeySample, 3> storage;
    Track track{storage};
    track.add(Time::frame(4), -7);
    CHECK(track.value_at(Time::frame(9)) == -7 * 256);
    track.add(Time::frame(8), 9);
    CHECK(track.value_at(Time::frame(3)) == -7 * 256);
    CHECK(track.value_at({std::numeric_limits<std::int32_t>::min()}) == -7 * 256);
    CHECK(track.value_at(Time::frame(9)) == 9 * 256);
    CHECK(track.value_at({std::numeric_limits<std::int32_t>::max()}) == 9 * 256);
}

TEST_CASE("a track that has been cleared can be filled again")
{
    std::array<KeySample, 2> storage;
    Track track{storage};
    track.add({1}, 1);
    track.add({2}, 2);
    track.clear();
    CHECK(track.count() == 0);
    CHECK(track.value_at({1}) == 0);
    CHECK(track.add({7}, 5));
    CHECK(track.first_time() == Time{7});
    CHECK(track.last_time() == Time{7});
}

TEST_CASE("the example of the header")
{
    std::array<KeySample, 8> keys;
    Track height{keys};
    height.add(Time::frame(30), 200);
    height.add(Time::frame(0), 40);
    const std::int32_t now = height.value_at(Time::frame(7)) >> fine_bits;
    CHECK(now == 62); // 40 + 160 u^2 (3 - 2 u)
}

TEST_CASE("any track is within 1/1000 of the range of its values of the exact curve")
{
    std::mt19937 random{64};
    double worst = 0;
    for (int round = 0; round < 3000; ++round) {
        const std::int32_t range = 1 << (3 + round % 18);
        const std::vector<KeySample> keys = random_keys(random, range);
        std::array<KeySample, 12> storage;
        Track track{storage};
        add_all(track, keys, random);
        const ExactHermite exact{keys};
        for (int moment = 0; moment < 30; ++moment) {
            const std::int32_t passed = keys.back().time.ticks - keys.front().time.ticks + 20;
            const Time time = keys.front().time - Time{10} +
                              Time{static_cast<std::int32_t>(random() % static_cast<unsigned>(passed))};
            const double error = std::abs(track.value_at(time) / 256.0 - exact.at(time));
            worst = std::max(worst, error / range);
        }
    }
    CHECK(worst < 0.001);
}

}
