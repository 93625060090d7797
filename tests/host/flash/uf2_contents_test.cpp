#include "host/flash/uf2_contents.hpp"

#include "host/flash/uf2.hpp"

#include <doctest/doctest.h>

#include <string>
#include <tuple>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::uint32_t flash = 0x1000'0000;
constexpr std::uint32_t other_family = 0xada5'2840;

const std::vector<std::byte> payload(256, std::byte{7});

/// Those of one family, one page after the other.
std::vector<Uf2Block> some_blocks(std::uint32_t count, std::uint32_t family = rp2040_family)
{
    std::vector<Uf2Block> blocks;
    for (std::uint32_t number = 0; number < count; ++number)
        blocks.push_back({.address = flash + number * 256,
                          .number = number,
                          .count = count,
                          .family = family,
                          .payload = payload});
    return blocks;
}

std::vector<std::byte> file_of(const std::vector<Uf2Block>& blocks)
{
    ByteWriter file;
    for (const Uf2Block& block : blocks)
        write_uf2_block(file, block);
    return file.bytes();
}

/// "3: reason; 4: reason"
std::string mistakes_in(std::span<const std::byte> file)
{
    std::string text;
    for (const auto& [block, reason] : read_uf2(file).mistakes)
        text += (text.empty() ? "" : "; ") + std::to_string(block) + ": " + reason;
    return text;
}

/// In a file of six blocks whose fourth one was changed.
std::string mistakes_with(const auto& change)
{
    auto blocks = some_blocks(6);
    change(blocks[3]);
    return mistakes_in(file_of(blocks));
}

}

TEST_CASE("the block that picotool puts in front for the RP2350 is left out")
{
    constexpr std::uint32_t rp2350_family = 0xe48b'ff59;
    const std::vector<std::byte> filler(256, std::byte{0xEF});
    const Uf2Block extra{
        .flags = 0xA000, .address = 0x10ff'ff00, .count = 2, .family = 0xe48b'ff57, .payload = filler};
    auto blocks = some_blocks(3, rp2350_family);
    blocks.insert(blocks.begin(), extra);
    const Uf2Contents contents = read_uf2(file_of(blocks));
    CHECK(contents.mistakes.empty());
    CHECK(contents.blocks == 4);
    REQUIRE(contents.parts.size() == 1);
    CHECK(contents.parts[0].family == rp2350_family);
    CHECK(contents.parts[0].first_block == 1);

    blocks[0].payload = payload;
    CHECK(mistakes_in(file_of(blocks)) ==
          "0: it says that there are 2 blocks for its chips, but there are 1");
    CHECK(mistakes_in(file_of({extra})) == "1: there is nothing to be written");
}

TEST_CASE("a file tells what it has for each family of chips")
{
    auto blocks = some_blocks(3);
    auto others = some_blocks(2, other_family);
    others[1].address += 0x1000;
    blocks.insert(blocks.begin() + 1, others.begin(), others.end());
    const Uf2Contents contents = read_uf2(file_of(blocks));
    CHECK(contents.mistakes.empty());
    CHECK(contents.blocks == 5);
    REQUIRE(contents.parts.size() == 2);
    const auto& [rp2040, other] = std::tie(contents.parts[0], contents.parts[1]);
    CHECK(rp2040.family == rp2040_family);
    CHECK(rp2040.blocks == 3);
    CHECK(rp2040.flags == 0x2000);
    CHECK(rp2040.regions == std::vector{FlashRegion{flash, std::vector<std::byte>(768, std::byte{7})}});
    CHECK(other.family == other_family);
    CHECK(other.first_block == 1);
    CHECK(other.regions == std::vector{FlashRegion{flash, payload}, FlashRegion{flash + 0x1100, payload}});
}

TEST_CASE("blocks need not name a family, and need not be of 256 bytes then")
{
    auto blocks = some_blocks(2);
    const std::vector<std::byte> longest(476, std::byte{1});
    for (Uf2Block& block : blocks)
        block = {.flags = 0x4000,
                 .address = block.number * 476,
                 .payload_bytes = 476,
                 .number = block.number,
                 .count = 2,
                 .family = 12345,
                 .payload = longest};
    const Uf2Contents contents = read_uf2(file_of(blocks));
    CHECK(contents.mistakes.empty());
    REQUIRE(contents.parts.size() == 1);
    CHECK_FALSE(contents.parts[0].family);
    CHECK(contents.parts[0].flags == 0x4000);
    REQUIRE(contents.parts[0].regions.size() == 1);
    CHECK(contents.parts[0].regions[0].bytes.size() == 952);
}

TEST_CASE("blocks of other chips that are not for flash are left out")
{
    auto blocks = some_blocks(2, other_family);
    blocks[1].flags |= Uf2Block::not_for_flash;
    const Uf2Contents contents = read_uf2(file_of(blocks));
    CHECK(contents.mistakes.empty());
    CHECK(contents.parts[0].regions == std::vector{FlashRegion{flash, payload}});
}

TEST_CASE("what is wrong with a block is told, and the others are not blamed for it")
{
    CHECK(mistakes_with([](Uf2Block&) {}).empty());
    CHECK(mistakes_with([](Uf2Block& block) { block.payload_bytes = 128; }) ==
          "3: it carries 128 bytes where an RP2040 takes 256 alone");
    CHECK(mistakes_with([](Uf2Block& block) { block.address += 4; }) ==
          "3: its address 0x10000304 is no multiple of 256");
    CHECK(mistakes_with([](Uf2Block& block) { block.address = 0x0FFF'FF00; }) ==
          "3: its address 0x0fffff00 is neither in flash nor in RAM of an RP2040");
    CHECK(mistakes_with([](Uf2Block& block) { block.address = 0x2004'1F04; }) ==
          "3: its address 0x20041f04 is neither in flash nor in RAM of an RP2040");
    CHECK(mistakes_with([](Uf2Block& block) { block.address = 0x2004'1F00; }).empty());
    CHECK(mistakes_with([](Uf2Block& block) { block.address = flash + 0x100; }) ==
          "3: it writes to 0x10000100, as block 1 has done before");
    CHECK(mistakes_with([](Uf2Block& block) { block.flags |= 0x1; }) ==
          "3: it is not for flash, so that an RP2040 leaves it out");
    CHECK(mistakes_with([](Uf2Block& block) { block.flags |= 0x1000; }) == "3: it is part of a stored file");
    CHECK(mistakes_with([](Uf2Block& block) { block.number = 9; }) ==
          "3: it calls itself block 9 where block 3 should come; "
          "4: it calls itself block 4 where block 10 should come");
    CHECK(mistakes_with([](Uf2Block& block) { block.count = 7; }) ==
          "3: it says that there are 7 blocks, but those before it said 6; "
          "4: it says that there are 6 blocks, but those before it said 7");
}

TEST_CASE("blocks of other chips have rules as well")
{
    const auto mistakes_of = [](const Uf2Block& block) { return mistakes_in(file_of({block})); };
    const Uf2Block right{.address = 4, .count = 1, .family = other_family, .payload = payload};
    CHECK(mistakes_of(right).empty());
    Uf2Block wrong = right;
    wrong.address = 2;
    CHECK(mistakes_of(wrong) == "0: its address 0x00000002 is no multiple of 4");
    wrong.address = 0xFFFF'FF04;
    CHECK(mistakes_of(wrong) == "0: its address 0xffffff04 is too near to the last one of 32 bits");
    wrong = right;
    wrong.payload_bytes = 477;
    CHECK(mistakes_of(wrong) == "0: it carries 477 bytes where there is room for 1 to 476");
    wrong.payload_bytes = 0;
    CHECK(mistakes_of(wrong) == "0: it carries 0 bytes where there is room for 1 to 476");
}

TEST_CASE("a block that is none does not put the numbers of the others into disorder")
{
    for (const std::size_t spoiled : {0U, 1U, 5U}) {
        auto file = file_of(some_blocks(6));
        file[spoiled * 512 + 4] ^= std::byte{1};
        CHECK(mistakes_in(file) ==
              std::to_string(spoiled) + ": it does not begin and end as a block of a UF2 file");
    }
}

TEST_CASE("a file that is cut short or empty is told of")
{
    const auto file = file_of(some_blocks(3));
    CHECK(mistakes_in(std::span{file}.first(1300)) ==
          "0: it says that there are 3 blocks for its chips, but there are 2; "
          "2: the file ends after 276 of its 512 bytes: it was cut off, or is no UF2 file");
    CHECK(mistakes_in({}) == "0: the file is empty");
    const std::vector<std::byte> text(700, std::byte{'a'});
    CHECK(mistakes_in(text) ==
          "0: it does not begin and end as a block of a UF2 file; "
          "1: the file ends after 188 of its 512 bytes: it was cut off, or is no UF2 file");
}

TEST_CASE("a block that reaches into the next one is told of")
{
    auto blocks = some_blocks(2, other_family);
    blocks[0].address = flash + 128;
    CHECK(mistakes_in(file_of(blocks)) == "1: it writes to 0x10000100, as block 0 has done before");
}

}
