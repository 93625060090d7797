#include "core/time/track.hpp"

#include "tests/core/time/exact_hermite.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

constexpr double fine_one = 1 << fine_bits;

/// Keys in memory.
class Keys {
public:
    explicit Keys(const std::vector<KeySample>& keys) : keys_{&keys} {}

    bool at_end() const { return next_ == keys_->size(); }
    KeySample next() { return (*keys_)[next_++]; }

private:
    const std::vector<KeySample>* keys_;
    std::size_t next_ = 0;
};

HermiteSpan span_of(const std::vector<KeySample>& keys, int ticks)
{
    return hermite_span_at(Keys{keys}, {ticks});
}

std::array<int, 4> values_at(const std::vector<KeySample>& keys, int ticks)
{
    const HermiteSpan span = span_of(keys, ticks);
    return {span.before.value, span.from.value, span.to.value, span.after.value};
}

/// Two to six keys, from one to many millions of ticks apart.
std::vector<KeySample> random_keys(std::mt19937& random, std::int32_t largest)
{
    std::vector<KeySample> keys(2 + random() % 5);
    const int spread = 1 + static_cast<int>(random() % 27);
    std::int32_t ticks = static_cast<std::int32_t>(random() % 1000);
    for (KeySample& key : keys) {
        key = {{ticks}, std::uniform_int_distribution<std::int32_t>{-largest, largest}(random)};
        ticks += 1 + static_cast<std::int32_t>(random() >> (32 - spread));
    }
    return keys;
}

double range_of(const HermiteSpan& span)
{
    const auto [min, max] =
        std::minmax({span.before.value, span.from.value, span.to.value, span.after.value});
    return max - min;
}

Time random_time(std::mt19937& random, const std::vector<KeySample>& keys)
{
    return {std::uniform_int_distribution<std::int32_t>{keys.front().time.ticks - 3,
                                                        keys.back().time.ticks + 3}(random)};
}

}

TEST_CASE("a moment lies between two keys, with one before and one after if there are any")
{
    using Values = std::array<int, 4>;
    const std::vector<KeySample> keys{{{10}, 1}, {{20}, 2}, {{40}, 3}, {{50}, 4}};
    CHECK(values_at(keys, 9) == Values{1, 1, 1, 1});
    CHECK(values_at(keys, 10) == Values{1, 1, 2, 3});
    CHECK(values_at(keys, 19) == Values{1, 1, 2, 3});
    CHECK(values_at(keys, 20) == Values{1, 2, 3, 4});
    CHECK(values_at(keys, 39) == Values{1, 2, 3, 4});
    CHECK(values_at(keys, 40) == Values{2, 3, 4, 4});
    CHECK(values_at(keys, 49) == Values{2, 3, 4, 4});
    CHECK(values_at(keys, 50) == Values{4, 4, 4, 4});
    CHECK(values_at(keys, 1000) == Values{4, 4, 4, 4});
    CHECK(span_of(keys, 19).after.time == Time{40});
}

TEST_CASE("a single key is all around any moment")
{
    for (const int ticks : {-5, 10, 11})
        CHECK(values_at({{{10}, 7}}, ticks) == std::array<int, 4>{7, 7, 7, 7});
}

TEST_CASE("a curve is exact on its keys, and held outside of them")
{
    std::mt19937 random{61};
    for (int round = 0; round < 3000; ++round) {
        const std::vector<KeySample> keys = random_keys(random, 1 << 20);
        for (const KeySample& key : keys)
            CHECK(hermite(span_of(keys, key.time.ticks), key.time) == key.value * 256);
        CHECK(hermite(span_of(keys, -9), {-9}) == keys.front().value * 256);
        const Time later = keys.back().time + Time{9};
        CHECK(hermite(span_of(keys, later.ticks), later) == keys.back().value * 256);
    }
}

TEST_CASE("between two keys a curve eases in and out")
{
    const std::vector<KeySample> keys{{{0}, 0}, {{1024}, 1000}};
    CHECK(hermite(span_of(keys, 256), {256}) == 156.25 * 256);
    CHECK(hermite(span_of(keys, 512), {512}) == 500 * 256);
    CHECK(hermite(span_of(keys, 768), {768}) == 843.75 * 256);
}

TEST_CASE("the slope at an inner key is that of the line between its neighbours, whatever their distance")
{
    const std::vector<KeySample> keys{{{0}, 0}, {{100 << 10}, 600'000}, {{400 << 10}, 800'000}};
    const auto value_at = [&keys](int ticks) { return hermite(span_of(keys, ticks), {ticks}) / fine_one; };
    const int at = 100 << 10;
    const int step = 128;
    const double slope = 800'000.0 / (400 << 10);
    CHECK(std::abs((value_at(at + step) - value_at(at)) / step - slope) < slope / 50);
    CHECK(std::abs((value_at(at) - value_at(at - step)) / step - slope) < slope / 50);
}

TEST_CASE("any curve is within range / 40000 + 2 / 256 of the exact one")
{
    std::mt19937 random{62};
    double worst = 0;
    for (int round = 0; round < 20'000; ++round) {
        const std::vector<KeySample> keys = random_keys(random, 1 << (round % 21));
        const ExactHermite exact{keys};
        for (int moment = 0; moment < 10; ++moment) {
            const Time time = random_time(random, keys);
            const HermiteSpan span = span_of(keys, time.ticks);
            const double error = std::abs(hermite(span, time) / fine_one - exact.at(time));
            worst = std::max(worst, error / (range_of(span) / 40'000 + 2 / fine_one));
        }
    }
    CHECK(worst <= 1);
}

TEST_CASE("a curve leaves the range of its keys by at most 8/27 of it")
{
    std::mt19937 random{63};
    double max = 0;
    for (int round = 0; round < 20'000; ++round) {
        std::vector<KeySample> keys = random_keys(random, 1 << 20);
        for (KeySample& key : keys) // most extreme: only the ends of the range
            key.value = round % 2 == 0 ? key.value : (key.value > 0 ? 1 << 20 : -(1 << 20));
        const Time time = random_time(random, keys);
        const HermiteSpan span = span_of(keys, time.ticks);
        const auto [min, highest] =
            std::minmax({span.before.value, span.from.value, span.to.value, span.after.value});
        const double value = hermite(span, time) / fine_one;
        if (highest != min)
            max = std::max({max, (value - highest) / range_of(span), (min - value) / range_of(span)});
    }
    CHECK(max <= 8.0 / 27 + 0.0001);
    CHECK(max > 0.2); // some come near
}

}
