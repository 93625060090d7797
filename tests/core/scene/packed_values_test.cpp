#include "core/scene/packed_drawing.hpp"

#include "tests/core/raw_scene.hpp"

#include <cmath>
#include <cstdint>
#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

using Values = std::vector<std::int32_t>;

Values read(const Bytes& bytes, std::uint32_t count, std::int32_t more = 0)
{
    ByteReader reader{bytes};
    const PackedValues values = PackedValues::take(reader, count, more);
    CHECK(reader.left() == 0);
    CHECK_FALSE(reader.overrun());
    Values all;
    for (std::uint32_t index = 0; index < count; ++index)
        all.push_back(values[index]);
    return all;
}

bool comes_back(const Values& values)
{
    return read(value_bytes(values), static_cast<std::uint32_t>(values.size())) == values;
}

}

TEST_CASE("values are the least one and what each has more, in a unit")
{
    CHECK(read(bytes({0x83, 3, 0b00011110}), 2) == Values{-2 * 16, (-2 + 7) * 16}); // 3 bits, 16
    CHECK(read(bytes({0x83, 3, 0b00011110}), 2, 1000) == Values{968, 1080});
    CHECK(read(bytes({0xE7, 0, 90, 0b10000000}), 2) == Values{45 * 65536 / 360, 32 * 65536 / 360}); // degrees
    CHECK(read(bytes({0, 14}), 3) == Values{7, 7, 7});
}

TEST_CASE("a single value has no form")
{
    CHECK(read(bytes({0x81, 0x02}), 1) == Values{-129});
    CHECK(read(bytes({4}), 1, -3) == Values{-1});
}

TEST_CASE("degrees are rounded to nearest")
{
    for (std::int32_t degrees = -30'000; degrees <= 30'000; ++degrees)
        REQUIRE(in_unit(static_cast<std::uint32_t>(degrees), kfb::values::degree_unit) ==
                std::lround(degrees * 65536.0 / 360));
}

TEST_CASE("what is written is read back")
{
    std::mt19937 random{62};
    for (int round = 0; round < 5000; ++round) {
        const int bits = 1 + static_cast<int>(random() % 30);
        Values values(1 + random() % 20);
        for (std::int32_t& value : values) {
            value = static_cast<std::int32_t>(random()) >> (32 - bits);
            if (round % 3 == 0)
                value = value / 128 * 128;
            if (round % 3 == 1)
                value = in_unit(static_cast<std::uint32_t>(value % 6000), kfb::values::degree_unit);
        }
        REQUIRE(comes_back(values));
    }
    CHECK(comes_back({-(1 << 30), (1 << 30) - 1}));
    CHECK(comes_back({(1 << 30) - 1, (1 << 30) - 1, 5, -(1 << 30)}));
}

TEST_CASE("whole pixels and whole degrees take few bits")
{
    CHECK(value_bytes({73 * 16, 72 * 16, 86 * 16, 60 * 16}).size() == 1 + 1 + 3); // 5 bits each
    CHECK(value_bytes({-5279, 728, 5461, -364}).size() == 1 + 1 + 3);             // -29, 4, 30, -2: 6 bits
}

TEST_CASE("values that break off are past the end")
{
    const Bytes whole = value_bytes({1, 20, 300});
    for (std::size_t size = 0; size < whole.size(); ++size) {
        ByteReader reader{std::span{whole}.first(size)};
        PackedValues::take(reader, 3);
        CHECK(reader.overrun());
    }
    ByteReader reader{whole};
    PackedValues::take(reader, 0xFFFFFFFF);
    CHECK(reader.overrun());
}

}
