#include "firmware/slots/slot_directory.hpp"

#include "tests/bytes.hpp"
#include "tests/firmware/slots/first_version.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace kfast::test {
namespace {

constexpr std::uint32_t pool_bytes = 64 * sector_bytes;

SlotDirectory unusual_directory()
{
    SlotDirectory directory{.generation = 0x01020304, .chosen = 7, .next = 5 * sector_bytes};
    directory.bad_copies = 4;
    directory.bad_sectors.add(0);
    directory.bad_sectors.add(63);
    directory.slots[0] = {{"eyes"}, 2 * sector_bytes, 4097, 0xA1B2C3D4};
    directory.slots[7] = {{"a name of 24 bytes here!"}, 63 * sector_bytes, sector_bytes, 9};
    return directory;
}

std::optional<SlotDirectory> read_back(const SlotDirectory& directory)
{
    return read_slot_directory(slot_directory_pages_of(directory), pool_bytes);
}

}

TEST_CASE("a directory of slots comes back as it was written")
{
    CHECK(read_back({}) == SlotDirectory{});
    CHECK(read_back(unusual_directory()) == unusual_directory());
}

TEST_CASE("fields of a directory lie where their description says")
{
    const SlotDirectoryPages pages = slot_directory_pages_of(unusual_directory());
    CHECK(pages.size() == 512);
    CHECK(std::ranges::equal(
        std::span{pages}.first(24),
        bytes({'K', 'F', 'S', 'D', 2, 0, 8, 0, 4, 3, 2, 1, 0, 0x50, 0, 0, 7, 4, 0, 0, 'e', 'y', 'e', 's'})));
    CHECK(std::ranges::equal(std::span{pages}.subspan(44, 12),
                             bytes({0, 0x20, 0, 0, 1, 0x10, 0, 0, 0xD4, 0xC3, 0xB2, 0xA1})));
    CHECK(std::ranges::equal(std::span{pages}.subspan(308, 9), bytes({1, 0, 0, 0, 0, 0, 0, 0x80, 0})));
    CHECK(std::ranges::all_of(std::span{pages}.subspan(slot_directory_bytes),
                              [](std::byte byte) { return byte == std::byte{0xFF}; }));
}

TEST_CASE("a directory with any bit wrong is none")
{
    const auto expect_no_bit_wrong = [](const SlotDirectoryPages& pages, std::size_t size) {
        REQUIRE(read_slot_directory(pages, pool_bytes));
        for (std::size_t bit = 0; bit < 8 * size; ++bit) {
            SlotDirectoryPages damaged = pages;
            damaged[bit / 8] ^= std::byte{1} << bit % 8;
            CHECK_FALSE(read_slot_directory(damaged, pool_bytes));
        }
    };
    expect_no_bit_wrong(slot_directory_pages_of(unusual_directory()), slot_directory_bytes);
    expect_no_bit_wrong(first_version_of(unusual_directory()), first_version_bytes);
}

TEST_CASE("a directory that breaks off is none")
{
    const SlotDirectoryPages pages = slot_directory_pages_of(unusual_directory());
    CHECK(read_slot_directory(std::span{pages}.first(slot_directory_bytes), pool_bytes));
    for (std::size_t size = 0; size < slot_directory_bytes; ++size)
        CHECK_FALSE(read_slot_directory(std::span{pages}.first(size), pool_bytes));
}

TEST_CASE("a directory of the first version is read, which knows of no bad sectors")
{
    SlotDirectory expected = unusual_directory();
    expected.bad_copies = 0;
    expected.bad_sectors = {};
    CHECK(read_slot_directory(first_version_of(unusual_directory()), pool_bytes) == expected);
}

TEST_CASE("a directory whose scenes would not lie in the pool is none, though its checksum is right")
{
    const auto with = [](const SlotEntry& entry) {
        SlotDirectory directory;
        directory.slots[3] = entry;
        return directory;
    };
    CHECK(read_back(with({{}, 63 * sector_bytes, sector_bytes, 0})));
    CHECK_FALSE(read_back(with({{}, 63 * sector_bytes, sector_bytes + 1, 0})));
    CHECK_FALSE(read_back(with({{}, 64 * sector_bytes, 1, 0})));
    CHECK_FALSE(read_back(with({{}, 0xFFFFF000, 0x2000, 0})));
    CHECK_FALSE(read_back(with({{}, 1, 1, 0})));
    CHECK_FALSE(read_back({.chosen = 8}));
    CHECK_FALSE(read_back({.next = 65 * sector_bytes}));
    CHECK_FALSE(read_back({.next = 1}));
}

TEST_CASE("of two generations the one that was counted later is newer, also across the wrap")
{
    CHECK(is_newer({.generation = 8}, {.generation = 7}));
    CHECK_FALSE(is_newer({.generation = 7}, {.generation = 8}));
    CHECK_FALSE(is_newer({.generation = 7}, {.generation = 7}));
    CHECK(is_newer({.generation = 0}, {.generation = 0xFFFFFFFF}));
    CHECK_FALSE(is_newer({.generation = 0xFFFFFFFF}, {.generation = 0}));
}

}
