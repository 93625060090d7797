#include "firmware/slots/slot_pool.hpp"

#include "core/bytes/expects.hpp"

#include <algorithm>

namespace kfast {

SlotPool::SlotPool(const SlotDirectory& directory, std::uint32_t bytes, Extent held)
    : occupied_{directory.bad_sectors}, sectors_{bytes / sector_bytes}
{
    for (const SlotEntry& entry : directory.slots)
        occupy({entry.offset, entry.offset + entry.size});
    occupy(held);
}

void SlotPool::occupy(Extent extent)
{
    if (extent.begin == extent.end)
        return;
    for (std::uint32_t at = extent.begin / sector_bytes * sector_bytes; at < extent.end; at += sector_bytes)
        occupied_.add(at / sector_bytes);
}

std::optional<std::uint32_t> SlotPool::room_behind(std::uint32_t from, std::uint32_t size) const
{
    std::uint32_t begin = from / sector_bytes;
    for (std::uint32_t sector = begin; sector < sectors_; ++sector) {
        if (occupied_.has(sector))
            begin = sector + 1;
        else if (size <= (sector + 1 - begin) * sector_bytes)
            return begin * sector_bytes;
    }
    return std::nullopt;
}

std::optional<std::uint32_t> SlotPool::room_for(std::uint32_t size, std::uint32_t from) const
{
    expects(size != 0);
    const auto room = room_behind(from, size);
    return room ? room : room_behind(0, size);
}

std::uint32_t SlotPool::longest_room() const
{
    std::uint32_t longest = 0;
    std::uint32_t free = 0;
    for (std::uint32_t sector = 0; sector < sectors_; ++sector) {
        free = occupied_.has(sector) ? 0 : free + sector_bytes;
        longest = std::max(longest, free);
    }
    return longest;
}

}
