#include "host/flash/flash_image.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace kfast {

namespace {

constexpr std::uint64_t end_of_addresses = std::uint64_t{1} << 32;

using Bytes = decltype(FlashImage::Sector::bytes);
using Sectors = std::map<std::uint32_t, Bytes>; ///< by address

std::uint32_t sector_of(std::uint64_t address)
{
    return static_cast<std::uint32_t>(address - address % FlashImage::sector_bytes);
}

Bytes& add_sector(Sectors& sectors, std::uint32_t address)
{
    const auto [place, is_new] = sectors.try_emplace(address);
    if (!is_new)
        throw std::invalid_argument{"two regions lie in the sector of 4096 bytes at " + hex_text(address) +
                                    ", which can be written once only"};
    place->second.fill(std::byte{0xFF});
    return place->second;
}

void add_region(Sectors& sectors, const FlashRegion& region)
{
    const std::uint64_t end = std::uint64_t{region.address} + region.bytes.size();
    if (end > end_of_addresses)
        throw std::invalid_argument{"the region at " + hex_text(region.address) + " ends at " +
                                    hex_text(end) + ", beyond the last address of 32 bits"};
    std::span<const std::byte> rest{region.bytes};
    for (std::uint64_t address = region.address; address < end; address = end - rest.size()) {
        const std::size_t offset = address % FlashImage::sector_bytes;
        const auto part = rest.first(std::min(FlashImage::sector_bytes - offset, rest.size()));
        std::ranges::copy(part, add_sector(sectors, sector_of(address)).begin() +
                                    static_cast<std::ptrdiff_t>(offset));
        rest = rest.subspan(part.size());
    }
}

}

FlashImage::FlashImage(std::span<const FlashRegion> regions)
{
    Sectors sectors;
    for (const FlashRegion& region : regions)
        add_region(sectors, region);
    sectors_.reserve(sectors.size());
    for (const auto& [address, bytes] : sectors)
        sectors_.push_back({address, bytes});
}

}
