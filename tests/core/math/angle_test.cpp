#include "core/math/angle.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <numbers>
#include <random>

namespace kfast::test {
namespace {

constexpr double radians = 2 * std::numbers::pi / BinaryAngle::turn;

TEST_CASE("sine and cosine are within 16 units of Q30 over the whole turn")
{
    double worst = 0;
    for (std::int32_t raw = 0; raw < BinaryAngle::turn; ++raw) {
        const BinaryAngle angle = BinaryAngle::from_raw(raw);
        worst = std::max(worst, std::abs(sine(angle) - std::sin(raw * radians) * one_q30));
        worst = std::max(worst, std::abs(cosine(angle) - std::cos(raw * radians) * one_q30));
    }
    CHECK(worst <= 16);
}

TEST_CASE("of any fine angle, sine and cosine are within 16 units")
{
    constexpr double fine_radians = radians / 65536;
    std::mt19937 random{5};
    double worst = 0;
    for (int round = 0; round < 400'000; ++round) {
        const auto raw = static_cast<std::uint32_t>(random());
        const auto error = [](FineAngle angle) {
            return std::max(std::abs(sine(angle) - std::sin(angle.raw * fine_radians) * one_q30),
                            std::abs(cosine(angle) - std::cos(angle.raw * fine_radians) * one_q30));
        };
        worst = std::max(worst, error({raw}));
    }
    CHECK(worst <= 16);
}

TEST_CASE(
    "the sine of a fine angle hardly ever falls in the first quarter turn, nor does it jump at its ends")
{
    std::int32_t before = -1;
    std::int32_t deepest = 0;
    for (std::uint32_t raw = 0; raw <= 1U << 30; raw += 1U << 11) {
        deepest = std::max(deepest, before - sine(FineAngle{raw}));
        before = sine(FineAngle{raw});
    }
    CHECK(deepest <= 4);
    for (const std::uint32_t quarter : {0U, 1U, 2U, 3U})
        for (const auto function : {static_cast<std::int32_t (*)(FineAngle)>(sine),
                                    static_cast<std::int32_t (*)(FineAngle)>(cosine)}) {
            const std::int32_t at = function(FineAngle{quarter << 30});
            CHECK((at == 0 || std::abs(at) == one_q30));
            for (const std::uint32_t near : {(quarter << 30) - 1, (quarter << 30) + 1})
                CHECK(std::abs(function(FineAngle{near}) - at) <= 4);
        }
}

TEST_CASE("fine angles of tracks and of directions are the same turns, and sums wrap")
{
    CHECK(FineAngle::of({16384}).raw == 1U << 30);
    CHECK(FineAngle::of_fine(16384 * 256) == FineAngle::of({16384}));
    CHECK(FineAngle::of_fine(-16384 * 256) == FineAngle::of({49152}));
    CHECK(FineAngle::of_fine(5 * 65536 * 256 + 77) == FineAngle::of_fine(77));
    CHECK(FineAngle::of({49152}) + FineAngle::of({32768}) == FineAngle::of({16384}));
}

TEST_CASE("the quarter sine never falls and is exact at its ends")
{
    int falls = 0;
    for (std::uint32_t share = 1; share <= Fraction::one; ++share)
        falls += quarter_sine({share}) < quarter_sine({share - 1});
    CHECK(falls == 0);
    CHECK(quarter_sine({0}) == 0);
    CHECK(quarter_sine({Fraction::one}) == one_q30);
}

TEST_CASE("a direction leads back to the angle it came from")
{
    for (std::int32_t raw = 0; raw < BinaryAngle::turn; raw += 7) {
        const BinaryAngle angle = BinaryAngle::from_raw(raw);
        const BinaryAngle back = direction(cosine(angle), sine(angle));
        REQUIRE(std::abs(shortest_turn(angle, back)) <= 1);
    }
}

TEST_CASE("directions of vectors of every length are within one unit")
{
    std::mt19937 random{3};
    double worst = 0;
    for (int round = 0; round < 200'000; ++round) {
        const int shift = static_cast<int>(random() % 29);
        const auto x = static_cast<std::int32_t>(random() >> 1) >> shift;
        const auto y = static_cast<std::int32_t>(random()) >> (random() % 30);
        if ((x == 0 && y == 0) || y == std::numeric_limits<std::int32_t>::min())
            continue;
        const double exact = std::atan2(y, x) / radians;
        const double error = std::remainder(direction(x, y).raw - exact, 65536.0);
        worst = std::max(worst, std::abs(error));
    }
    CHECK(worst <= 1.0);
}

TEST_CASE("the four axes are exact, and no vector has direction 0")
{
    CHECK(direction(5, 0).raw == 0);
    CHECK(direction(0, 1 << 30).raw == BinaryAngle::quarter_turn);
    CHECK(direction(-1, 0).raw == BinaryAngle::half_turn);
    CHECK(direction(0, -3).raw == 3 * BinaryAngle::quarter_turn);
    CHECK(direction(0, 0).raw == 0);
}

TEST_CASE("the shortest turn crosses zero")
{
    CHECK(shortest_turn({65000}, {500}) == 1036);
    CHECK(shortest_turn({500}, {65000}) == -1036);
}

}
}
