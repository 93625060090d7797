#include "core/scene/number_text.hpp"

#include "core/scene/format.hpp"
#include "tests/core/raw_scene.hpp"

#include <cmath>
#include <cstdio>
#include <doctest/doctest.h>
#include <random>
#include <string>

namespace kfast::test {
namespace {

const Bytes before = bytes({13, 14});
const Bytes behind = bytes({15});

/// With `_` for gaps; `<>` stand in front of the number, `|` behind it, if they do.
std::string shown(const NumberFormat& format, const InputView& input, Time place)
{
    std::string text;
    const NumberText number{format, input, place};
    for (const std::byte glyph : number.glyphs())
        text += "0123456789-._<>|"[std::to_integer<std::size_t>(glyph)];
    return text;
}

NumberFormat format_of(std::uint32_t decimals, std::uint32_t digits = 1, std::uint32_t places = 0,
                       bool is_surrounded = false)
{
    NumberFormat format;
    format.decimals = decimals;
    format.digits = digits;
    format.places = places;
    if (is_surrounded) {
        format.before = before;
        format.behind = behind;
    }
    return format;
}

/// At `value`, in 1/1000.
std::string at(const NumberFormat& format, std::int32_t min, std::int32_t max, std::int32_t value)
{
    const InputView input{.name = {}, .min = min, .max = max};
    return shown(format, input, input.place_of(value));
}

}

TEST_CASE("numbers have the decimals, digits and places of their format")
{
    CHECK(at({}, 0, 240'000, 88'000) == "88");
    CHECK(at({}, 0, 240'000, 0) == "0");
    CHECK(at(format_of(0, 3), 0, 240'000, 7000) == "007");
    CHECK(at(format_of(0, 1, 4), 0, 240'000, 88'000) == "__88");
    CHECK(at(format_of(0, 2, 3), 0, 240'000, 7000) == "_07");
    CHECK(at(format_of(0, 2, 3), 0, 240'000, 207'000) == "207");
    CHECK(at(format_of(1), 0, 100'000, 250) == "0.3");
    CHECK(at(format_of(1), 0, 64'000, 12'500) == "12.5");
    CHECK(at(format_of(3), 0, 1000, 5) == "0.005");
    CHECK(at(format_of(2, 2, 4), 0, 64'000, 1250) == "__01.25");
    CHECK(at(format_of(1, 1, 0, true), 0, 64'000, 500) == "<>0.5|");
    CHECK(at({}, 0, 1'000'000'000, 1'000'000'000) == "1000000");
    CHECK(at(format_of(3), -1'000'000'000, 1'000'000'000, -1'000'000'000) == "-1000000.000");
}

TEST_CASE("a minus stands between the gaps and the digits, and not in front of 0")
{
    CHECK(at(format_of(0, 1, 3), -64'000, 64'000, -7000) == "__-7");
    CHECK(at(format_of(1, 2, 0, true), -64'000, 64'000, -500) == "<>-00.5|");
    CHECK(at({}, -64'000, 64'000, -499) == "0");
    CHECK(at(format_of(1), -64'000, 64'000, -40) == "0.0");
}

TEST_CASE("halves are rounded away from 0, once")
{
    CHECK(at({}, -64'000, 64'000, 2500) == "3");
    CHECK(at({}, -64'000, 64'000, -2500) == "-3");
    CHECK(at({}, 0, 64'000, 1499) == "1"); // not by 1.5
    CHECK(at(format_of(1), 0, 65'536, 449) == "0.4");
}

TEST_CASE("what is told in steps of the last digit is shown so, up to 65536 of them")
{
    for (std::int32_t value = 0; value <= 65'536; ++value)
        REQUIRE(at(format_of(3), 0, 65'536, value) ==
                std::to_string(value / 1000) + '.' + std::to_string(1000 + value % 1000).substr(1));
}

TEST_CASE("any number is that of an exact calculation, and no longer than those at the ends")
{
    std::mt19937 random{5};
    const auto any = [&random](std::int32_t size) {
        return static_cast<std::int32_t>(random() % (2 * static_cast<std::uint32_t>(size) + 1)) - size;
    };
    for (int round = 0; round < 20'000; ++round) {
        const std::int32_t size = round % 2 == 0 ? 1'000'000'000 : 20'000;
        InputView input{.name = {}, .min = any(size), .max = any(size)};
        if (input.min >= input.max)
            continue;
        const Time place{static_cast<std::int32_t>(random() % 65'537)};
        const NumberFormat format = format_of(static_cast<std::uint32_t>(random() % 4));
        const double step = std::pow(10.0, 3 - static_cast<int>(format.decimals)); // in 1/1000
        const long double value =
            input.min + (static_cast<long double>(input.max) - input.min) * place.ticks / 65'536;
        const double rounded = static_cast<double>(std::round(value / step)) * step / 1000;
        char text[40];
        std::snprintf(text, sizeof text, "%.*f", static_cast<int>(format.decimals),
                      rounded == 0 ? 0 : rounded);
        REQUIRE(shown(format, input, place) == text);
        REQUIRE(std::string{text}.size() <= max_glyphs(format, input));
    }
}

}
