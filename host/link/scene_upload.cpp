#include "host/link/scene_upload.hpp"

#include "core/bytes/crc32.hpp"
#include "host/link/session.hpp"
#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"
#include "host/text/characters.hpp"

#include <algorithm>

namespace kfast {

std::vector<link::SlotContents> slots_of(RemoteDevice& device)
{
    std::vector<link::SlotContents> slots;
    for (std::uint8_t slot = 0; slot < device.capabilities().slots; ++slot)
        slots.push_back(device.session().ask<link::SlotContents>(link::AskSlot{slot}));
    return slots;
}

std::uint8_t slot_for(std::string_view name, std::span<const link::SlotContents> slots)
{
    const auto is_empty = [](const link::SlotContents& slot) { return slot.size == 0; };
    const auto has_name = [&](const link::SlotContents& slot) {
        return !is_empty(slot) && slot.name.view() == name;
    };
    auto found = std::ranges::find_if(slots, has_name);
    if (found == slots.end())
        found = std::ranges::find_if(slots, is_empty);
    if (found == slots.end())
        throw Failure{
            "all slots are taken: name the one to replace with --slot, or erase one ('kfast erase')",
            ExitStatus::no_room};
    return static_cast<std::uint8_t>(found - slots.begin());
}

std::string_view stored_name(std::string_view name)
{
    constexpr std::size_t max = std::tuple_size_v<decltype(link::Name::bytes)>;
    std::size_t length = 0;
    while (length < name.size()) {
        const std::size_t next = length + code_point_at(name, length).length;
        if (next > max)
            break;
        length = next;
    }
    return name.substr(0, length);
}

namespace {

/// How often a scene is sent from its beginning before it is reported as a failure.
constexpr int max_attempts = 4;
/// How often a device may report that it has all blocks and then that it has not.
constexpr int max_rounds = 16;

std::uint32_t crc_of(std::span<const std::byte> bytes)
{
    Crc32 crc;
    crc.add(bytes);
    return crc.value();
}

/// Whether the upload is over without having failed for good. Where flash did not hold, the device knows by
/// now, and puts it elsewhere.
bool is_lost(Status status)
{
    return status == Status::no_transfer || status == Status::timed_out || status == Status::bad_checksum ||
           status == Status::flash_failed;
}

class SceneUpload {
public:
    SceneUpload(Session& session, const link::Begin& begin, std::span<const std::byte> scene,
                const ByteProgressCallback& on_progress)
        : session_{session},
          begin_{begin},
          scene_{scene},
          on_progress_{on_progress},
          patience_{begin.home == link::Home::slot ? patience_with_flash : patience_with_ram}
    {
    }

    /// Throws Refusal.
    void run()
    {
        tag_ = session_.new_tag();
        const auto begun = session_.ask_with<link::Begun>(begin_, tag_, patience_);
        window_ = begun.window;
        go_on_from(begun.next);
        send_blocks();
        for (int round = 1; !is_committed(round == max_rounds); ++round)
            send_blocks();
    }
    std::uint8_t tag() const { return tag_; }
    void cancel() { session_.take_leave(link::report_of(link::Cancel{}, tag_)); }

private:
    std::uint32_t blocks() const { return link::blocks_of(begin_.size); }

    void go_on_from(std::uint32_t block)
    {
        heard_ = std::min(block, blocks());
        next_ = heard_;
        furthest_ = std::max(furthest_, heard_);
        progressed_ = session_.now();
        on_progress_(std::min<std::size_t>(heard_ * link::block_bytes, scene_.size()));
    }

    /// Sends until the device has reported that it has all of them.
    void send_blocks()
    {
        Milliseconds patience = patience_;
        while (heard_ < blocks()) {
            const bool is_room = next_ < std::min(blocks(), heard_ + window_);
            if (is_room)
                send_next();
            const std::uint32_t heard_before = heard_;
            if (const auto report = session_.hear(tag_, is_room ? Milliseconds{0} : patience)) {
                take(*report);
            } else if (!is_room) {
                next_ = heard_;
                patience = Session::longer(patience);
            }
            if (heard_ != heard_before)
                patience = patience_;
            if (session_.now() - progressed_ >= session_.last_patience())
                give_up(session_.last_patience());
        }
    }

    void send_next()
    {
        link::Data data{.block = static_cast<std::uint16_t>(next_)};
        const auto rest = scene_.subspan(next_ * link::block_bytes);
        std::ranges::copy(rest.first(std::min(rest.size(), link::block_bytes)), data.bytes.begin());
        session_.send(link::report_of(data, tag_));
        furthest_ = std::max(furthest_, ++next_);
    }

    void take(const Report& report)
    {
        if (const auto acknowledgement = link::message_of<link::Acknowledgement>(report))
            hear(*acknowledgement);
        if (const auto failure = refusal_in(report, link::code_of<link::Data>()))
            throw Refusal{*failure};
    }

    /// It may be late, or about blocks that were never sent.
    void hear(const link::Acknowledgement& acknowledgement)
    {
        if (acknowledgement.next < heard_ || acknowledgement.next > furthest_)
            return;
        window_ = acknowledgement.window;
        if (acknowledgement.next > heard_) {
            const std::uint32_t next = std::max<std::uint32_t>(next_, acknowledgement.next);
            go_on_from(acknowledgement.next);
            next_ = next;
        }
        if (acknowledgement.is_missing)
            next_ = heard_;
    }

    /// Returns false if blocks are still to be sent, which cannot be when it is the `last` time.
    bool is_committed(bool last)
    {
        try {
            session_.ask_with<link::Done<link::Kind::commit>>(link::Commit{}, tag_, patience_);
            return true;
        } catch (const Refusal& refusal) {
            if (last || refusal.status() != Status::incomplete || refusal.number() >= blocks())
                throw;
            go_on_from(refusal.number());
            return false;
        }
    }

    Session& session_;
    link::Begin begin_;
    std::span<const std::byte> scene_;
    const ByteProgressCallback& on_progress_;
    Milliseconds patience_;
    std::uint8_t tag_ = 0;
    std::uint32_t window_ = 0;
    std::uint32_t heard_ = 0;    ///< the device has all blocks before it
    std::uint32_t next_ = 0;     ///< the next one to be sent
    std::uint32_t furthest_ = 0; ///< after the last that was sent
    Milliseconds progressed_{};
};

link::Begin begin_of(std::span<const std::byte> scene)
{
    return {.size = static_cast<std::uint32_t>(scene.size()), .crc = crc_of(scene)};
}

}

link::Begin begin_in_slot(std::uint8_t slot, std::string_view name, std::span<const std::byte> scene)
{
    link::Begin begin = begin_of(scene);
    begin.home = link::Home::slot;
    begin.slot = slot;
    begin.name = {name};
    return begin;
}

link::Begin begin_in_ram(std::span<const std::byte> scene)
{
    link::Begin begin = begin_of(scene);
    begin.home = link::Home::ram;
    return begin;
}

std::uint8_t upload_scene(Session& session, const link::Begin& begin, std::span<const std::byte> scene,
                          const ByteProgressCallback& on_progress)
{
    for (int attempt = 1;; ++attempt) {
        SceneUpload upload{session, begin, scene, on_progress};
        try {
            upload.run();
            return upload.tag();
        } catch (const Interrupted&) {
            upload.cancel();
            throw;
        } catch (const Refusal& refusal) {
            if (!is_lost(refusal.status()) || attempt == max_attempts)
                throw;
        }
    }
}

}
