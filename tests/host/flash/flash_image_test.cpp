#include "host/flash/flash_image.hpp"

#include <doctest/doctest.h>

#include <array>
#include <stdexcept>

namespace kfast::test {
namespace {

FlashRegion region(std::uint32_t address, std::size_t count, std::byte value)
{
    return {address, std::vector<std::byte>(count, value)};
}

}

TEST_CASE("an image consists of whole sectors in the order of their addresses")
{
    const FlashImage image{
        std::array{region(0x1004'0000, 4097, std::byte{2}), region(0x1000'0010, 3, std::byte{1})}};
    REQUIRE(image.sectors().size() == 3);
    CHECK(image.sectors()[0].address == 0x1000'0000);
    CHECK(image.sectors()[1].address == 0x1004'0000);
    CHECK(image.sectors()[2].address == 0x1004'1000);
    const auto& first = image.sectors()[0].bytes;
    CHECK(first[0x0F] == std::byte{0xFF});
    CHECK(first[0x10] == std::byte{1});
    CHECK(first[0x12] == std::byte{1});
    CHECK(first[0x13] == std::byte{0xFF});
    CHECK(image.sectors()[2].bytes[0] == std::byte{2});
    CHECK(image.sectors()[2].bytes[1] == std::byte{0xFF});
}

TEST_CASE("an image of nothing has no sectors")
{
    CHECK(FlashImage{std::span<const FlashRegion>{}}.sectors().empty());
    CHECK(FlashImage{std::array{region(0x1000'0000, 0, {})}}.sectors().empty());
}

TEST_CASE("an image has a sector once")
{
    const std::array twice{region(0x1000'0000, 16, {}), region(0x1000'0800, 16, {})};
    CHECK_THROWS_AS(FlashImage{twice}, std::invalid_argument);
    const std::array too_far{region(0xFFFF'F000, 4097, {})};
    CHECK_THROWS_AS(FlashImage{too_far}, std::invalid_argument);
}

}
