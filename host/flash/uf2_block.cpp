#include "host/flash/uf2_block.hpp"

#include "core/bytes/byte_reader.hpp"

#include <algorithm>
#include <array>

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

}
