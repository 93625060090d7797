#include "host/sound/wave_file.hpp"

#include <doctest/doctest.h>
#include <string_view>

using namespace kfast;

namespace {

using Bytes = std::vector<std::byte>;

/// Little-endian, with its sign.
int number(const Bytes& bytes, std::size_t place, int count)
{
    std::uint32_t value = 0;
    for (int at = 0; at < count; ++at)
        value |= std::to_integer<std::uint32_t>(bytes[place + static_cast<std::size_t>(at)])
                 << (32 - 8 * count + 8 * at);
    return static_cast<std::int32_t>(value) >> (32 - 8 * count);
}

/// Where the content of a part begins.
std::size_t part(const Bytes& bytes, std::string_view name)
{
    std::size_t at = 12;
    while (std::string_view{reinterpret_cast<const char*>(&bytes[at]), 4} != name)
        at += 8 + static_cast<std::size_t>(number(bytes, at + 4, 4));
    return at + 8;
}

constexpr std::array<FieldPoint, 3> points{{{1, -2}, {32767, -32768}, {1000, 3}}};

}

TEST_CASE("a file of 16 bits has the points as they are")
{
    const Bytes file = wave_file(points, {}, 44'100, 16);
    const std::size_t format = part(file, "fmt ");
    CHECK(number(file, format, 2) == 1); // PCM
    CHECK(number(file, format + 2, 2) == 2);
    CHECK(number(file, format + 4, 4) == 44'100);
    CHECK(number(file, format + 14, 2) == 16);
    const std::size_t data = part(file, "data");
    CHECK(number(file, data - 4, 4) == 12);
    CHECK(file.size() == data + 12);
    CHECK(number(file, 4, 4) == static_cast<int>(file.size()) - 8);
    for (std::size_t at = 0; at < points.size(); ++at) {
        CHECK(number(file, data + 4 * at, 2) == points[at].x);
        CHECK(number(file, data + 4 * at + 2, 2) == points[at].y);
    }
}

TEST_CASE("a file of 24 bits is finer")
{
    const Bytes file = wave_file(points, {.gain = 0.25}, 192'000, 24);
    const std::size_t data = part(file, "data");
    CHECK(number(file, part(file, "fmt ") + 4, 4) == 192'000);
    CHECK(number(file, data - 4, 4) == 18);
    CHECK(number(file, data, 3) == 64);
    CHECK(number(file, data + 3, 3) == -128);
    CHECK(number(file, data + 6, 3) == 32767 * 64);
}

TEST_CASE("levels are rounded, and stay at the ends")
{
    const Bytes file = wave_file(points, {.gain = 0.75}, 48'000, 16);
    const std::size_t data = part(file, "data");
    CHECK(number(file, data, 2) == 1);      // 0.75
    CHECK(number(file, data + 2, 2) == -1); // -1.5
    const Bytes loud = wave_file(points, {.inverts_y = true, .gain = 2}, 48'000, 16);
    CHECK(number(loud, data + 4, 2) == 32767);
    CHECK(number(loud, data + 6, 2) == 32767);
}

TEST_CASE("a file has as many points as there are, over all blocks")
{
    for (const std::size_t count : {1u, 4095u, 4096u, 4097u, 10'000u}) {
        const std::vector<FieldPoint> many(count, FieldPoint{5, 6});
        const Bytes file = wave_file(many, {}, 48'000, 16);
        const std::size_t data = part(file, "data");
        CHECK(file.size() - data == 4 * count);
        CHECK(number(file, file.size() - 2, 2) == 6);
    }
}
