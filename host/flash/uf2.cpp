#include "host/flash/uf2.hpp"

#include "core/bytes/byte_reader.hpp"
#include "host/flash/flash_image.hpp"
#include "host/flash/uf2_contents.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace kfast {

namespace {

constexpr std::uint32_t first_magic = 0x0A32'4655;
constexpr std::uint32_t second_magic = 0x9E5D'5157;
constexpr std::uint32_t last_magic = 0x0AB1'6F30;

/// Between the first magic numbers and the payload, in the order of the format.
constexpr std::array fields{&Uf2Block::flags,  &Uf2Block::address, &Uf2Block::payload_bytes,
                            &Uf2Block::number, &Uf2Block::count,   &Uf2Block::family};

}

std::optional<Uf2Block> read_uf2_block(std::span<const std::byte, Uf2Block::bytes> bytes)
{
    ByteReader reader{bytes};
    ByteReader end{bytes.last<4>()};
    if (reader.u32() != first_magic || reader.u32() != second_magic || end.u32() != last_magic)
        return std::nullopt;
    Uf2Block block;
    for (const auto field : fields)
        block.*field = reader.u32();
    block.payload = reader.rest().first(std::min<std::size_t>(block.payload_bytes, Uf2Block::payload_room));
    return block;
}

void write_uf2_block(ByteWriter& file, const Uf2Block& block)
{
    constexpr std::array<std::byte, Uf2Block::payload_room> zeros{};
    file.u32(first_magic);
    file.u32(second_magic);
    for (const auto field : fields)
        file.u32(block.*field);
    file.append(block.payload);
    file.append(std::span{zeros}.subspan(block.payload.size()));
    file.u32(last_magic);
}

void write_uf2_sector(ByteWriter& file, const FlashImage::Sector& sector, const Uf2Block& first)
{
    Uf2Block block = first;
    for (std::uint32_t offset = 0; offset < sector.bytes.size(); offset += Uf2Block::payload_size) {
        block.address = sector.address + offset;
        block.payload = std::span{sector.bytes}.subspan(offset, Uf2Block::payload_size);
        write_uf2_block(file, block);
        ++block.number;
    }
}

namespace {

[[noreturn]] void refuse(std::size_t block, const std::string& reason)
{
    throw std::invalid_argument{"block " + std::to_string(block) + ": " + reason};
}

void require_family(const Uf2Part& part, std::uint32_t family)
{
    if (!part.family)
        refuse(part.first_block, "it does not say which chip family it is for");
    if (*part.family != family)
        refuse(part.first_block,
               "it is for the chip family " + hex_text(*part.family) + ", not " + hex_text(family));
}

}

std::vector<std::byte> uf2_of(std::span<const FlashRegion> regions, std::uint32_t family)
{
    const FlashImage image{regions};
    Uf2Block first{.count = static_cast<std::uint32_t>(image.sectors().size() * Uf2Block::per_sector),
                   .family = family};
    ByteWriter file;
    for (const FlashImage::Sector& sector : image.sectors()) {
        write_uf2_sector(file, sector, first);
        first.number += Uf2Block::per_sector;
    }
    return file.bytes();
}

std::vector<FlashRegion> regions_of(std::span<const std::byte> file, std::uint32_t family)
{
    if (file.empty() || file.size() % Uf2Block::bytes != 0)
        throw std::invalid_argument{"a UF2 file is made of blocks of 512 bytes; this one has " +
                                    std::to_string(file.size()) + " bytes"};
    Uf2Contents contents = read_uf2(file);
    for (const Uf2Part& part : contents.parts)
        require_family(part, family);
    if (!contents.mistakes.empty())
        refuse(contents.mistakes.front().block, contents.mistakes.front().reason);
    return std::move(contents.parts.front().regions);
}

}
