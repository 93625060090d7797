#pragma once

#include "firmware/chip/microseconds.hpp"
#include "firmware/link/device.hpp"
#include "firmware/link/outcome.hpp"
#include "firmware/link/sink.hpp"
#include "firmware/link/transfer.hpp"
#include "firmware/link/upload_message.hpp"
#include "firmware/slots/slot_store.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace kfast::link {

/// Scenes that come over the link, one at a time, into a slot or into RAM.
template <Device D, Flash F>
class Upload {
public:
    /// Both must outlive it.
    Upload(D& device, SlotStore<F>& slots) : device_{device}, slots_{slots} {}

    /// Fails with bad_value, no_such_slot, no_room, too_large or flash_failed. An upload that was under way
    /// is dropped even then, unless this is its own beginning once more. Put off as long as what plays gives
    /// way to it.
    Outcome<Begun> begin(const Begin& what, std::uint8_t tag, Microseconds now)
    {
        if (transfer_.is_begun_by(what, tag) && !is_out_of_ram())
            return transfer_.begun();
        const bool leaves_ram = transfer_.is_under_way() && is_for_ram();
        transfer_.forget();
        is_stray_reported_ = false;
        const StatusWithNumber result = make_room(what);
        if (leaves_ram && (what.home != Home::ram || !result.is_ok()))
            device_.end_lease();
        if (!result.is_ok())
            return result;
        if (what.home == Home::ram && device_.leased_ram().empty())
            return Outcome<Begun>::put_off();
        transfer_.begin(what, tag, now);
        return transfer_.begun();
    }

    /// Fails with no_transfer if it belongs to none.
    Status take(const Data& data, std::uint8_t tag, Microseconds now)
    {
        if (!transfer_.belongs(tag))
            return Status::no_transfer;
        if (has_lost_ram())
            fail(Status::no_transfer);
        with_sink([&](auto& sink) { transfer_.take(data, sink, now); });
        return Status::ok;
    }
    /// Whether data that belong to no upload are to be reported: once until the next one begins.
    bool reports_stray() { return !std::exchange(is_stray_reported_, true); }

    /// Fails with no_transfer, incomplete, bad_checksum, flash_failed or an error of SceneView::parse, or
    /// with why the upload was dropped.
    StatusWithNumber commit(std::uint8_t tag, Microseconds now)
    {
        if (!transfer_.belongs(tag))
            return Status::no_transfer;
        if (has_lost_ram())
            fail(Status::no_transfer);
        const bool was_under_way = transfer_.is_under_way();
        StatusWithNumber result;
        with_sink([&](auto& sink) { result = transfer_.commit(sink); });
        if (is_for_ram() && was_under_way && !transfer_.is_under_way())
            end_in_ram(result.is_ok());
        if (is_for_ram() && result.is_ok() && was_under_way)
            committed_ = now;
        return result;
    }

    /// Fails with no_transfer. What was committed stays in its slot; in RAM it stays only if it plays.
    Status cancel(std::uint8_t tag)
    {
        if (!transfer_.belongs(tag))
            return Status::no_transfer;
        if (transfer_.is_under_way())
            fail(Status::no_transfer);
        else if (is_for_ram())
            end_in_ram(false);
        return Status::ok;
    }

    /// Drops the upload under way, and forgets what came last: nobody continues or asks about them.
    void abandon()
    {
        if (transfer_.is_under_way())
            fail(Status::no_transfer);
        else if (is_for_ram() && !device_.playing().is_playing)
            end_in_ram(false);
        transfer_.forget();
        is_stray_reported_ = false;
    }

    /// What came last may not be where it was stored any more.
    void forget_last()
    {
        if (!transfer_.is_under_way())
            transfer_.forget();
    }

    /// The tag of an upload that took too long and is dropped now.
    std::optional<std::uint8_t> drop_overdue(Microseconds now)
    {
        if (!transfer_.is_overdue(now))
            return std::nullopt;
        fail(Status::timed_out);
        return transfer_.tag();
    }

    /// What gave way to a scene in RAM does not wait for ever until it is played.
    void drop_unplayed(Microseconds now)
    {
        if (!committed_ || !reached(now, *committed_ + Transfer::patience))
            return;
        committed_.reset();
        if (!device_.playing().is_playing)
            end_in_ram(false);
    }

    /// The whole scene that is in RAM, if there is one.
    std::span<const std::byte> ram_scene() const
    {
        return device_.leased_ram().empty() ? std::span<const std::byte>{} : ram_scene_;
    }

    bool has_acknowledgement() const { return transfer_.has_acknowledgement(); }
    /// Its progress, if that is to be acknowledged now.
    std::optional<Report> next_acknowledgement()
    {
        const auto progress = transfer_.next_acknowledgement();
        return progress ? std::optional{report_of(*progress, transfer_.tag())} : std::nullopt;
    }

private:
    bool is_for_ram() const { return transfer_.what().home == Home::ram; }

    /// Whether the memory that it is, or was, written to is needed for something else.
    bool is_out_of_ram() const { return is_for_ram() && device_.leased_ram().empty(); }
    bool has_lost_ram() const { return transfer_.is_under_way() && is_out_of_ram(); }

    void fail(Status why)
    {
        transfer_.fail(why);
        if (is_for_ram())
            end_in_ram(false);
    }
    void end_in_ram(bool is_whole)
    {
        if (is_whole)
            ram_scene_ = ram_.bytes();
        else
            device_.end_lease();
    }

    template <class Do>
    void with_sink(Do&& with)
    {
        if (is_for_ram())
            with(ram_);
        else
            with(slots_);
    }

    StatusWithNumber make_room(const Begin& what)
    {
        if (what.size == 0 || blocks_of(what.size) > max_blocks)
            return Status::bad_value;
        switch (what.home) {
        case Home::slot:
            if (what.slot >= SlotDirectory::slot_count)
                return {Status::no_such_slot, SlotDirectory::slot_count};
            return slots_.begin({what.slot, what.size, what.crc, what.name}, device_.played());
        case Home::ram:
            return make_room_in_ram(what.size);
        case Home::built_in:
        case Home::here:
        case Home::start:
            return Status::bad_value;
        }
        return Status::bad_value;
    }

    StatusWithNumber make_room_in_ram(std::uint32_t size)
    {
        if (const std::uint32_t max = device_.facts().ram_bytes; size > max)
            return {Status::too_large, max};
        ram_scene_ = {};
        committed_.reset();
        ram_ = RamSink{device_.lease_ram(size)};
        return {};
    }

    D& device_;
    SlotStore<F>& slots_;
    Transfer transfer_;
    RamSink ram_;
    std::span<const std::byte> ram_scene_;
    std::optional<Microseconds> committed_; ///< when it came into RAM, as long as it may not have been played
    bool is_stray_reported_ = false;
};

}
