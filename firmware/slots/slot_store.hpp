#pragma once

#include "core/bytes/crc32.hpp"
#include "core/bytes/expects.hpp"
#include "core/scene/scene_view.hpp"
#include "firmware/slots/flash.hpp"
#include "firmware/slots/flash_places.hpp"
#include "firmware/slots/pool_writer.hpp"
#include "firmware/slots/slot_directory.hpp"
#include "firmware/slots/slot_directory_store.hpp"
#include "firmware/slots/slot_pool.hpp"
#include "firmware/status.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kfast {

/// What is to be stored in a slot.
struct SlotUpload {
    std::uint8_t slot = 0;
    std::uint32_t size = 0; ///< bytes
    std::uint32_t crc = 0;  ///< CRC-32 of all bytes
    SceneName name{};
};

/// The scenes in the flash of a device. Whatever is done, and whenever power is cut, a start finds all slots
/// as they were before or as they are to be: what a slot holds is not touched until the new directory is
/// written whole, and then it is the new one. A sector that does not hold what it is given is not used again,
/// nor after a restart, and what was to be there goes elsewhere.
///
/// Every function that changes flash returns when it has done so: a sector takes about 50 ms, at worst 400,
/// and the first change after a start three sectors more. When a sector of an upload does not hold, all
/// sectors of it are written anew.
template <Flash F>
class SlotStore {
public:
    /// Reads the directory; if no copy is valid, all slots are empty. `flash` must outlive the
    /// store.
    SlotStore(F& flash, const FlashPlaces& places)
        : flash_{flash}, places_{places}, stored_{flash, places}, writer_{flash, places, stored_}
    {
        expects(places.former_pool_bytes() <= SectorSet::capacity * sector_bytes);
    }
    SlotStore(const SlotStore&) = delete; // its parts refer to each other
    SlotStore& operator=(const SlotStore&) = delete;

    std::uint32_t pool_bytes() const { return places_.pool_bytes; }
    /// `slot` is less than SlotDirectory::slot_count.
    const SlotEntry& entry(std::uint8_t slot) const
    {
        expects(slot < SlotDirectory::slot_count);
        return directory().slots[slot];
    }
    /// The bytes of a slot, which have not been checked; none if it is empty. They stay where they are until
    /// the slot changes, and then as long as they are `held`.
    std::span<const std::byte> scene(std::uint8_t slot) const
    {
        return flash_.contents().subspan(places_.pool + entry(slot).offset, entry(slot).size);
    }
    /// Whether the bytes of a slot are those that were put into it.
    bool is_whole(std::uint8_t slot) const
    {
        const SlotEntry& held = entry(slot);
        return crc_of_flash(held.offset, held.size) == held.crc;
    }
    /// What plays when the device starts; none: the built-in scene.
    std::optional<std::uint8_t> chosen() const
    {
        const std::uint8_t slot = directory().chosen;
        return slot == SlotDirectory::none ? std::nullopt : std::optional{slot};
    }

    /// The bytes of the largest scene that a slot can take while `held` stays as it is.
    std::uint32_t longest_room(std::span<const std::byte> held) const { return pool(held).longest_room(); }

    /// Fails with no_room or flash_failed. Until the next begin(), bytes go where none of the slots has its
    /// own, nor `held`: what is played, from a slot or from anywhere.
    StatusWithNumber begin(const SlotUpload& upload, std::span<const std::byte> held)
    {
        upload_ = upload;
        if (holds_already(upload)) {
            writer_.compare_with(entry(upload.slot).offset);
            return {};
        }
        const SlotPool free = pool(held);
        const auto room = free.room_for(upload.size, directory().next);
        if (!room)
            return {Status::no_room, free.longest_room()};
        writer_.write_to(*room, upload.size, free);
        return stored_.settle();
    }

    /// The next bytes of the upload, after begin() and before finish(): no more than its size, altogether.
    void write(std::span<const std::byte> bytes) { writer_.add(bytes); }

    /// All bytes have come: the slot holds them from now on. Fails, and then the slot is as it was, with
    /// bad_checksum or flash_failed, or an error of SceneView::parse.
    Status finish()
    {
        writer_.flush();
        const Status status = check();
        return status == Status::ok ? enter() : status;
    }

    /// Fails with empty_slot or flash_failed.
    Status erase(std::uint8_t slot)
    {
        if (entry(slot).is_empty())
            return Status::empty_slot;
        SlotDirectory changed = directory();
        changed.slots[slot] = {};
        if (changed.chosen == slot)
            changed.chosen = SlotDirectory::none;
        return stored_.put(changed);
    }

    /// From the next start on, `slot` plays; none: the built-in scene. Fails with empty_slot or flash_failed.
    Status choose(std::optional<std::uint8_t> slot)
    {
        if (slot && entry(*slot).is_empty())
            return Status::empty_slot;
        SlotDirectory changed = directory();
        changed.chosen = slot.value_or(SlotDirectory::none);
        return stored_.put(changed);
    }

private:
    const SlotDirectory& directory() const { return stored_.directory(); }

    std::span<const std::byte> pool_contents() const
    {
        return flash_.contents().subspan(places_.pool, places_.former_pool_bytes());
    }
    SlotPool pool(std::span<const std::byte> held) const
    {
        return {directory(), places_.pool_bytes, extent_of(held)};
    }
    /// The part of the pool that `held` is; none if it is elsewhere.
    Extent extent_of(std::span<const std::byte> held) const
    {
        const auto address = [](const std::byte* at) { return reinterpret_cast<std::uintptr_t>(at); };
        const std::uintptr_t offset = address(held.data()) - address(pool_contents().data());
        const std::size_t size = pool_contents().size();
        if (offset >= size || held.size() > size - offset)
            return {};
        return {static_cast<std::uint32_t>(offset), static_cast<std::uint32_t>(offset + held.size())};
    }

    std::uint32_t crc_of_flash(std::uint32_t offset, std::uint32_t size) const
    {
        Crc32 crc;
        crc.add(pool_contents().subspan(offset, size));
        return crc.value();
    }

    /// The same scene, as far as size and checksum show, and undamaged.
    bool holds_already(const SlotUpload& upload) const
    {
        const SlotEntry& held = entry(upload.slot);
        return held.size == upload.size && held.crc == upload.crc && is_whole(upload.slot);
    }

    Status check() const
    {
        if (writer_.compares() && !writer_.is_same())
            return Status::bad_checksum;
        if (!writer_.holds() || crc_of_flash(writer_.begin(), upload_.size) != upload_.crc)
            return Status::flash_failed;
        const auto scene = SceneView::parse(pool_contents().subspan(writer_.begin(), upload_.size),
                                            every_feature_but_outlines);
        return scene ? Status::ok : status_of(scene.error());
    }

    /// Enters what was written into the directory.
    Status enter()
    {
        SlotDirectory changed = directory();
        if (!writer_.compares())
            changed.next = (writer_.begin() + whole_sectors(upload_.size)) % places_.pool_bytes;
        changed.slots[upload_.slot] = {
            .name = upload_.name, .offset = writer_.begin(), .size = upload_.size, .crc = upload_.crc};
        return stored_.put(changed);
    }

    F& flash_;
    FlashPlaces places_;
    SlotDirectoryStore<F> stored_;
    PoolWriter<F> writer_;
    SlotUpload upload_;
};

}
