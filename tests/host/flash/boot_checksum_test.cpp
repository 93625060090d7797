#include "host/flash/boot_checksum.hpp"

#include "tests/bytes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace kfast::test {
namespace {

std::vector<std::byte> counted(std::size_t count)
{
    std::vector<std::byte> bytes(count);
    std::ranges::generate(bytes, [value = 0]() mutable { return static_cast<std::byte>(value++); });
    return bytes;
}

}

TEST_CASE("the checksum is CRC-32/MPEG-2")
{
    CHECK(boot_checksum(std::as_bytes(std::span{std::string_view{"123456789"}})) == 0x0376'E6E7);
    CHECK(boot_checksum(std::vector<std::byte>(252)) == 0x7065'399A);
    CHECK(boot_checksum(counted(252)) == 0xB454'E2A8);
    CHECK(boot_checksum({}) == 0xFFFF'FFFF);
}

TEST_CASE("a boot block is padded with zeros and ends with the checksum, low byte first")
{
    const BootBlock whole = with_boot_checksum(counted(252));
    CHECK(std::ranges::equal(std::span{whole}.first(252), counted(252)));
    CHECK(std::ranges::equal(std::span{whole}.last(4), bytes({0xA8, 0xE2, 0x54, 0xB4})));

    const BootBlock empty = with_boot_checksum({});
    CHECK(std::ranges::equal(std::span{empty}.last(6), bytes({0, 0, 0x9A, 0x39, 0x65, 0x70})));
}

TEST_CASE("code that leaves no room for the checksum is refused")
{
    CHECK_THROWS_WITH_AS(with_boot_checksum(counted(253)),
                         "the code of a boot block has at most 252 bytes; this has 253",
                         std::invalid_argument);
}

}
