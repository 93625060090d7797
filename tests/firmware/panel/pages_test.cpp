#include "firmware/panel/pages.hpp"

#include "core/math/point.hpp"
#include "core/pixel/pixel_format.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

namespace kfast::test {
namespace {

bool lit_in_rows(const std::vector<std::byte>& rows, int width, int x, int y)
{
    const std::size_t at = static_cast<std::size_t>(y) * row_bytes(PixelFormat::mono1, width);
    return (std::to_integer<int>(rows[at + static_cast<std::size_t>(x / 8)]) >> (7 - x % 8) & 1) != 0;
}

bool lit_in_pages(const std::vector<std::byte>& pages, int width, int x, int y)
{
    return (std::to_integer<int>(pages[static_cast<std::size_t>(y / 8 * width + x)]) >> (y % 8) & 1) != 0;
}

/// Bytes without a pattern, the same in every run.
std::vector<std::byte> noise(std::size_t count)
{
    std::vector<std::byte> bytes(count);
    std::uint32_t state = 1;
    for (auto& byte : bytes) {
        state = state * 1664525 + 1013904223;
        byte = static_cast<std::byte>(state >> 24);
    }
    return bytes;
}

}

TEST_CASE("every pixel of the rows is where the pages have it")
{
    for (const Size size : {Size{8, 8}, {24, 16}, {72, 40}, {128, 64}}) {
        CAPTURE(size.width);
        const auto rows = noise(static_cast<std::size_t>(size.width * size.height / 8));
        std::vector<std::byte> pages(rows.size(), std::byte{0xA5});
        fill_pages(rows, row_bytes(PixelFormat::mono1, size.width), pages);
        int wrong = 0;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x)
                wrong += lit_in_rows(rows, size.width, x, y) != lit_in_pages(pages, size.width, x, y);
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("the left upper pixel is the lowest bit of the first byte")
{
    std::vector<std::byte> rows(8);
    rows[0] = std::byte{0x80};
    rows[7] = std::byte{0x01};
    std::vector<std::byte> pages(8);
    fill_pages(rows, 1, pages);
    CHECK(pages.front() == std::byte{0x01});
    CHECK(pages.back() == std::byte{0x80});
}

}
