#include "host/schema/arithmetic.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace kfast::test {

using namespace schema;

TEST_CASE("sines and cosines are those of the C library but for its last bits, and the same in every turn")
{
    double worst = 0;
    for (int i = -720'000; i <= 720'000; i += 7) {
        const double degrees = i / 1000.0;
        const double angle = degrees * std::numbers::pi / 180;
        worst = std::max(worst, std::abs(sine_of_degrees(degrees) - std::sin(angle)));
        worst = std::max(worst, std::abs(cosine_of_degrees(degrees) - std::cos(angle)));
    }
    CHECK(worst < 5e-15); // the angle in radians is rounded, too
    for (const double degrees : {0.0, 0.25, 17.0, 45.0, 89.5, 90.0, 120.0, 180.0, 200.0, 270.0, 359.0}) {
        CAPTURE(degrees);
        CHECK(sine_of_degrees(degrees + 360 * 1000) == sine_of_degrees(degrees));
        CHECK(cosine_of_degrees(degrees - 360 * 1000) == cosine_of_degrees(degrees));
        CHECK(sine_of_degrees(-degrees) == -sine_of_degrees(degrees));
    }
}

TEST_CASE("sines and cosines of what people write are exact on the grid")
{
    const std::array<double, 13> sines{
        0, 0.5, 0.866025404, 1, 0.866025404, 0.5, 0, -0.5, -0.866025404, -1, -0.866025404, -0.5, 0};
    for (std::size_t i = 0; i < sines.size(); ++i) {
        CAPTURE(i);
        CHECK(on_grid(sine_of_degrees(30.0 * static_cast<double>(i))) == sines[i]);
        CHECK(on_grid(cosine_of_degrees(30.0 * static_cast<double>(i) - 90)) == sines[i]);
    }
    CHECK(on_grid(sine_of_degrees(45)) == 0.707106781);
    CHECK(on_grid(cosine_of_degrees(45)) == 0.707106781);
}

TEST_CASE("the grid has nine decimals, halves go away from zero, and large numbers stay as they are")
{
    CHECK(on_grid(0.1 + 0.2) == 0.3);
    CHECK(on_grid(0.07 * 100) == 7);
    CHECK(on_grid(1.0 / 3) == 0.333333333);
    CHECK(on_grid(-2.0 / 3) == -0.666666667);
    CHECK(on_grid(0.0000000005) == 0.000000001);
    CHECK_FALSE(std::signbit(on_grid(-1e-12)));
    CHECK(on_grid(123456789.123456789) == 123456789.123456789);
    CHECK(on_grid(-1e9) == -1e9);
}

TEST_CASE("a function is found by its whole name")
{
    REQUIRE(function_called("round") != nullptr);
    CHECK(function_called("round")->least == 1);
    CHECK(function_called("roun") == nullptr);
    CHECK(function_called("") == nullptr);
}

}
