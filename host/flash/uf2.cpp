#include "host/flash/uf2.hpp"

#include "host/flash/flash_image.hpp"
#include "host/flash/hex_text.hpp"
#include "host/flash/uf2_block.hpp"
#include "host/flash/uf2_contents.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace kfast {
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
