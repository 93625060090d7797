#include "firmware/run/still_light.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace kfast::test {

namespace {

constexpr std::uint32_t here = 0x123456;
constexpr std::uint32_t there = 0x123457;
constexpr std::uint32_t lit = 0xFF00'0000;

std::vector<std::uint32_t> passed(StillLight& still, std::vector<std::uint32_t> points)
{
    for (std::uint32_t& point : points)
        point = still.passed(point);
    still.end(points);
    return points;
}

}

TEST_CASE("a beam that moves shines as it was told")
{
    StillLight still{2};
    const std::vector<std::uint32_t> points{here | lit, here | lit, there | lit,
                                            there,      here | lit, here | lit};
    CHECK(passed(still, points) == points);
}

TEST_CASE("a beam that stays is dark after a while, and shines again elsewhere")
{
    StillLight still{2};
    CHECK(passed(still, {here | lit, here | lit, here | lit, here | lit, there | lit}) ==
          std::vector<std::uint32_t>{here | lit, here | lit, here, here, there | lit});
}

TEST_CASE("dark points do not make a place a new one")
{
    StillLight still{2};
    CHECK(passed(still, {here | lit, here, here | lit, here, here | lit, there}) ==
          std::vector<std::uint32_t>{here | lit, here, here | lit, here, here, there});
}

TEST_CASE("a picture that stays in one place is dark, however short it is")
{
    StillLight still{100};
    CHECK(passed(still, {here | lit, here | lit}) == std::vector<std::uint32_t>{here, here});
    CHECK(passed(still, {here | lit, there | lit}) == std::vector<std::uint32_t>{here | lit, there | lit});
}

}
