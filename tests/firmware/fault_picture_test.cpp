#include "firmware/fault_picture.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace kfast::test {
namespace {

/// '#' for white, '.' for black, '?' for anything else; the rows are sullied before they are drawn.
template <PixelFormat format>
std::vector<std::string> drawn(Error error, Size panel)
{
    using Row = PixelRow<format>;
    const FaultPicture picture{error, panel};
    std::vector<std::string> rows;
    for (int y = 0; y < panel.height; ++y) {
        std::vector<std::byte> pixels(row_bytes(format, panel.width), std::byte{0x5A});
        picture.draw_row(Row{pixels.data(), 0, y}, panel.width);
        std::string& text = rows.emplace_back();
        for (int x = 0; x < panel.width; ++x) {
            const std::uint32_t pixel = PixelCoding<format>::load(pixels.data(), x);
            text += pixel == Row::ink({}) ? '.' : pixel == Row::ink({255, 255, 255}) ? '#' : '?';
        }
    }
    return rows;
}

}

TEST_CASE("a fault is shown as E and its number")
{
    CHECK(drawn<PixelFormat::mono1>(Error::bad_checksum, {9, 7}) == std::vector<std::string>{
                                                                        ".........", //
                                                                        ".###.#.#.", //
                                                                        ".#...#.#.", //
                                                                        ".###.###.", //
                                                                        ".#.....#.", //
                                                                        ".###...#.", //
                                                                        ".........",
                                                                    });
    CHECK(drawn<PixelFormat::rgb565>(Error::block_too_small, {9, 7}) == std::vector<std::string>{
                                                                            ".........", //
                                                                            ".###.###.", //
                                                                            ".#...#...", //
                                                                            ".###.###.", //
                                                                            ".#...#.#.", //
                                                                            ".###.###.", //
                                                                            ".........",
                                                                        });
}

TEST_CASE("a fault is as large as the panel allows, in its middle")
{
    CHECK(drawn<PixelFormat::grey4>(Error::truncated, {20, 17}) == std::vector<std::string>{
                                                                       "....................", //
                                                                       "....................", //
                                                                       "....................", //
                                                                       "...######....##.....", //
                                                                       "...######....##.....", //
                                                                       "...##......####.....", //
                                                                       "...##......####.....", //
                                                                       "...######....##.....", //
                                                                       "...######....##.....", //
                                                                       "...##........##.....", //
                                                                       "...##........##.....", //
                                                                       "...######..######...", //
                                                                       "...######..######...", //
                                                                       "....................", //
                                                                       "....................", //
                                                                       "....................", //
                                                                       "....................",
                                                                   });
}

TEST_CASE("a panel that is too small for a fault is black")
{
    CHECK(drawn<PixelFormat::grey4>(Error::truncated, {8, 2}) == std::vector<std::string>(2, "........"));
}

}
