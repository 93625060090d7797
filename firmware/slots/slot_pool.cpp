#include "firmware/slots/slot_pool.hpp"

#include "core/bytes/expects.hpp"

#include <algorithm>
#include <span>

namespace kfast {

SlotPool::SlotPool(const SlotDirectory& directory, std::uint32_t bytes, Extent held) : bytes_{bytes}
{
    for (const SlotEntry& entry : directory.slots)
        occupy({entry.offset, entry.offset + entry.size});
    occupy(held);
}

void SlotPool::occupy(Extent extent)
{
    if (extent.begin == extent.end)
        return;
    const Extent whole{extent.begin / sector_bytes * sector_bytes, whole_sectors(extent.end)};
    std::size_t at = count_++;
    for (; at > 0 && whole.begin < occupied_[at - 1].begin; --at)
        occupied_[at] = occupied_[at - 1];
    occupied_[at] = whole;
}

const Extent* SlotPool::first_obstacle(Extent extent) const
{
    for (const Extent& other : std::span{occupied_}.first(count_))
        if (other.begin < extent.end && extent.begin < other.end)
            return &other;
    return nullptr;
}

std::optional<std::uint32_t> SlotPool::room_behind(std::uint32_t from, std::uint32_t size) const
{
    while (from < bytes_ && size <= bytes_ - from) {
        const Extent* const obstacle = first_obstacle({from, from + size});
        if (!obstacle)
            return from;
        from = obstacle->end;
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
    for (const Extent& extent : std::span{occupied_}.first(count_)) {
        longest = std::max(longest, extent.begin > free ? extent.begin - free : 0);
        free = std::max(free, extent.end);
    }
    return std::max(longest, bytes_ > free ? bytes_ - free : 0);
}

}
