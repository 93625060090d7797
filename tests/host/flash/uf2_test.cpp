#include "host/flash/uf2.hpp"

#include "core/bytes/byte_reader.hpp"
#include "tests/bytes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace kfast::test {
namespace {

constexpr std::uint32_t flash = 0x1000'0000;
constexpr std::byte unwritten{0xFF};

FlashRegion region(std::uint32_t address, std::size_t count, std::byte value)
{
    return {address, std::vector<std::byte>(count, value)};
}

std::vector<std::byte> file_of(std::initializer_list<FlashRegion> regions)
{
    return uf2_of(std::span{regions});
}

std::array<std::uint32_t, 8> head_of_block(std::span<const std::byte> file, std::size_t number)
{
    ByteReader reader{file.subspan(number * 512)};
    std::array<std::uint32_t, 8> fields{};
    std::ranges::generate(fields, [&reader] { return reader.u32(); });
    return fields;
}

/// A file of one sector with one byte changed.
std::vector<std::byte> spoiled(std::size_t offset, int value)
{
    auto file = file_of({region(flash, 4096, std::byte{1})});
    file[offset] = static_cast<std::byte>(value);
    return file;
}

void check_refused(std::span<const std::byte> file, const std::string& text)
{
    CAPTURE(text);
    CHECK_THROWS_WITH_AS(regions_of(file), text.c_str(), std::invalid_argument);
}

}

TEST_CASE("a block has the fields of the UF2 format")
{
    const auto file = file_of({{flash, bytes({1, 2, 3})}});
    REQUIRE(file.size() == 16 * 512);
    CHECK(head_of_block(file, 0) ==
          std::array<std::uint32_t, 8>{0x0A324655, 0x9E5D5157, 0x2000, flash, 256, 0, 16, 0xE48BFF56});
    CHECK(head_of_block(file, 15) == std::array<std::uint32_t, 8>{0x0A324655, 0x9E5D5157, 0x2000,
                                                                  flash + 0xF00, 256, 15, 16, 0xE48BFF56});
    CHECK(std::ranges::equal(std::span{file}.subspan(32, 4), bytes({1, 2, 3, 0xFF})));
    CHECK(std::ranges::equal(std::span{file}.subspan(32 + 256, 220), std::vector<std::byte>(220)));
    CHECK(std::ranges::equal(std::span{file}.subspan(508, 4), bytes({0x30, 0x6F, 0xB1, 0x0A})));
}

TEST_CASE("every sector is whole and begins at a block number divisible by 16")
{
    const auto file = file_of({region(flash + 0x40000, 4097, std::byte{2}), region(flash, 1, std::byte{1})});
    REQUIRE(file.size() == 3 * 16 * 512);
    for (std::size_t block = 0; block < 48; ++block) {
        const auto fields = head_of_block(file, block);
        CHECK(fields[5] == block);
        CHECK(fields[6] == 48);
        CHECK(fields[3] % 4096 == block % 16 * 256);
    }
    CHECK(head_of_block(file, 0)[3] == flash);
    CHECK(head_of_block(file, 16)[3] == flash + 0x40000);
    CHECK(head_of_block(file, 32)[3] == flash + 0x41000);
}

TEST_CASE("regions come back padded and joined")
{
    const auto found = regions_of(
        file_of({region(flash + 0x3000, 4096, std::byte{3}), region(flash + 0x10, 0x20, std::byte{1}),
                 region(flash + 0x4000, 1, std::byte{4})}));
    REQUIRE(found.size() == 2);
    CHECK(found[0].address == flash);
    CHECK(found[0].bytes.size() == 4096);
    CHECK(found[0].bytes[0x0F] == unwritten);
    CHECK(found[0].bytes[0x10] == std::byte{1});
    CHECK(found[0].bytes[0x2F] == std::byte{1});
    CHECK(found[0].bytes[0x30] == unwritten);
    CHECK(found[1].address == flash + 0x3000);
    CHECK(found[1].bytes.size() == 8192);
    CHECK(found[1].bytes[0xFFF] == std::byte{3});
    CHECK(found[1].bytes[0x1000] == std::byte{4});
    CHECK(found[1].bytes[0x1001] == unwritten);
}

TEST_CASE("an empty region has no sector")
{
    CHECK(file_of({}).empty());
    CHECK(file_of({region(flash, 0, {})}).empty());
}

TEST_CASE("the last sector of 32 bits can be written")
{
    const std::array last{region(0xFFFF'F000, 4096, std::byte{9})};
    constexpr std::uint32_t other_family = 0x1234'5678;
    CHECK(std::ranges::equal(regions_of(uf2_of(last, other_family), other_family), last));
    CHECK_THROWS_AS(regions_of(uf2_of(last)), std::invalid_argument);
}

TEST_CASE("regions that cannot be written are refused")
{
    const char* const twice =
        "two regions lie in the sector of 4096 bytes at 0x10001000, which can be written once only";
    CHECK_THROWS_WITH_AS(
        file_of({region(flash, 8192, std::byte{1}), region(flash + 0x1800, 16, std::byte{1})}), twice,
        std::invalid_argument);
    CHECK_THROWS_WITH_AS(
        file_of({region(flash + 0x1000, 16, std::byte{1}), region(flash + 0x1800, 16, std::byte{1})}), twice,
        std::invalid_argument);
    CHECK_THROWS_WITH_AS(file_of({region(0xFFFF'F000, 4097, std::byte{1})}),
                         "the region at 0xfffff000 ends at 0x100000001, beyond the last address of 32 bits",
                         std::invalid_argument);
}

TEST_CASE("a malformed file is refused with the block and the reason")
{
    const auto whole = file_of({region(flash, 4096, std::byte{1})});
    check_refused({}, "a UF2 file is made of blocks of 512 bytes; this one has 0 bytes");
    check_refused(std::span{whole}.first(700),
                  "a UF2 file is made of blocks of 512 bytes; this one has 700 bytes");
    check_refused(std::span{whole}.first(512 * 15),
                  "block 0: it says that there are 16 blocks for its chips, but there are 15");
    for (const std::size_t magic : {0U, 4U, 508U})
        check_refused(spoiled(512 * 3 + magic, 7),
                      "block 3: it does not begin and end as a block of a UF2 file");
    check_refused(spoiled(8, 1), "block 0: it is not for flash, so that an RP2040 leaves it out");
    check_refused(spoiled(9, 0x30), "block 0: it is part of a stored file");
    check_refused(spoiled(9, 0), "block 0: it does not say which chip family it is for");
    check_refused(spoiled(512 + 12, 0x80), "block 1: its address 0x10000180 is no multiple of 256");
    check_refused(spoiled(512 + 13, 0), "block 1: it writes to 0x10000000, as block 0 has done before");
    check_refused(spoiled(16, 4), "block 0: it carries 260 bytes where an RP2040 takes 256 alone");
    check_refused(spoiled(512 * 15 + 20, 14),
                  "block 15: it calls itself block 14 where block 15 should come");
    check_refused(spoiled(512 * 2 + 28, 0x57),
                  "block 2: it is for the chip family 0xe48bff57, not 0xe48bff56");
}

}
