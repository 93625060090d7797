#include "core/raster/outline/simplify.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::raster::test {
namespace {

using Contour = std::vector<Corner>;

Contour simplified(Contour contour)
{
    contour.resize(
        static_cast<std::size_t>(simplify(contour.data(), contour.data() + contour.size()) - contour.data()));
    return contour;
}

double distance(Corner from, Corner to, Corner point)
{
    const double x = to.x - from.x;
    const double y = to.y - from.y;
    if (from == to)
        return std::hypot(from.x - point.x, from.y - point.y);
    const double share =
        std::clamp(((point.x - from.x) * x + (point.y - from.y) * y) / (x * x + y * y), 0.0, 1.0);
    return std::hypot(from.x + share * x - point.x, from.y + share * y - point.y);
}

TEST_CASE("corners on a straight line are left out")
{
    const Contour square{{0, 0}, {100, 1}, {200, -1}, {300, 0}, {300, 300}, {0, 300}};
    const Contour expected{{0, 0}, {300, 0}, {300, 300}, {0, 300}};
    CHECK(simplified(square) == expected);
}

TEST_CASE("corners further away than the tolerance stay, and so do spikes along the line")
{
    constexpr std::int32_t far = simplify_tolerance + 1;
    for (const Contour& contour :
         {Contour{{0, 0}, {100, far}, {200, 0}, {100, 300}}, Contour{{0, 0}, {300, 1}, {200, 0}, {100, 300}},
          Contour{{0, 0}, {-90, 1}, {200, 0}, {100, 300}}, Contour{{0, 0}, {8000, -498}, {0, 0}, {0, 3000}},
          Contour{{0, 0}, {5, 5}}, Contour{{3, 4}}, Contour{}})
        CHECK(simplified(contour) == contour);
}

TEST_CASE("what is left out lies near what replaces it")
{
    std::mt19937 random{27};
    std::size_t before = 0;
    std::size_t after = 0;
    for (int round = 0; round < kfast::test::rounds(300); ++round) {
        const double radius = 20.0 * (1 << random() % 12);
        const double wobble = static_cast<double>(random() % 8);
        const auto count = 3 + random() % 200;
        Contour contour;
        for (std::size_t i = 0; i != count; ++i) {
            const double turn = 6.283 * static_cast<double>(i) / static_cast<double>(count);
            const double from_centre = radius + wobble * static_cast<double>(random() % 100) / 100;
            contour.push_back({static_cast<std::int32_t>(from_centre * std::cos(turn)),
                               static_cast<std::int32_t>(from_centre * std::sin(turn))});
        }
        const Contour left = simplified(contour);
        before += contour.size();
        after += left.size();
        REQUIRE(left.size() >= 2);
        CHECK(left.front() == contour.front());
        CHECK(left.back() == contour.back());
        std::size_t edge = 0;
        for (const Corner corner : contour) {
            if (corner == left[edge + 1] && edge + 2 < left.size())
                ++edge;
            REQUIRE(distance(left[edge], left[edge + 1], corner) < simplify_tolerance * 1.04);
        }
    }
    CHECK(after < before * 3 / 4);
}

}
}
