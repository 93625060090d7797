#include "host/link/session.hpp"

#include "firmware/link/checksum.hpp"
#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <exception>
#include <sstream>
#include <string>
#include <utility>

namespace kfast {

namespace {

ExitStatus exit_status_of(Status status)
{
    switch (status) {
    case Status::no_room:
    case Status::too_large:
    case Status::block_too_small:
        return ExitStatus::no_room;
    case Status::unsupported_version:
    case Status::unknown_kind:
        return ExitStatus::wrong_version;
    case Status::timed_out:
        return ExitStatus::timed_out;
    default: // devices to come may report others
        return ExitStatus::refused;
    }
}

/// What would help; empty if nothing is known.
std::string hint_of(const link::Failure& failure)
{
    const std::string number = std::to_string(failure.number);
    switch (failure.status) {
    case Status::no_room:
        return "there is room for " + number + " bytes: erase a slot ('kfast erase'), or shorten the scene";
    case Status::too_large:
        return "it holds " + number + " bytes: upload it to a slot ('kfast upload'), or shorten the scene";
    case Status::block_too_small:
        return "'kfast fit' tells how much the scene needs; in RAM it lies in the same memory itself, so "
               "'kfast upload --play' may do";
    case Status::too_slow:
        return std::string{slow_scene_hint};
    case Status::unsupported_version:
    case Status::unknown_kind:
        return "update the firmware of the device, or use the kfast that belongs to it";
    case Status::bad_checksum:
        return "try again, with another cable if need be";
    case Status::no_transfer:
        return "if another program sends a scene as well, try again when it is done";
    case Status::timed_out:
        return "try again";
    case Status::no_such_slot:
        return "they go from 0 to " + std::to_string(failure.number == 0 ? 0 : failure.number - 1);
    case Status::empty_slot:
        return "'kfast slots' lists what there is";
    case Status::nothing_in_ram:
        return "send one with 'kfast play SCENE'";
    case Status::nothing_plays:
        return "play one with 'kfast play SCENE'";
    case Status::no_scene:
        return "'kfast upload SCENE --choose' brings one for the start, 'kfast uf2 pack --scene' a built-in "
               "one";
    case Status::no_laser:
        return "a beam is dangerous if its board's settings say laser=#true";
    case Status::no_such_clip:
        return "'kfast info SCENE' lists them";
    case Status::no_such_input:
        return "another scene plays by now: begin anew";
    default:
        return {};
    }
}

std::string in_words(const link::Failure& failure)
{
    const std::string text = visible(failure.text.view());
    const std::string said =
        text.empty() ? "error " + std::to_string(static_cast<unsigned>(failure.status)) : text;
    const std::string hint = hint_of(failure);
    return "the device says: " + said + (hint.empty() ? "" : ": " + hint);
}

}

Refusal::Refusal(const link::Failure& failure)
    : Failure{in_words(failure), exit_status_of(failure.status)},
      status_{failure.status},
      number_{failure.number}
{
}

namespace {

/// How often an interruption is checked.
constexpr Milliseconds unheeded_at_most{100};
constexpr Milliseconds longest_patience{2000};
constexpr Milliseconds patience_when_leaving{500};

}

Session::Session(ReportPipe& pipe, const Options& options)
    : pipe_{pipe}, options_{options}, tag_{static_cast<std::uint8_t>(options.first_tag - 1)}
{
}

std::uint8_t Session::new_tag()
{
    tag_ = tag_ == 0xFF ? std::uint8_t{1} : static_cast<std::uint8_t>(tag_ + 1);
    return tag_;
}

void Session::send(const Report& report)
{
    heed_interruption();
    pipe_.send(link::with_checksum(report));
}

std::optional<Report> Session::hear(std::uint8_t tag, Milliseconds patience)
{
    return hear_until(tag, pipe_.now() + patience);
}

// Reads at least once, so that what has come is read without patience as well.
std::optional<Report> Session::hear_until(std::uint8_t tag, Milliseconds end)
{
    for (;;) {
        heed_interruption();
        const Milliseconds left = std::max(end - pipe_.now(), Milliseconds{0});
        const auto report = pipe_.receive(std::min(left, unheeded_at_most));
        const bool is_whole = report && link::is_whole(*report);
        if (is_whole && report->tag() == tag && (report->kind() & from_device) != 0)
            return report;
        if (is_whole)
            remember_failure(*report);
        if (pipe_.now() >= end && (!report || left > Milliseconds{0}))
            return std::nullopt;
    }
}

/// Remembers the failure of what was sent without a tag.
void Session::remember_failure(const Report& report)
{
    const auto failure = link::message_of<link::Failure>(report);
    if (failure && failure->status != Status::bad_report && report.tag() == 0 && !pending_failure_)
        pending_failure_ = failure;
}

void Session::throw_pending_failure()
{
    while (const auto report = hear(0, Milliseconds{0}))
        remember_failure(*report);
    if (const auto failure = std::exchange(pending_failure_, std::nullopt))
        throw Refusal{*failure};
}

Milliseconds Session::longer(Milliseconds patience)
{
    return std::max(patience, std::min(2 * patience, longest_patience));
}

std::optional<Report> Session::await(const Report& request, Milliseconds patience, IsAnswer is_answer)
{
    const Milliseconds end = pipe_.now() + patience;
    while (const auto report = hear_until(request.tag(), end)) {
        if (is_answer(*report))
            return report;
        if (const auto failure = refusal_in(*report, request.kind()))
            throw Refusal{*failure};
        if (pipe_.now() >= end)
            break;
    }
    return std::nullopt;
}

Report Session::exchange(const Report& request, Milliseconds patience, IsAnswer is_answer)
{
    const Milliseconds begin = pipe_.now();
    for (;; patience = longer(patience)) {
        send(request);
        if (const auto answer = await(request, patience, is_answer))
            return *answer;
        if (pipe_.now() - begin >= options_.last_patience)
            give_up(options_.last_patience);
    }
}

void Session::take_leave(const Report& report)
{
    try {
        pipe_.send(link::with_checksum(report));
        const Milliseconds end = pipe_.now() + patience_when_leaving;
        while (pipe_.now() < end) {
            const auto answer = pipe_.receive(end - pipe_.now());
            if (answer && link::is_whole(*answer) && answer->tag() == report.tag() &&
                answer->kind() == (report.kind() | from_device))
                return;
        }
    } catch (const std::exception&) { // nobody is there any more, or there is no memory
    }
}

std::optional<link::Failure> refusal_in(const Report& answer, std::uint8_t kind)
{
    const auto failure = link::message_of<link::Failure>(answer);
    const bool has_reason = failure && failure->request == kind && failure->status != Status::bad_report;
    return has_reason ? failure : std::nullopt;
}

void give_up(Milliseconds waited)
{
    std::ostringstream seconds;
    seconds << static_cast<double>(waited.count()) / 1000;
    throw Failure{"the device has not answered for " + seconds.str() +
                      " seconds: unplug it, plug it in again, and ask once more; or wait longer, with "
                      "--timeout",
                  ExitStatus::timed_out};
}

}
