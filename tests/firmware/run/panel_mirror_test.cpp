#include "firmware/run/panel_mirror.hpp"

#include "tests/bytes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

std::uint32_t crc(std::initializer_list<int> values)
{
    Crc32 crc;
    crc.add(bytes(values));
    return crc.value();
}

}

TEST_CASE("a mirror holds what was sent, wherever it lies")
{
    PanelMirror<PixelFormat::grey4, 6, 3> mirror;
    CHECK(mirror.hash() == crc({0, 0, 0, 0, 0, 0, 0, 0, 0}));
    mirror.take({0, 0, 6, 2}, bytes({1, 2, 3, 4, 5, 6}));
    mirror.take({2, 1, 4, 2}, bytes({7, 8, 9, 10}));
    CHECK(mirror.hash() == crc({1, 2, 3, 4, 7, 8, 0, 9, 10}));
    CHECK(std::ranges::equal(mirror.bytes(), bytes({1, 2, 3, 4, 7, 8, 0, 9, 10})));
}

}
