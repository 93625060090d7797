#pragma once

#include "firmware/slots/flash.hpp"
#include "firmware/slots/flash_places.hpp"
#include "firmware/slots/slot_directory.hpp"
#include "firmware/slots/write_sector.hpp"
#include "firmware/status.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace kfast {

/// The directory in its sectors of the flash, each of which has room for a copy. The newest copy counts.
/// Copies go round the sectors; one that does not hold its copy is passed over, then and later, and while two
/// of them hold, the directory can be changed.
template <Flash F>
class SlotDirectoryStore {
public:
    /// Reads the newest copy; if none is valid, the directory is empty. `flash` must outlive the store.
    SlotDirectoryStore(F& flash, const FlashPlaces& places) : flash_{flash}, places_{places}
    {
        bool is_found = false;
        for (std::uint32_t number = 0; number < FlashPlaces::directory_sectors; ++number) {
            const auto copy =
                read_slot_directory(flash.contents().subspan(places.directory_sector(number), sector_bytes),
                                    places.former_pool_bytes());
            if (!copy || (is_found && !is_newer(*copy, directory_)))
                continue;
            is_found = true;
            newest_ = number;
            directory_ = *copy;
        }
        find_covered();
    }

    const SlotDirectory& directory() const { return directory_; }

    /// Must be called before anything in the pool is changed: at the first time after a start, writes the
    /// directory as it is into all the other sectors. Of the copies that were there nobody knows whether
    /// power was cut while they were written: they may be read rightly at one start and wrongly at the next,
    /// and then another one would count, whose scenes are gone. Fails with flash_failed.
    Status settle()
    {
        for (; unsettled_ > 0; --unsettled_)
            if (const Status status = store(directory_); status != Status::ok)
                return status;
        return Status::ok;
    }

    /// The directory is `changed` from now on, but for its generation and its bad copies. Fails with
    /// flash_failed, and then it is as it was. Even if nothing changes, it rests on no copy from before the
    /// start (settle).
    Status put(const SlotDirectory& changed)
    {
        const bool is_change = changed != directory_;
        const Status status = settle();
        return status == Status::ok && is_change ? store(changed) : status;
    }

private:
    Status store(SlotDirectory changed)
    {
        changed.generation = directory_.generation;
        changed.bad_copies = directory_.bad_copies;
        for (std::uint32_t step = 1; step < FlashPlaces::directory_sectors; ++step) {
            const std::uint32_t number = (newest_ + step) % FlashPlaces::directory_sectors;
            if (((changed.bad_copies | covered_) & bit(number)) != 0)
                continue;
            ++changed.generation; // a copy that was given up may be read rightly later
            if (write_sector(flash_, places_.directory_sector(number), slot_directory_pages_of(changed))) {
                directory_ = changed;
                newest_ = number;
                return Status::ok;
            }
            changed.bad_copies |= bit(number);
        }
        return Status::flash_failed;
    }

    /// Where a scene lies that was stored when the pool was longer, no copy goes until the next start: even
    /// when no slot holds it any more, it may play.
    void find_covered()
    {
        for (std::uint32_t number = 2; number < FlashPlaces::directory_sectors; ++number) {
            const std::uint32_t begin = places_.directory_sector(number) - places_.pool;
            const auto lies_here = [=](const SlotEntry& entry) {
                return entry.offset < begin + sector_bytes && begin < entry.offset + entry.size;
            };
            if (std::ranges::any_of(directory_.slots, lies_here))
                covered_ |= bit(number);
        }
    }

    static constexpr std::uint8_t bit(std::uint32_t number)
    {
        return static_cast<std::uint8_t>(1U << number);
    }

    F& flash_;
    FlashPlaces places_;
    SlotDirectory directory_;
    std::uint32_t newest_ = FlashPlaces::directory_sectors - 1;   ///< the sector of the copy that counts
    std::uint8_t covered_ = 0;                                    ///< a bit for each sector
    std::uint8_t unsettled_ = FlashPlaces::directory_sectors - 1; ///< copies that settle() has to write
};

}
