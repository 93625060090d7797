#include "host/picture/picture.hpp"

#include "tests/bytes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

bool same(const Picture& picture, const std::vector<Colour>& expected) { return picture.pixels == expected; }

constexpr Colour grey(std::uint8_t level) { return {level, level, level}; }

}

TEST_CASE("rgb565 widens each channel to the whole range")
{
    const Frame frame{PixelFormat::rgb565, {4, 1}, bytes({0xFF, 0xFF, 0x00, 0x80, 0x20, 0x00, 0x01, 0x00})};
    CHECK(same(widen(frame), {{255, 255, 255}, {132, 0, 0}, {0, 4, 0}, {0, 0, 8}}));
}

TEST_CASE("rgb565_be holds the high byte first")
{
    const Frame frame{PixelFormat::rgb565_be, {3, 1}, bytes({0x80, 0x00, 0x00, 0x20, 0x00, 0x01})};
    CHECK(same(widen(frame), {{132, 0, 0}, {0, 4, 0}, {0, 0, 8}}));
}

TEST_CASE("rgb444 holds two pixels in three bytes, rows begin on a byte")
{
    const Frame frame{PixelFormat::rgb444,
                      {3, 2},
                      bytes({0x12, 0x34, 0x56, 0xF0, 0x80, //
                             0, 0, 0, 0x00, 0x10})};
    CHECK(same(widen(frame), {{17, 34, 51}, {68, 85, 102}, {255, 0, 136}, {}, {}, {0, 0, 17}}));
}

TEST_CASE("rgb666 holds each channel in the high bits of a byte")
{
    const Frame frame{PixelFormat::rgb666, {2, 1}, bytes({0xFC, 0x80, 0x00, 0x00, 0x04, 0x08})};
    CHECK(same(widen(frame), {{255, 130, 0}, {0, 4, 8}}));
}

TEST_CASE("grey4 holds the left pixel in the high nibble, rows begin on a byte")
{
    const Frame frame{PixelFormat::grey4, {3, 2}, bytes({0x0F, 0x70, 0x12, 0x30})};
    CHECK(same(widen(frame), {grey(0), grey(255), grey(119), grey(17), grey(34), grey(51)}));
}

TEST_CASE("mono1 holds the leftmost pixel in the highest bit, rows begin on a byte")
{
    for (const PixelFormat format : {PixelFormat::mono1, PixelFormat::mono1_dithered}) {
        const Picture picture = widen({format, {9, 2}, bytes({0x80, 0x80, 0x01, 0x00})});
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 9; ++x) {
                const bool lit = y == 0 ? x == 0 || x == 8 : x == 7;
                CHECK(picture.at(x, y) == grey(lit ? 255 : 0));
            }
    }
}

TEST_CASE("the hash of a frame is the CRC-32 of its bytes")
{
    const Frame frame{PixelFormat::grey4, {18, 1}, bytes({'1', '2', '3', '4', '5', '6', '7', '8', '9'})};
    CHECK(hash(frame) == 0xCBF43926);
}

}
