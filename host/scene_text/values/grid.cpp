#include "host/scene_text/values/grid.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace kfast::scene_text {
namespace {

constexpr int max_decimals = 9;

/// As the compiler rounds what it reads.
std::int32_t rounded(double value, const Grid& grid)
{
    return static_cast<std::int32_t>(std::lround(value * grid.stored / grid.units));
}

std::string fixed(double value, int decimals)
{
    std::array<char, 40> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                   std::chars_format::fixed, decimals);
    return {digits.data(), end.ptr};
}

double value_of(const std::string& text)
{
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

}

std::int32_t on_grid(double value, const Grid& grid)
{
    return rounded(std::clamp(value, grid.low, grid.high), grid);
}

double off_grid(std::int32_t stored, const Grid& grid) { return stored * grid.units / grid.stored; }

double snapped(double value, const Grid& grid) { return off_grid(on_grid(value, grid), grid); }

std::string decimal(std::int32_t stored, const Grid& grid)
{
    const double value = off_grid(stored, grid);
    for (int decimals = 0; decimals < max_decimals; ++decimals) {
        std::string text = fixed(value, decimals);
        const double read = value_of(text);
        if (rounded(read, grid) == stored && read >= grid.low && read <= grid.high)
            return stored == 0 ? "0" : text;
    }
    return fixed(value, max_decimals);
}

kdl::Value number(std::int32_t stored, const Grid& grid)
{
    kdl::Value value;
    value.data = kdl::Number{decimal(stored, grid), off_grid(stored, grid)};
    return value;
}

kdl::Value exact(double value)
{
    std::string text = fixed(value, max_decimals);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.'))
        text.pop_back();
    kdl::Value number;
    number.data = kdl::Number{text, value_of(text)};
    return number;
}

kdl::Value number(std::size_t whole)
{
    kdl::Value value;
    value.data = kdl::Number{std::to_string(whole), static_cast<double>(whole)};
    return value;
}

}
