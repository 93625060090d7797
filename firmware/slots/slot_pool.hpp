#pragma once

#include "firmware/slots/sector_set.hpp"
#include "firmware/slots/slot_directory.hpp"

#include <cstdint>
#include <optional>

namespace kfast {

/// A range of the pool, in bytes.
struct Extent {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
};

/// The part of the flash in which the scenes of all slots are, each in one piece from the beginning of a
/// sector on.
class SlotPool {
public:
    /// Without any room.
    SlotPool() = default;
    /// The slots of `directory` are occupied, and so are its bad sectors and `held`, if it is not empty.
    SlotPool(const SlotDirectory& directory, std::uint32_t bytes, Extent held);

    /// All sectors of which `extent` has bytes are no room any more. They may follow the pool, but are within
    /// the capacity of a SectorSet.
    void occupy(Extent extent);

    /// Where `size` bytes (not 0) find room: at or after `from`, or else from the beginning of the pool. So
    /// what is written goes round through the whole pool, and no part of it wears before the others.
    std::optional<std::uint32_t> room_for(std::uint32_t size, std::uint32_t from) const;
    /// The bytes of the longest free range.
    std::uint32_t longest_room() const;

private:
    std::optional<std::uint32_t> room_behind(std::uint32_t from, std::uint32_t size) const;

    SectorSet occupied_;
    std::uint32_t sectors_ = 0;
};

}
