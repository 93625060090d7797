#include "core/pixel/pixel_row.hpp"

#include "tests/bytes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace kfast::test {
namespace {

using Bytes = std::vector<std::byte>;

/// Any pixels that the format knows.
template <PixelFormat format>
Bytes random_row(int width)
{
    std::minstd_rand random{7};
    Bytes result(row_bytes(format, width));
    for (std::byte& byte : result)
        byte = static_cast<std::byte>(random() & (format == PixelFormat::rgb666 ? 0xFC : 0xFF));
    return result;
}

/// Calls paint(row, its first byte) with a copy of `before` at every place in a word that the format allows,
/// and looks at what is around it.
template <PixelFormat format, class Paint>
void at_every_alignment(const Bytes& before, int left, Paint paint)
{
    const std::size_t step = bits_per_pixel(format) == 16 ? 2 : 1;
    for (std::size_t offset = 0; offset < 4; offset += step) {
        alignas(4) std::array<std::byte, 80> memory{};
        std::ranges::copy(before, memory.begin() + offset);
        paint(PixelRow<format>{memory.data() + offset, left, 5}, memory.data() + offset);
        CHECK(std::all_of(memory.begin(), memory.begin() + offset,
                          [](std::byte byte) { return byte == std::byte{}; }));
        CHECK(std::all_of(memory.begin() + offset + before.size(), memory.end(),
                          [](std::byte byte) { return byte == std::byte{}; }));
    }
}

#define EVERY_FORMAT                                                                                         \
    std::integral_constant<PixelFormat, PixelFormat::rgb565>,                                                \
        std::integral_constant<PixelFormat, PixelFormat::rgb565_be>,                                         \
        std::integral_constant<PixelFormat, PixelFormat::rgb444>,                                            \
        std::integral_constant<PixelFormat, PixelFormat::rgb666>,                                            \
        std::integral_constant<PixelFormat, PixelFormat::grey4>,                                             \
        std::integral_constant<PixelFormat, PixelFormat::mono1>,                                             \
        std::integral_constant<PixelFormat, PixelFormat::mono1_dithered>

}

TEST_CASE_TEMPLATE("a stretch of any place and length is filled as pixel by pixel, and nothing else", Format,
                   EVERY_FORMAT)
{
    constexpr PixelFormat format = Format::value;
    constexpr int width = 24;
    constexpr int left = 16;
    const Bytes before = random_row<format>(width);
    const std::uint32_t ink = PixelRow<format>::ink({200, 90, 160});
    for (int x = 0; x <= width; ++x)
        for (int count = 0; x + count <= width; ++count) {
            Bytes expected = before;
            for (int i = x; i < x + count; ++i)
                PixelRow<format>{expected.data(), left, 5}.blend(left + i, 1, ink, 255);
            at_every_alignment<format>(before, left, [&](PixelRow<format> row, const std::byte* first) {
                row.fill(left + x, count, ink);
                REQUIRE(std::equal(expected.begin(), expected.end(), first));
            });
        }
}

TEST_CASE_TEMPLATE("a stretch is blended as pixel by pixel, and nothing else", Format, EVERY_FORMAT)
{
    constexpr PixelFormat format = Format::value;
    constexpr int width = 24;
    const Bytes before = random_row<format>(width);
    const std::uint32_t ink = PixelRow<format>::ink({200, 90, 160});
    for (int x = 0; x <= width; ++x)
        for (int count = 0; x + count <= width; ++count) {
            Bytes expected = before;
            for (int i = x; i < x + count; ++i)
                PixelRow<format>{expected.data(), 0, 5}.blend(i, 1, ink, 100);
            Bytes row = before;
            PixelRow<format>{row.data(), 0, 5}.blend(x, count, ink, 100);
            REQUIRE(row == expected);
            row = before;
            PixelRow<format>{row.data(), 0, 5}.blend(x, count, ink, 0);
            REQUIRE(row == before);
        }
}

TEST_CASE_TEMPLATE("a row fades back to what it was, wholly or not at all, where it is told to", Format,
                   EVERY_FORMAT)
{
    constexpr PixelFormat format = Format::value;
    Bytes before(row_bytes(format, 24));
    PixelRow<format>{before.data(), 8, 5}.fill(8, 24, PixelRow<format>::ink({10, 40, 90}));
    Bytes painted(row_bytes(format, 24));
    PixelRow<format>{painted.data(), 8, 5}.fill(8, 24, PixelRow<format>::ink({250, 200, 190}));
    Bytes expected = painted;
    PixelRow<format>{expected.data(), 8, 5}.fill(11, 15, PixelRow<format>::ink({10, 40, 90}));

    Bytes row = painted;
    PixelRow<format>{row.data(), 8, 5}.fade_from(before.data(), 8, 24, 255);
    CHECK(row == painted);
    PixelRow<format>{row.data(), 8, 5}.fade_from(before.data(), 11, 15, 0);
    CHECK(row == expected);
}

TEST_CASE("rgb565 is stored with the low byte first, rgb565_be with the high one")
{
    auto row = bytes({0, 0, 0, 0});
    PixelRow<PixelFormat::rgb565>{row.data(), 0, 0}.fill(1, 1,
                                                         PixelRow<PixelFormat::rgb565>::ink({255, 0, 8}));
    CHECK(row == bytes({0, 0, 0x01, 0xF8}));
    PixelRow<PixelFormat::rgb565_be>{row.data(), 0, 0}.fill(
        1, 1, PixelRow<PixelFormat::rgb565_be>::ink({255, 0, 8}));
    CHECK(row == bytes({0, 0, 0xF8, 0x01}));
}

TEST_CASE("rgb444 is stored in nibbles, red, green, blue, red, green, blue")
{
    auto row = bytes({0, 0, 0, 0, 0});
    PixelRow<PixelFormat::rgb444> pixels{row.data(), 0, 0};
    const std::uint32_t ink = PixelRow<PixelFormat::rgb444>::ink({0x11, 0x22, 0x33});
    pixels.fill(0, 1, ink);
    CHECK(row == bytes({0x12, 0x30, 0, 0, 0}));
    pixels.fill(1, 2, PixelRow<PixelFormat::rgb444>::ink({0xAA, 0xBB, 0xCC}));
    CHECK(row == bytes({0x12, 0x3A, 0xBC, 0xAB, 0xC0}));
}

TEST_CASE("rgb666 is stored in three bytes, each with its six bits in the highest")
{
    auto row = bytes({0, 0, 0, 0, 0, 0});
    PixelRow<PixelFormat::rgb666> pixels{row.data(), 0, 0};
    pixels.fill(1, 1, PixelRow<PixelFormat::rgb666>::ink({255, 0, 4}));
    CHECK(row == bytes({0, 0, 0, 0xFC, 0x00, 0x04}));
    pixels.blend(1, 1, PixelRow<PixelFormat::rgb666>::ink({0, 0, 255}), 128);
    CHECK(row == bytes({0, 0, 0, 31 << 2, 0x00, 32 << 2})); // 63 -> 31.4, 1 -> 32.1
}

/// Every channel, with neighbours that would show a carry.
TEST_CASE("rgb565 is blended exactly, for all values and coverages of each channel")
{
    using Row = PixelRow<PixelFormat::rgb565>;
    const auto blended = [](std::uint32_t under, std::uint32_t over, std::uint32_t coverage) {
        alignas(2) std::array row{static_cast<std::byte>(under & 255), static_cast<std::byte>(under >> 8)};
        Row{row.data(), 0, 0}.blend(0, 1, over, coverage);
        return std::to_integer<std::uint32_t>(row[0]) | std::to_integer<std::uint32_t>(row[1]) << 8;
    };
    const auto expected = [](std::uint32_t under, std::uint32_t over, std::uint32_t coverage) {
        const auto channel = [&](int shift, std::uint32_t max) {
            const std::uint32_t exact =
                (under >> shift & max) * (255 - coverage) + (over >> shift & max) * coverage;
            return (exact + 127) / 255 << shift;
        };
        return channel(11, 31) | channel(5, 63) | channel(0, 31);
    };
    for (const std::uint32_t others : {0U, 0xFFFFU})
        for (const auto& [shift, max] : {std::pair{11, 31U}, std::pair{5, 63U}, std::pair{0, 31U}})
            for (std::uint32_t under = 0; under <= max; ++under)
                for (std::uint32_t over = 0; over <= max; ++over)
                    for (std::uint32_t coverage = 0; coverage <= 255; ++coverage) {
                        const std::uint32_t base = others & ~(max << shift);
                        const std::uint32_t a = base | under << shift;
                        const std::uint32_t b = base | over << shift;
                        REQUIRE(blended(a, b, coverage) == expected(a, b, coverage));
                    }
}

TEST_CASE("rows of several pixels to a byte leave the neighbours alone")
{
    auto grey = bytes({0x12, 0x34});
    PixelRow<PixelFormat::grey4> grey_row{grey.data(), 0, 0};
    grey_row.fill(1, 2, 0xA);
    CHECK(grey == bytes({0x1A, 0xA4}));
    grey_row.blend(3, 1, 0xF, 128);
    CHECK(grey == bytes({0x1A, 0xAA}));

    auto mono = bytes({0b00000000, 0b11111111});
    PixelRow<PixelFormat::mono1> mono_row{mono.data(), 0, 0};
    mono_row.fill(6, 3, 1);
    CHECK(mono == bytes({0b00000011, 0b11111111}));
    mono_row.blend(9, 2, 0, 127);
    CHECK(mono == bytes({0b00000011, 0b11111111}));
    mono_row.blend(9, 2, 0, 128);
    CHECK(mono == bytes({0b00000011, 0b10011111}));
}

TEST_CASE("a row fades in proportion")
{
    auto colours = bytes({0x00, 0xF8, 0xFF, 0xFF, 0x1F, 0x00});
    const auto before = bytes({0x00, 0x00, 0x00, 0x00, 0x1F, 0x00});
    PixelRow<PixelFormat::rgb565>{colours.data(), 0, 0}.fade_from(before.data(), 0, 3, 128);
    CHECK(colours == bytes({0x00, 0x80, 0x10, 0x84, 0x1F, 0x00})); // 31 -> 16, 63 -> 32, rounded

    auto grey = bytes({0xF0, 0x3C});
    PixelRow<PixelFormat::grey4>{grey.data(), 0, 0}.fade_from(bytes({0x0F, 0x33}).data(), 0, 3, 51);
    CHECK(grey == bytes({0x3C, 0x3C}));
    auto mono = bytes({0b11000000});
    PixelRow<PixelFormat::mono1>{mono.data(), 0, 0}.fade_from(bytes({0b10100000}).data(), 0, 8, 127);
    CHECK(mono == bytes({0b10100000}));
}

TEST_CASE("dithered rows are lit by the place on the panel, wherever their area begins")
{
    using Row = PixelRow<PixelFormat::mono1_dithered>;
    auto whole = bytes({0, 0, 0});
    Row{whole.data(), 0, 9}.fill(3, 20, Row::ink({100, 100, 100}));
    auto area = bytes({0, 0});
    Row{area.data(), 8, 9}.fill(8, 15, Row::ink({100, 100, 100}));
    CHECK(whole[1] == area[0]);
    CHECK(whole[2] == area[1]);
    for (int x = 3; x < 23; ++x) {
        const int bit = std::to_integer<int>(whole[static_cast<std::size_t>(x / 8)]) >> (7 - x % 8) & 1;
        CHECK(bit == dither.is_lit(100, x, 9));
    }
}

TEST_CASE("what covers a dithered row in part is dithered too, towards what was there")
{
    using Row = PixelRow<PixelFormat::mono1_dithered>;
    for (int y = 0; y < 8; ++y) {
        auto dark = bytes({0x00});
        Row{dark.data(), 0, y}.blend(0, 8, Row::ink({255, 255, 255}), 90);
        CHECK(dark[0] == static_cast<std::byte>(dither.eight(90, y)));
        auto light = bytes({0xFF});
        Row{light.data(), 0, y}.blend(0, 8, Row::ink({0, 0, 0}), 90);
        CHECK(light[0] == static_cast<std::byte>(dither.eight(255 - 90, y)));
    }
}

TEST_CASE("a dithered grey is held between what a layer over it makes of black and of white")
{
    using Row = PixelRow<PixelFormat::mono1_dithered>;
    const auto lit = [](std::uint32_t brightness, int y) {
        return std::popcount(dither.eight(brightness, y));
    };
    for (std::uint32_t under = 0; under <= 255; under += 15)
        for (std::uint32_t over = 0; over <= 255; over += 15)
            for (std::uint32_t coverage = 0; coverage <= 255; coverage += 15)
                for (int y = 0; y < 8; ++y) {
                    auto row = bytes({0});
                    Row{row.data(), 0, y}.fill(0, 8, under);
                    Row{row.data(), 0, y}.blend(0, 8, over, coverage);
                    const std::uint32_t held = std::clamp(under, blend_channel(0, over, coverage),
                                                          blend_channel(255, over, coverage));
                    REQUIRE(std::popcount(std::to_integer<std::uint32_t>(row[0])) == lit(held, y));
                }
}

TEST_CASE("a row takes whole bytes")
{
    CHECK(row_bytes(PixelFormat::rgb565, 3) == 6);
    CHECK(row_bytes(PixelFormat::rgb444, 3) == 5);
    CHECK(row_bytes(PixelFormat::rgb666, 3) == 9);
    CHECK(row_bytes(PixelFormat::grey4, 3) == 2);
    CHECK(row_bytes(PixelFormat::mono1, 9) == 2);
}

TEST_CASE("pixels begin on bytes in every column, every second one or every eighth")
{
    CHECK(pixels_in_whole_bytes(PixelFormat::rgb565_be) == 1);
    CHECK(pixels_in_whole_bytes(PixelFormat::rgb444) == 2);
    CHECK(pixels_in_whole_bytes(PixelFormat::rgb666) == 1);
    CHECK(pixels_in_whole_bytes(PixelFormat::grey4) == 2);
    CHECK(pixels_in_whole_bytes(PixelFormat::mono1_dithered) == 8);
}

TEST_CASE("a format that is known at run time reaches the code made for it")
{
    for (const PixelFormat format : pixel_formats) {
        PixelFormat reached{};
        with_format(format, [&]<PixelFormat known>() { reached = known; });
        CHECK(reached == format);
    }
}

}
