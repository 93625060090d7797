#include "core/math/angle.hpp"

#include "tests/core/spot.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <random>

namespace kfast::test {

TEST_CASE("a heading is within 1/15000 rad of its vector, a unit vector, and its length is known")
{
    std::mt19937 random{21};
    double turned = 0;
    double stretched = 0;
    double shortened = 0;
    for (int round = 0; round < 400'000; ++round) {
        const int bits = static_cast<int>(random() % 31);
        const auto coordinate = [&] { return static_cast<std::int32_t>(random()) >> bits; };
        Point vector{Fixed::from_raw(coordinate()), Fixed::from_raw(coordinate())};
        if (round % 16 == 0)
            vector.x = {};
        if (vector == Point{} || std::max(std::abs(vector.x.raw()), std::abs(vector.y.raw())) < 16)
            continue;
        const auto [direction, length] = to_polar(vector);
        const double exact = std::hypot(vector.x.raw(), vector.y.raw());
        const double size = std::hypot(direction.x, direction.y);
        const double cross = (double(vector.x.raw()) * direction.y - double(vector.y.raw()) * direction.x);
        turned = std::max(turned, std::abs(cross) / exact / size);
        stretched = std::max(stretched, std::abs(size / 32768 - 1));
        shortened = std::max(shortened, std::abs(length - exact) / (exact + 8000));
    }
    CHECK(turned < 1 / 15000.0);
    CHECK(stretched < 1 / 15000.0);
    CHECK(shortened < 1 / 5000.0);
}

}
