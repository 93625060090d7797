#include "host/simulator/flash_file.hpp"

#include "host/program/failure.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>
#include <fstream>
#include <stdexcept>

namespace kfast::test {
namespace {

constexpr std::size_t size = 4 * sector_bytes;

std::array<std::byte, page_bytes> page_of(std::byte byte)
{
    std::array<std::byte, page_bytes> page;
    page.fill(byte);
    return page;
}

bool is_all(std::span<const std::byte> bytes, std::byte byte)
{
    return std::ranges::all_of(bytes, [=](std::byte each) { return each == byte; });
}

TEST_CASE("a new file is erased flash")
{
    const TemporaryFolder folder;
    const FlashFile flash{folder / "flash", size};
    CHECK(flash.contents().size() == size);
    CHECK(is_all(flash.contents(), std::byte{0xFF}));
}

TEST_CASE("what flash holds outlives the program")
{
    const TemporaryFolder folder;
    const auto path = folder / "flash";
    {
        FlashFile flash{path, size};
        flash.program(sector_bytes + page_bytes, page_of(std::byte{0x5A}));
    }
    const FlashFile flash{path, size};
    CHECK(is_all(flash.contents().first(sector_bytes + page_bytes), std::byte{0xFF}));
    CHECK(is_all(flash.contents().subspan(sector_bytes + page_bytes, page_bytes), std::byte{0x5A}));
    CHECK(is_all(flash.contents().subspan(sector_bytes + 2 * page_bytes), std::byte{0xFF}));
}

TEST_CASE("programming clears bits, and erasing sets those of one sector")
{
    const TemporaryFolder folder;
    FlashFile flash{folder / "flash", size};
    flash.program(sector_bytes, page_of(std::byte{0xF0}));
    flash.program(sector_bytes, page_of(std::byte{0x3C}));
    flash.program(2 * sector_bytes, page_of(std::byte{0}));
    CHECK(is_all(flash.contents().subspan(sector_bytes, page_bytes), std::byte{0x30}));
    flash.erase(sector_bytes);
    CHECK(is_all(flash.contents().first(2 * sector_bytes), std::byte{0xFF}));
    CHECK(is_all(flash.contents().subspan(2 * sector_bytes, page_bytes), std::byte{0}));
}

TEST_CASE("firmware that breaks the rules of flash is found out")
{
    const TemporaryFolder folder;
    FlashFile flash{folder / "flash", size};
    CHECK_THROWS_AS(flash.erase(page_bytes), std::logic_error);
    CHECK_THROWS_AS(flash.erase(size), std::logic_error);
    CHECK_THROWS_AS(flash.program(1, page_of(std::byte{0})), std::logic_error);
    CHECK_THROWS_AS(flash.program(size, page_of(std::byte{0})), std::logic_error);
}

TEST_CASE("files that cannot be the flash are refused, and left as they are")
{
    const TemporaryFolder folder;
    const auto path = folder / "flash";
    SUBCASE("another size")
    {
        std::ofstream{path} << "a letter to somebody";
        CHECK_THROWS_WITH_AS((FlashFile{path, size}),
                             (path.string() + ": has 20 bytes, and the flash of this board 16384: "
                                              "is it another file?")
                                 .c_str(),
                             Failure);
        CHECK(std::filesystem::file_size(path) == 20);
    }
    SUBCASE("a folder that does not exist")
    {
        CHECK_THROWS_AS((FlashFile{folder / "none/flash", size}), Failure);
    }
    SUBCASE("in use")
    {
        const FlashFile first{path, size};
        CHECK_THROWS_WITH_AS(
            (FlashFile{path, size}),
            (path.string() + ": another simulated board uses it: name another file with --flash-file")
                .c_str(),
            Failure);
    }
}

}
}
