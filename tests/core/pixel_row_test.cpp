#include "core/pixel_row.hpp"

#include "tests/bytes.hpp"

#include <cmath>
#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("channels are narrowed and widened to the nearest value, and come back")
{
    for (const std::uint32_t max : {1U, 15U, 31U, 63U}) {
        for (std::uint32_t value = 0; value <= 255; ++value)
            REQUIRE(std::abs(narrow_channel(value, max) - value * max / 255.0) <= 0.5);
        for (std::uint32_t value = 0; value <= max; ++value) {
            REQUIRE(std::abs(widen_channel(value, max) - value * 255.0 / max) <= 0.5);
            REQUIRE(narrow_channel(widen_channel(value, max), max) == value);
        }
    }
}

TEST_CASE("a blend is the nearest value on the way from under to over")
{
    for (std::uint32_t coverage = 0; coverage <= 255; ++coverage)
        for (std::uint32_t under = 0; under <= 63; under += 7)
            for (std::uint32_t over = 0; over <= 63; over += 9) {
                const double exact = under + (static_cast<double>(over) - under) * coverage / 255;
                REQUIRE(std::abs(blend_channel(under, over, coverage) - exact) <= 0.5);
            }
}

TEST_CASE("brightness runs from black to white")
{
    CHECK(brightness({0, 0, 0}) == 0);
    CHECK(brightness({255, 255, 255}) == 255);
    CHECK(brightness({255, 0, 0}) == 77);
    CHECK(brightness({0, 255, 0}) == 149);
    CHECK(brightness({0, 0, 255}) == 29);
}

TEST_CASE("rows of several pixels to a byte leave the neighbours alone")
{
    auto grey = bytes({0x12, 0x34});
    PixelRow<PixelFormat::grey4> grey_row{{grey.data()}};
    grey_row.fill(1, 2, 0xA);
    CHECK(grey == bytes({0x1A, 0xA4}));
    grey_row.blend(3, 1, 0xF, 128);
    CHECK(grey == bytes({0x1A, 0xAA}));

    auto mono = bytes({0b00000000, 0b11111111});
    PixelRow<PixelFormat::mono1> mono_row{{mono.data()}};
    mono_row.fill(6, 3, 1);
    CHECK(mono == bytes({0b00000011, 0b11111111}));
    mono_row.blend(9, 2, 0, 127);
    CHECK(mono == bytes({0b00000011, 0b11111111}));
    mono_row.blend(9, 2, 0, 128);
    CHECK(mono == bytes({0b00000011, 0b10011111}));
}

TEST_CASE("a stretch of any place and length is filled, and nothing else")
{
    for (int x = 0; x < 20; ++x)
        for (int count = 0; x + count <= 24; ++count) {
            auto row = bytes({0x5A, 0x5A, 0x5A});
            PixelRow<PixelFormat::mono1>{{row.data()}}.fill(x, count, 1);
            for (int i = 0; i < 24; ++i) {
                const int bit = std::to_integer<int>(row[static_cast<std::size_t>(i / 8)]) >> (7 - i % 8) & 1;
                const int before = 0x5A >> (7 - i % 8) & 1;
                REQUIRE(bit == (i >= x && i < x + count ? 1 : before));
            }
        }
}

TEST_CASE("rgb565 is stored with the low byte first")
{
    auto row = bytes({0, 0, 0, 0});
    PixelRow<PixelFormat::rgb565> pixels{row.data()};
    pixels.fill(1, 1, PixelRow<PixelFormat::rgb565>::ink({255, 0, 8}));
    CHECK(row == bytes({0, 0, 0x01, 0xF8}));
}

TEST_CASE("a row fades back to what it was, in proportion and from end to end")
{
    auto colours = bytes({0x00, 0xF8, 0xFF, 0xFF, 0x1F, 0x00});
    const auto before = bytes({0x00, 0x00, 0x00, 0x00, 0x1F, 0x00});
    PixelRow<PixelFormat::rgb565>{colours.data()}.fade_from(before.data(), 3, 128);
    CHECK(colours == bytes({0x00, 0x80, 0x10, 0x84, 0x1F, 0x00})); // 31 -> 16, 63 -> 32, rounded
    PixelRow<PixelFormat::rgb565>{colours.data()}.fade_from(before.data(), 2, 0);
    CHECK(colours == before);

    auto grey = bytes({0xF0, 0x3C});
    PixelRow<PixelFormat::grey4>{{grey.data()}}.fade_from(bytes({0x0F, 0x33}).data(), 3, 51);
    CHECK(grey == bytes({0x3C, 0x3C}));
    auto mono = bytes({0b11000000});
    PixelRow<PixelFormat::mono1>{{mono.data()}}.fade_from(bytes({0b10100000}).data(), 8, 127);
    CHECK(mono == bytes({0b10100000}));
}

TEST_CASE("a row takes whole bytes")
{
    CHECK(row_bytes(PixelFormat::rgb565, 3) == 6);
    CHECK(row_bytes(PixelFormat::grey4, 3) == 2);
    CHECK(row_bytes(PixelFormat::mono1, 9) == 2);
}

}
