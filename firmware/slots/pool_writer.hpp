#pragma once

#include "firmware/slots/flash.hpp"
#include "firmware/slots/flash_places.hpp"
#include "firmware/slots/sector_set.hpp"
#include "firmware/slots/slot_directory_store.hpp"
#include "firmware/slots/slot_pool.hpp"
#include "firmware/slots/write_sector.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kfast {

/// Writes a stream of bytes into the pool, sector by sector. A sector that was written since the start and
/// begins with the wanted bytes is left as it is. One that does not hold them is entered into the directory
/// as bad, and the whole stream moves to where there is none.
template <Flash F>
class PoolWriter {
public:
    /// Both must outlive it.
    PoolWriter(F& flash, const FlashPlaces& places, SlotDirectoryStore<F>& directory)
        : flash_{flash}, places_{places}, directory_{directory}
    {
    }

    /// From now on bytes are compared with those at `begin` in the pool, the beginning of a sector, and
    /// nothing is changed.
    void compare_with(std::uint32_t begin) { start(begin, true); }

    /// From now on `size` bytes (not 0) go where there is room in `free`, for which there must be some at
    /// `begin`; until the next stream begins nothing else of the pool is written to.
    void write_to(std::uint32_t begin, std::uint32_t size, const SlotPool& free)
    {
        start(begin, false);
        size_ = size;
        free_ = free;
    }

    /// The next bytes: no more, altogether, than the stream has.
    void add(std::span<const std::byte> bytes)
    {
        while (!bytes.empty()) {
            const std::size_t part = std::min<std::size_t>(bytes.size(), sector_bytes - filled_);
            std::ranges::copy(bytes.first(part), sector_.begin() + filled_);
            filled_ += static_cast<std::uint32_t>(part);
            bytes = bytes.subspan(part);
            if (filled_ == sector_bytes)
                flush();
        }
    }

    /// Writes the rest of the stream into flash.
    void flush()
    {
        if (filled_ == 0)
            return;
        const std::uint32_t at = begin_ + written_;
        const bool is_there = std::ranges::equal(filled(), contents().subspan(at, filled_));
        is_same_ = is_same_ && is_there;
        if (!compares_ && holds_ && !(is_there && is_sure_.has(at / sector_bytes)))
            holds_ = write(at, filled()) || move();
        written_ += filled_;
        filled_ = 0;
    }

    bool compares() const { return compares_; }
    /// Whether all that was flushed was in flash before.
    bool is_same() const { return is_same_; }
    /// Whether flash has held all that was written to it, there or elsewhere.
    bool holds() const { return holds_; }
    /// Where the stream begins in the pool.
    std::uint32_t begin() const { return begin_; }

private:
    void start(std::uint32_t begin, bool compares)
    {
        begin_ = begin;
        compares_ = compares;
        written_ = filled_ = 0;
        is_same_ = holds_ = true;
    }
    std::span<const std::byte> filled() const { return std::span{sector_}.first(filled_); }

    std::span<const std::byte> contents() const { return flash_.contents().subspan(places_.pool); }

    bool write(std::uint32_t at, std::span<const std::byte> bytes)
    {
        is_sure_.add(at / sector_bytes);
        return write_sector(flash_, places_.pool + at, bytes);
    }

    /// The sector that was written last is bad: brings the stream to where all its sectors hold, and returns
    /// whether there is such a place. That may overlap what was written; then it begins before it, as what
    /// was written ends with a bad sector, and each sector is read before another one is written over it.
    bool move()
    {
        const std::uint32_t old = begin_;
        for (std::optional<std::uint32_t> bad = old + written_; bad; bad = copy_from(old)) {
            if (!remember(*bad))
                return false;
            const auto room = free_.room_for(size_, *bad + sector_bytes);
            if (!room)
                return false;
            begin_ = *room;
        }
        return true;
    }

    /// No stream comes to the sector at `bad` in the pool any more, nor after a restart. Returns whether that
    /// is certain.
    bool remember(std::uint32_t bad)
    {
        free_.occupy({bad, bad + sector_bytes});
        SlotDirectory changed = directory_.directory();
        changed.bad_sectors.add(bad / sector_bytes);
        return directory_.put(changed) == Status::ok;
    }

    /// Writes what was written from `old` on, and what is in RAM behind it, to where the stream begins now.
    /// Returns which sector does not hold, if there is one.
    std::optional<std::uint32_t> copy_from(std::uint32_t old)
    {
        for (std::uint32_t at = 0; at <= written_; at += sector_bytes) {
            const auto bytes = at < written_ ? contents().subspan(old + at, sector_bytes) : filled();
            if (!write(begin_ + at, bytes))
                return begin_ + at;
        }
        return std::nullopt;
    }

    F& flash_;
    FlashPlaces places_;
    SlotDirectoryStore<F>& directory_;
    SlotPool free_; ///< what was free when the stream began, without bad sectors
    std::array<std::byte, sector_bytes> sector_{}; ///< what comes behind what was written
    /// What was written since the start: what is there from before may be the remains of a write during which
    /// power was cut, and be read differently later.
    SectorSet is_sure_;
    std::uint32_t begin_ = 0;
    std::uint32_t size_ = 0;
    std::uint32_t written_ = 0; ///< bytes, whole sectors until the stream has ended
    std::uint32_t filled_ = 0;
    bool compares_ = true;
    bool is_same_ = true;
    bool holds_ = true;
};

}
