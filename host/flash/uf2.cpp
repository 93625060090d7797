#include "host/flash/uf2.hpp"

#include "host/flash/flash_image.hpp"
#include "host/flash/hex_text.hpp"
#include "host/flash/uf2_block.hpp"

#include <map>
#include <stdexcept>
#include <string>

namespace kfast {
namespace {

class FileReader {
public:
    FileReader(std::span<const std::byte> file, std::uint32_t family) : file_{file}, family_{family} {}

    std::vector<FlashRegion> regions()
    {
        if (file_.empty() || file_.size() % Uf2Block::bytes != 0)
            throw std::invalid_argument{"a UF2 file is made of blocks of 512 bytes; this one has " +
                                        std::to_string(file_.size()) + " bytes"};
        for (; number_ < count(); ++number_)
            read_block(read_uf2_block(file_.subspan(number_ * Uf2Block::bytes).first<Uf2Block::bytes>()));
        return joined();
    }

private:
    std::size_t count() const { return file_.size() / Uf2Block::bytes; }

    void expect(bool is_right, const std::string& reason) const
    {
        if (!is_right)
            throw std::invalid_argument{"block " + std::to_string(number_) + ": " + reason};
    }

    void read_block(const std::optional<Uf2Block>& block)
    {
        expect(block.has_value(), "it does not begin and end as a block of a UF2 file");
        expect_flags(block->flags);
        expect_payload(block->address, block->payload_bytes);
        expect_number(block->number, block->count);
        expect(block->family == family_,
               "it is for the chip family " + hex_text(block->family) + ", not " + hex_text(family_));
        expect(payloads_.try_emplace(block->address, block->payload).second,
               "another block has written to " + hex_text(block->address) + " before");
    }

    void expect_flags(std::uint32_t flags) const
    {
        expect((flags & (Uf2Block::not_for_flash | Uf2Block::holds_files)) == 0,
               "it is not for flash, or part of a stored file");
        expect((flags & Uf2Block::names_family) != 0, "it does not say which chip family it is for");
    }

    void expect_payload(std::uint32_t address, std::uint32_t bytes) const
    {
        expect(bytes == Uf2Block::usual_payload,
               "it carries " + std::to_string(bytes) + " bytes where 256 are usual");
        expect(address % Uf2Block::usual_payload == 0,
               "its address " + hex_text(address) + " is no multiple of 256");
    }

    void expect_number(std::uint32_t number, std::uint32_t count) const
    {
        expect(count == this->count(), "it says that the file has " + std::to_string(count) +
                                           " blocks, but it has " + std::to_string(this->count()));
        expect(number == number_, "it calls itself block " + std::to_string(number));
    }

    std::vector<FlashRegion> joined() const
    {
        std::vector<FlashRegion> regions;
        for (const auto& [address, payload] : payloads_) {
            if (regions.empty() || regions.back().address + regions.back().bytes.size() != address)
                regions.push_back({address, {}});
            regions.back().bytes.insert(regions.back().bytes.end(), payload.begin(), payload.end());
        }
        return regions;
    }

    std::span<const std::byte> file_;
    std::uint32_t family_;
    std::size_t number_ = 0; ///< of the block that is read
    std::map<std::uint32_t, std::span<const std::byte>> payloads_;
};

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
    return FileReader{file, family}.regions();
}

}
