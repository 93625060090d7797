#include "core/math/fixed.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <random>

namespace kfast::test {

TEST_CASE("quotients and remainders are those of 64-bit division")
{
    std::mt19937_64 random{1};
    for (int i = 0; i < 200'000; ++i) {
        const std::uint64_t dividend = random() >> random() % 64;
        const auto divisor = static_cast<std::uint32_t>(random() >> (32 + random() % 32)) | 1;
        REQUIRE(quotient(dividend, divisor) == dividend / divisor);
        REQUIRE(remainder(dividend, divisor) == dividend % divisor);
        const std::uint64_t near =
            dividend / divisor * divisor; // and just below, where guesses are too large
        REQUIRE(quotient(near, divisor) == near / divisor);
        REQUIRE(quotient(near - 1, divisor) == (near - 1) / divisor);
    }
}

TEST_CASE("quotients at the ends of their ranges, and signed ones towards 0")
{
    constexpr std::uint64_t max = std::numeric_limits<std::uint64_t>::max();
    for (const std::uint32_t divisor : {1U, 2U, 3U, 0xFFFFU, 0x10000U, 0x10001U, 0x7FFF'FFFFU, 0x8000'0000U,
                                        0x8000'FFFFU, 0xFFFF'0000U, 0xFFFF'FFFFU})
        for (const std::uint64_t dividend :
             {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{divisor}, std::uint64_t{divisor} - 1,
              (std::uint64_t{divisor} << 32) - 1, std::uint64_t{divisor} << 32, max, max - 1}) {
            CAPTURE(divisor);
            CAPTURE(dividend);
            CHECK(quotient(dividend, divisor) == dividend / divisor);
        }
    CHECK(quotient(std::int64_t{-7}, 2U) == -3);
    CHECK(quotient(std::int64_t{7}, 2U) == 3);
    CHECK(quotient(std::numeric_limits<std::int64_t>::min(), 3U) ==
          std::numeric_limits<std::int64_t>::min() / 3);
    static_assert(quotient(std::int64_t{-1} << 40, 1U << 20) == -(std::int64_t{1} << 20));
}

}
