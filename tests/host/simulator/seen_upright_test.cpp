#include "tests/host/simulator/wired_model.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// 3 x 2 pixels:  1 2 3
///                4 5 6
template <PixelFormat format>
Frame glass()
{
    return painted_frame<format>(
        {3, 2}, [](int x, int y) -> std::uint32_t { return static_cast<std::uint32_t>(1 + x + 3 * y); });
}

template <PixelFormat format>
void check_turns()
{
    const auto upright = [](Rotation rotation, Size size) {
        const Frame frame = seen_upright(glass<format>(), rotation);
        CHECK(frame.size == size);
        CHECK(frame.pixels.size() == row_bytes(format, size.width) * static_cast<std::size_t>(size.height));
        return pixels_of<format>(frame);
    };
    CHECK(upright(Rotation::none, {3, 2}) == std::vector{1, 2, 3, 4, 5, 6});
    CHECK(upright(Rotation::quarter, {2, 3}) == std::vector{3, 6, 2, 5, 1, 4});
    CHECK(upright(Rotation::half, {3, 2}) == std::vector{6, 5, 4, 3, 2, 1});
    CHECK(upright(Rotation::three_quarters, {2, 3}) == std::vector{4, 1, 5, 2, 6, 3});
}

}

TEST_CASE("a glass is seen upright in colours and in greys")
{
    check_turns<PixelFormat::rgb565>();
    check_turns<PixelFormat::grey4>();
}

TEST_CASE("a glass is seen upright in single bits")
{
    // #..   lies so on the glass
    // ##.
    Frame frame{PixelFormat::mono1, {3, 2}, bytes({0x80, 0xC0})};
    CHECK(seen_upright(frame, Rotation::none).pixels == bytes({0x80, 0xC0}));
    CHECK(seen_upright(frame, Rotation::quarter).pixels == bytes({0x00, 0x40, 0xC0}));
    CHECK(seen_upright(frame, Rotation::half).pixels == bytes({0x60, 0x20}));
    CHECK(seen_upright(frame, Rotation::three_quarters).pixels == bytes({0xC0, 0x80, 0x00}));
}

}
