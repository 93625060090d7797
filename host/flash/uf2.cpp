#include "host/flash/uf2.hpp"

#include "core/byte_reader.hpp"
#include "host/compiler/byte_writer.hpp"
#include "host/flash/flash_image.hpp"
#include "host/flash/hex_text.hpp"

#include <array>
#include <map>
#include <stdexcept>
#include <string>

namespace kfast {
namespace {

constexpr std::uint32_t first_magic = 0x0A32'4655;
constexpr std::uint32_t second_magic = 0x9E5D'5157;
constexpr std::uint32_t last_magic = 0x0AB1'6F30;
constexpr std::uint32_t not_for_flash = 0x1;
constexpr std::uint32_t holds_files = 0x1000;
constexpr std::uint32_t names_family = 0x2000;

constexpr std::size_t block_bytes = 512;
constexpr std::size_t payload_room = 476;
constexpr std::size_t payload_bytes = 256;
struct Numbering {
    std::uint32_t number = 0;
    std::uint32_t count = 0;
    std::uint32_t family = 0;
};

void write_block(ByteWriter& file, Numbering numbering, std::uint32_t address,
                 std::span<const std::byte> payload)
{
    for (const std::uint32_t field :
         {first_magic, second_magic, names_family, address, static_cast<std::uint32_t>(payload.size()),
          numbering.number, numbering.count, numbering.family})
        file.u32(field);
    file.append(payload);
    file.append(std::array<std::byte, payload_room - payload_bytes>{});
    file.u32(last_magic);
}

void write_sector(ByteWriter& file, Numbering& numbering, const FlashImage::Sector& sector)
{
    for (std::size_t offset = 0; offset < sector.bytes.size(); offset += payload_bytes, ++numbering.number)
        write_block(file, numbering, sector.address + static_cast<std::uint32_t>(offset),
                    std::span{sector.bytes}.subspan(offset, payload_bytes));
}

class FileReader {
public:
    FileReader(std::span<const std::byte> file, std::uint32_t family) : file_{file}, family_{family} {}

    std::vector<FlashRegion> regions()
    {
        if (file_.empty() || file_.size() % block_bytes != 0)
            throw std::invalid_argument{"a UF2 file is made of blocks of 512 bytes; this one has " +
                                        std::to_string(file_.size()) + " bytes"};
        for (; number_ < count(); ++number_)
            read_block(file_.subspan(number_ * block_bytes, block_bytes));
        return joined();
    }

private:
    std::size_t count() const { return file_.size() / block_bytes; }

    void expect(bool is_right, const std::string& reason) const
    {
        if (!is_right)
            throw std::invalid_argument{"block " + std::to_string(number_) + ": " + reason};
    }

    void read_block(std::span<const std::byte> block)
    {
        ByteReader reader{block};
        ByteReader end{block.last(4)};
        expect(reader.u32() == first_magic && reader.u32() == second_magic && end.u32() == last_magic,
               "it does not begin and end as a block of a UF2 file");
        expect_flags(reader.u32());
        const std::uint32_t address = reader.u32();
        expect_payload(address, reader.u32());
        const std::uint32_t number = reader.u32();
        expect_number(number, reader.u32());
        const std::uint32_t family = reader.u32();
        expect(family == family_,
               "it is for the chip family " + hex_text(family) + ", not " + hex_text(family_));
        expect(payloads_.try_emplace(address, reader.rest().first(payload_bytes)).second,
               "another block has written to " + hex_text(address) + " before");
    }

    void expect_flags(std::uint32_t flags) const
    {
        expect((flags & (not_for_flash | holds_files)) == 0, "it is not for flash, or part of a stored file");
        expect((flags & names_family) != 0, "it does not say which chip family it is for");
    }

    void expect_payload(std::uint32_t address, std::uint32_t bytes) const
    {
        expect(bytes == payload_bytes, "it carries " + std::to_string(bytes) + " bytes where 256 are usual");
        expect(address % payload_bytes == 0, "its address " + hex_text(address) + " is no multiple of 256");
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
    constexpr std::size_t blocks_per_sector = FlashImage::sector_bytes / payload_bytes;
    Numbering numbering{0, static_cast<std::uint32_t>(image.sectors().size() * blocks_per_sector), family};
    ByteWriter file;
    for (const FlashImage::Sector& sector : image.sectors())
        write_sector(file, numbering, sector);
    return file.bytes();
}

std::vector<FlashRegion> regions_of(std::span<const std::byte> file, std::uint32_t family)
{
    return FileReader{file, family}.regions();
}

}
