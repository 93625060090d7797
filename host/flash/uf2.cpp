#include "host/flash/uf2.hpp"

#include "core/byte_reader.hpp"
#include "host/compiler/byte_writer.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
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
constexpr std::size_t sector_bytes = 4096;
constexpr std::uint64_t end_of_addresses = std::uint64_t{1} << 32;

using Sector = std::array<std::byte, sector_bytes>;
using Sectors = std::map<std::uint32_t, Sector>; ///< by address

std::string hex(std::uint64_t value)
{
    std::array<char, 20> text{};
    std::snprintf(text.data(), text.size(), "0x%08llx", static_cast<unsigned long long>(value));
    return text.data();
}

std::uint32_t sector_of(std::uint64_t address)
{
    return static_cast<std::uint32_t>(address - address % sector_bytes);
}

Sector& add_sector(Sectors& sectors, std::uint32_t address)
{
    const auto [place, is_new] = sectors.try_emplace(address);
    if (!is_new)
        throw std::invalid_argument{"two regions lie in the sector of 4096 bytes at " + hex(address) +
                                    ", which can be written once only"};
    place->second.fill(std::byte{0xFF});
    return place->second;
}

void add_region(Sectors& sectors, const FlashRegion& region)
{
    const std::uint64_t end = std::uint64_t{region.address} + region.bytes.size();
    if (end > end_of_addresses)
        throw std::invalid_argument{"the region at " + hex(region.address) + " ends at " + hex(end) +
                                    ", beyond the last address of 32 bits"};
    std::span<const std::byte> rest{region.bytes};
    for (std::uint64_t address = region.address; address < end; address = end - rest.size()) {
        const std::size_t offset = address % sector_bytes;
        const auto part = rest.first(std::min(sector_bytes - offset, rest.size()));
        std::ranges::copy(part, add_sector(sectors, sector_of(address)).begin() +
                                    static_cast<std::ptrdiff_t>(offset));
        rest = rest.subspan(part.size());
    }
}

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

void write_sector(ByteWriter& file, Numbering& numbering, std::uint32_t address, const Sector& sector)
{
    for (std::size_t offset = 0; offset < sector_bytes; offset += payload_bytes, ++numbering.number)
        write_block(file, numbering, address + static_cast<std::uint32_t>(offset),
                    std::span{sector}.subspan(offset, payload_bytes));
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
        expect(family == family_, "it is for the chip family " + hex(family) + ", not " + hex(family_));
        expect(payloads_.try_emplace(address, reader.rest().first(payload_bytes)).second,
               "another block has written to " + hex(address) + " before");
    }

    void expect_flags(std::uint32_t flags) const
    {
        expect((flags & (not_for_flash | holds_files)) == 0, "it is not for flash, or part of a stored file");
        expect((flags & names_family) != 0, "it does not say which chip family it is for");
    }

    void expect_payload(std::uint32_t address, std::uint32_t bytes) const
    {
        expect(bytes == payload_bytes, "it carries " + std::to_string(bytes) + " bytes where 256 are usual");
        expect(address % payload_bytes == 0, "its address " + hex(address) + " is no multiple of 256");
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
    Sectors sectors;
    for (const FlashRegion& region : regions)
        add_region(sectors, region);
    constexpr std::size_t blocks_per_sector = sector_bytes / payload_bytes;
    Numbering numbering{0, static_cast<std::uint32_t>(sectors.size() * blocks_per_sector), family};
    ByteWriter file;
    for (const auto& [address, sector] : sectors)
        write_sector(file, numbering, address, sector);
    return file.bytes();
}

std::vector<FlashRegion> regions_of(std::span<const std::byte> file, std::uint32_t family)
{
    return FileReader{file, family}.regions();
}

}
