#pragma once

#include "firmware/link/checksum.hpp"
#include "firmware/link/fields.hpp"
#include "firmware/link/message.hpp"
#include "firmware/link/upload_message.hpp"
#include "tests/firmware/slots/padded_scene.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace kfast::test {

/// A computer that uploads a scene by the rules of docs/link.md, a report a millisecond: it keeps the window
/// full, asks again what is not answered in 50 ms, and begins anew when the device has dropped the upload or
/// found it damaged.
class ModelHost {
public:
    /// The scene must outlive it.
    ModelHost(const link::Begin& begin, std::span<const std::byte> scene, std::uint8_t tag)
        : begin_{begin}, scene_{scene}, tag_{tag}
    {
    }

    bool has_ended() const { return step_ == Step::done || step_ == Step::refused; }
    bool has_succeeded() const { return step_ == Step::done; }
    Status refused() const { return refused_; }

    /// What it sends in this millisecond.
    std::optional<Report> next_report()
    {
        ++waited_;
        switch (step_) {
        case Step::begin:
            return asked_again(link::report_of(begin_, tag_));
        case Step::data:
            return next_block();
        case Step::commit:
            return asked_again(link::report_of(link::Commit{}, tag_));
        case Step::done:
        case Step::refused:
            break;
        }
        return std::nullopt;
    }

    void take(const Report& report)
    {
        if (report.tag() != tag_ || !link::is_whole(report))
            return;
        if (const auto begun = link::message_of<link::Begun>(report); begun && step_ == Step::begin)
            go_on_from(begun->next, begun->window);
        if (const auto acknowledgement = link::message_of<link::Acknowledgement>(report);
            acknowledgement && step_ == Step::data)
            hear(*acknowledgement);
        if (link::message_of<link::Done<link::Kind::commit>>(report) && step_ == Step::commit)
            step_ = Step::done;
        if (const auto failure = link::message_of<link::Failure>(report))
            hear(*failure);
    }

private:
    enum class Step { begin, data, commit, done, refused };

    static constexpr int patience = 50;

    std::uint32_t blocks() const { return link::blocks_of(begin_.size); }

    std::optional<Report> asked_again(const Report& report)
    {
        if (waited_ % patience != 1)
            return std::nullopt;
        return link::with_checksum(report);
    }

    std::optional<Report> next_block()
    {
        if (waited_ > patience)
            go_on_from(heard_, window_);
        if (next_ == blocks() || next_ >= heard_ + window_)
            return std::nullopt;
        link::Data data{.block = static_cast<std::uint16_t>(next_)};
        const auto rest = scene_.subspan(next_ * link::block_bytes);
        std::ranges::copy(rest.first(std::min(rest.size(), link::block_bytes)), data.bytes.begin());
        ++next_;
        return link::report_of(data, tag_);
    }

    void go_on_from(std::uint32_t block, std::uint32_t window)
    {
        waited_ = 0;
        heard_ = std::min(block, blocks());
        next_ = heard_;
        window_ = window;
        step_ = heard_ == blocks() ? Step::commit : Step::data;
    }

    void hear(const link::Acknowledgement& acknowledgement)
    {
        if (acknowledgement.is_missing || acknowledgement.next == blocks())
            return go_on_from(acknowledgement.next, acknowledgement.window);
        if (acknowledgement.next <= heard_ || acknowledgement.next > next_) // of before, or damaged
            return;
        heard_ = acknowledgement.next;
        next_ = std::max(next_, heard_);
        waited_ = 0;
    }

    void hear(const link::Failure& failure)
    {
        switch (failure.status) {
        case Status::incomplete:
            return go_on_from(failure.number, window_);
        case Status::no_transfer:
        case Status::timed_out:
        case Status::bad_checksum:
            if (step_ != Step::begin && !has_ended())
                begin_anew();
            return;
        case Status::no_room:
        case Status::too_large:
        case Status::flash_failed:
            refused_ = failure.status;
            step_ = Step::refused;
            return;
        default: // about something else, or damaged
            return;
        }
    }

    void begin_anew()
    {
        tag_ = static_cast<std::uint8_t>(tag_ % 255 + 1);
        waited_ = 0;
        step_ = Step::begin;
    }

    link::Begin begin_;
    std::span<const std::byte> scene_;
    std::uint8_t tag_;
    Step step_ = Step::begin;
    Status refused_ = Status::ok;
    int waited_ = 0;
    std::uint32_t heard_ = 0;
    std::uint32_t next_ = 0;
    std::uint32_t window_ = 0;
};

}
