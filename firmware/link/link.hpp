#pragma once

#include "core/playhead.hpp"
#include "core/scene/scene_view.hpp"
#include "firmware/chip/microseconds.hpp"
#include "firmware/link/answer_queue.hpp"
#include "firmware/link/checksum.hpp"
#include "firmware/link/device.hpp"
#include "firmware/link/fields.hpp"
#include "firmware/link/input_message.hpp"
#include "firmware/link/message.hpp"
#include "firmware/link/outcome.hpp"
#include "firmware/link/scene_library.hpp"
#include "firmware/link/silence_watch.hpp"
#include "firmware/link/upload.hpp"
#include "firmware/link/upload_message.hpp"
#include "firmware/slots/slot_store.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace kfast::link {

/// The device's end of the link (docs/link.md): takes the computer's reports in any order, whole or damaged,
/// carries out their requests, and has answers ready.
///
/// Nothing waits for the computer to fetch answers. A request that finds no room for its answer is not
/// carried out; the progress of an upload is in one report, which is always the newest. One request
/// may have to wait for the device, and is answered later.
template <Device D, Flash F>
class Link {
public:
    /// Both must outlive the link. Nothing else begins uploads to `slots`.
    Link(D& device, SlotStore<F>& slots)
        : device_{device}, slots_{slots}, upload_{device, slots}, library_{device, slots, upload_}
    {
    }

    /// Handles a report. Returns when flash has taken what is full: up to a sector, or the directory.
    void take(std::span<const std::byte> bytes, Microseconds now)
    {
        hear(now);
        pass(now);
        Report report;
        std::ranges::copy(bytes.first(std::min(bytes.size(), report_bytes)), report.bytes.begin());
        if (bytes.size() != report_bytes || !is_whole(report))
            refuse(report, Status::bad_report);
        else if (report.kind() == code_of<Data>())
            take_data(report, now);
        else if (wants_answer(report) && answers_.is_full())
            ++errors_;
        else
            take_request(report, now);
    }

    /// Notes that the computer has sent something. Must also be called when a report has been taken: the
    /// computer could not send anything while it worked.
    void hear(Microseconds now) { silence_.hear(now); }

    /// Lets time pass: must be called every few seconds, and often if silences are to be noticed in time.
    void pass(Microseconds now)
    {
        if (const auto tag = upload_.drop_overdue(now))
            queue_report(report_of(failure(code_of<Data>(), Status::timed_out), *tag));
        upload_.drop_unplayed(now);
        if (const auto request = std::exchange(waiting_, std::nullopt))
            take_request(*request, now);
        if (const auto action = silence_.pass(now)) {
            device_.lose_computer();
            carry_out(*action);
        }
        if (device_.is_idle())
            library_.return_to_start();
    }

    /// The computer is gone, perhaps for a while.
    void lose_computer()
    {
        device_.lose_computer();
        if (const auto action = silence_.end())
            carry_out(*action);
    }

    /// A computer begins anew: nothing of what was under way is meant for it. Scenes stay where they are.
    void begin_session()
    {
        lose_computer();
        upload_.abandon();
        if (std::exchange(waiting_, std::nullopt))
            device_.end_lease();
        answers_ = {};
    }

    /// Plays what plays when the device starts (SceneLibrary).
    StatusWithNumber play_start() { return library_.play_start(); }

    /// Whether there is something to fetch.
    bool has_report() const { return !answers_.is_empty() || upload_.has_acknowledgement(); }
    /// The report to be sent to the computer next, if there is any.
    std::optional<Report> next_report()
    {
        return answers_.is_empty() ? upload_.next_acknowledgement() : answers_.next();
    }

private:
    struct Asked { ///< what belongs to a request besides its message
        std::uint8_t tag = 0;
        Microseconds now;
    };

    /// Tag 0 requests that only failures are reported.
    static bool wants_answer(const Report& report) { return report.tag() != 0; }

    void queue_report(const Report& report)
    {
        if (answers_.is_full())
            ++errors_;
        else
            answers_.put(with_checksum(report));
    }

    /// Answers what could not be understood.
    void refuse(const Report& report, StatusWithNumber result)
    {
        ++errors_;
        fail(report, result);
    }
    void fail(const Report& report, StatusWithNumber result)
    {
        queue_report(report_of(failure(report.kind(), result), report.tag()));
    }

    void take_request(const Report& report, Microseconds now)
    {
        switch (static_cast<Kind>(report.kind())) {
        case Kind::hello:
            return take<Hello>(report, now);
        case Kind::names:
            return take<AskNames>(report, now);
        case Kind::playing:
            return take<AskPlaying>(report, now);
        case Kind::statistics:
            return take<AskStatistics>(report, now);
        case Kind::input:
            return take<AskInput>(report, now);
        case Kind::begin:
            return take<Begin>(report, now);
        case Kind::commit:
            return take<Commit>(report, now);
        case Kind::cancel:
            return take<Cancel>(report, now);
        case Kind::slot:
            return take<AskSlot>(report, now);
        case Kind::erase:
            return take<EraseSlot>(report, now);
        case Kind::choose:
            return take<ChooseSlot>(report, now);
        case Kind::play:
            return take<Play>(report, now);
        case Kind::pause:
            return take<Pause>(report, now);
        case Kind::resume:
            return take<Resume>(report, now);
        case Kind::seek:
            return take<Seek>(report, now);
        case Kind::speed:
            return take<Speed>(report, now);
        case Kind::brightness:
            return take<Brightness>(report, now);
        case Kind::inputs:
            return take<Inputs>(report, now);
        case Kind::text:
            return take<Text>(report, now);
        case Kind::points:
            return take<Points>(report, now);
        case Kind::drawing:
            return take<Drawing>(report, now);
        case Kind::silence:
            return take<Silence>(report, now);
        case Kind::arm:
            return take<Arm>(report, now);
        case Kind::disarm:
            return take<Disarm>(report, now);
        case Kind::boot_loader:
            return take<EnterBootLoader>(report, now);
        case Kind::data:  // needs no answer
        case Kind::error: // only devices send it
            break;
        }
        refuse(report, Status::unknown_kind);
    }

    template <class M>
    void take(const Report& report, Microseconds now)
    {
        const auto message = message_of<M>(report);
        if (!message)
            return refuse(report, Status::bad_value);
        const auto outcome = carry_out(*message, {report.tag(), now});
        if (outcome.is_put_off)
            waiting_ = report;
        else if (!outcome.result.is_ok())
            fail(report, outcome.result);
        else if (wants_answer(report))
            queue_report(report_of(outcome.answer, report.tag()));
    }

    void take_data(const Report& report, Microseconds now)
    {
        const Status status = upload_.take(*message_of<Data>(report), report.tag(), now);
        if (status == Status::ok)
            return;
        ++errors_;
        if (upload_.reports_stray())
            fail(report, status);
    }

    Outcome<Capabilities> carry_out(const Hello&, Asked)
    {
        const DeviceFacts facts = device_.facts();
        return Capabilities{.slots = SlotDirectory::slot_count,
                            .panel = facts.panel,
                            .block_bytes = facts.block_bytes,
                            .ram_bytes = facts.ram_bytes,
                            .pool_bytes = slots_.pool_bytes(),
                            .room_bytes = slots_.longest_room(device_.played()),
                            .serial = facts.serial};
    }
    Outcome<Names> carry_out(const AskNames&, Asked) { return device_.facts().names; }
    Outcome<Playing> carry_out(const AskPlaying&, Asked) { return device_.playing(); }
    Outcome<Statistics> carry_out(const AskStatistics&, Asked)
    {
        Statistics statistics = device_.statistics();
        statistics.link_errors = errors_;
        return statistics;
    }

    /// Returns no_such_input, or ok.
    StatusWithNumber look_for_input(std::uint32_t number) const
    {
        const std::uint8_t known = device_.playing().inputs;
        return number < known ? StatusWithNumber{} : StatusWithNumber{Status::no_such_input, known};
    }

    Outcome<InputState> carry_out(const AskInput& which, Asked)
    {
        if (!device_.playing().is_playing)
            return Status::nothing_plays;
        if (const StatusWithNumber result = look_for_input(which.input); !result.is_ok())
            return result;
        return device_.input(which.input);
    }

    void make_dark() { device_.disarm(); } ///< before flash is changed: nobody could do it meanwhile
    Outcome<Begun> carry_out(const Begin& what, Asked asked)
    {
        if (what.home == Home::slot)
            make_dark();
        return upload_.begin(what, asked.tag, asked.now);
    }
    Completion<Kind::commit> carry_out(const Commit&, Asked by) { return upload_.commit(by.tag, by.now); }
    Completion<Kind::cancel> carry_out(const Cancel&, Asked by) { return upload_.cancel(by.tag); }

    Outcome<SlotContents> carry_out(const AskSlot& which, Asked)
    {
        if (const StatusWithNumber result = slot_exists(which.slot); !result.is_ok())
            return result;
        const SlotEntry& entry = slots_.entry(which.slot);
        return SlotContents{.slot = which.slot,
                            .is_chosen = slots_.chosen() == which.slot,
                            .size = entry.size,
                            .crc = entry.crc,
                            .name = entry.name};
    }
    Completion<Kind::erase> carry_out(const EraseSlot& which, Asked)
    {
        if (const StatusWithNumber result = slot_exists(which.slot); !result.is_ok())
            return result;
        make_dark();
        upload_.forget_last();
        return slots_.erase(which.slot);
    }
    Completion<Kind::choose> carry_out(const ChooseSlot& which, Asked)
    {
        make_dark();
        return library_.choose(which.slot);
    }

    Completion<Kind::play> carry_out(const Play& what, Asked) { return library_.play(what); }

    void carry_out(SilenceAction action)
    {
        switch (action) {
        case SilenceAction::hold:
            return device_.pause();
        case SilenceAction::start:
            return library_.return_to_start();
        }
    }

    Completion<Kind::silence> carry_out(const Silence& silence, Asked asked)
    {
        silence_.arm(silence, asked.now);
        return Status::ok;
    }

    Completion<Kind::pause> carry_out(const Pause&, Asked)
    {
        device_.pause();
        return Status::ok;
    }
    Completion<Kind::resume> carry_out(const Resume&, Asked)
    {
        device_.resume();
        return Status::ok;
    }
    Completion<Kind::seek> carry_out(const Seek& where, Asked)
    {
        device_.seek(where.moment);
        return Status::ok;
    }
    Completion<Kind::speed> carry_out(const Speed& how, Asked)
    {
        if (how.speed < -Playhead::fastest || how.speed > Playhead::fastest)
            return Status::bad_value;
        device_.set_speed(how.speed);
        return Status::ok;
    }
    Completion<Kind::brightness> carry_out(const Brightness& how, Asked)
    {
        return device_.set_brightness(how.brightness);
    }

    Completion<Kind::inputs> carry_out(const Inputs& inputs, Asked) // all of them, or none
    {
        if (!inputs.is_valid())
            return Status::bad_value;
        const auto places = std::span{inputs.places}.first(inputs.count);
        for (const InputPlace& each : places)
            if (const StatusWithNumber result = look_for_input(each.input); !result.is_ok())
                return result;
        for (const InputPlace& each : places)
            device_.set_input(each.input, each.place);
        return Status::ok;
    }

    Completion<Kind::text> carry_out(const Text& text, Asked)
    {
        if (text.length > Text::max)
            return Status::bad_value;
        if (const StatusWithNumber result = look_for_input(text.input); !result.is_ok())
            return result;
        return device_.set_text(text.input, text.view());
    }

    Completion<Kind::points> carry_out(const Points& points, Asked)
    {
        return deliver({.which = DrawingNumber::of(points.which),
                        .part = points.part,
                        .count = std::nullopt,
                        .points = points.points});
    }
    Completion<Kind::drawing> carry_out(const Drawing& last, Asked)
    {
        return deliver({.which = DrawingNumber::of(last.which),
                        .part = last.part,
                        .count = last.count,
                        .points = last.points});
    }
    StatusWithNumber deliver(const DrawingPart& part)
    {
        const StatusWithNumber result = look_for_input(part.which.input);
        return result.is_ok() ? StatusWithNumber{device_.deliver(part)} : result;
    }

    Completion<Kind::arm> carry_out(const Arm&, Asked) { return device_.arm(); }
    Completion<Kind::disarm> carry_out(const Disarm&, Asked) { return device_.disarm(); }

    Completion<Kind::boot_loader> carry_out(const EnterBootLoader&, Asked asked)
    {
        return device_.enter_boot_loader(asked.now);
    }

    D& device_;
    SlotStore<F>& slots_;
    Upload<D, F> upload_;
    SceneLibrary<D, F> library_;
    AnswerQueue answers_;
    SilenceWatch silence_;
    std::optional<Report> waiting_; ///< a request that could not be carried out yet
    std::uint32_t errors_ = 0;
};

}
