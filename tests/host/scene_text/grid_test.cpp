#include "host/scene_text/values/grid.hpp"

#include <charconv>
#include <cmath>
#include <doctest/doctest.h>

namespace kfast::scene_text {
namespace {

double read(const std::string& text)
{
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

/// Of those from the first to the last stored value, how many come back as something else.
int mistakes(const Grid& grid, std::int32_t first, std::int32_t last, std::size_t max_decimals)
{
    int count = 0;
    for (std::int32_t stored = first; stored <= last; ++stored) {
        const std::string text = decimal(stored, grid);
        const double value = read(text);
        const std::size_t point = text.find('.');
        const std::size_t decimals = point == std::string::npos ? 0 : text.size() - point - 1;
        if (std::lround(value * grid.stored / grid.units) != stored || decimals > max_decimals ||
            value < grid.low || value > grid.high || text.starts_with("-0 ") || text == "-0")
            ++count;
    }
    return count;
}

}

TEST_CASE("a decimal is stored as what it was made of, with few digits")
{
    CHECK(mistakes(coordinates, -2047 * 16, 2047 * 16, 2) == 0);
    CHECK(mistakes(opacities, 0, 255, 3) == 0);
    CHECK(mistakes(scales, -64 * 4096, 64 * 4096, 4) == 0);
    CHECK(mistakes(controls, -2 * 8192, 3 * 8192, 4) == 0);
    CHECK(mistakes(shares, 0, 65536, 5) == 0);
    CHECK(mistakes(degrees, -400'000, 400'000, 3) == 0);
    CHECK(mistakes(degrees, 16 * 65536 - 1000, 16 * 65536, 3) == 0);
    CHECK(mistakes(widths, 0, 65520, 2) == 0);
    CHECK(mistakes(still_widths, 1, 65520, 4) == 0);
    CHECK(mistakes(miters, 8, 248, 2) == 0);
    CHECK(mistakes(frame_rates, 1000, 1'000'000, 3) == 0);
    CHECK(mistakes(times, 0, 100'000, 4) == 0);
    CHECK(mistakes(times, 1'000'000 * 1024 - 5000, 1'000'000 * 1024, 4) == 0);
}

TEST_CASE("numbers are written as a person would")
{
    CHECK(decimal(on_grid(12, coordinates), coordinates) == "12");
    CHECK(decimal(on_grid(-0.5, coordinates), coordinates) == "-0.5");
    CHECK(decimal(on_grid(0.1, coordinates), coordinates) == "0.1");
    CHECK(decimal(on_grid(-0.01, coordinates), coordinates) == "0");
    CHECK(decimal(on_grid(45, degrees), degrees) == "45");
    CHECK(decimal(on_grid(1.0 / 3, opacities), opacities) == "0.333");
    CHECK(decimal(on_grid(1e300, coordinates), coordinates) == "2047");
    CHECK(decimal(on_grid(0, still_widths), still_widths) == "0.0625");
}

}
