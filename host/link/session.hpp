#pragma once

#include "firmware/link/fields.hpp"
#include "firmware/link/message.hpp"
#include "host/link/report_pipe.hpp"
#include "host/program/failure.hpp"

#include <cstdint>
#include <optional>

namespace kfast {

/// A device has refused a request.
class Refusal : public Failure {
public:
    explicit Refusal(const link::Failure& failure);

    Status status() const { return status_; }
    /// The number that belongs to the status.
    std::uint32_t number() const { return number_; }

private:
    Status status_;
    std::uint32_t number_;
};

/// How long a device may be silent before it is asked again: for what it does without its flash, and with it.
inline constexpr Milliseconds patience_with_ram{50};
inline constexpr Milliseconds patience_with_flash{600};
/// A device that is asked twice to play begins twice, and it looks at the whole scene before it answers.
inline constexpr Milliseconds patience_to_begin{600};

/// Asks a device and reads its answers, over a pipe that may lose, repeat, reorder and damage (docs/link.md):
/// what its checksum shows to be damaged was never heard. It repeats a request without an answer, each time
/// after a longer silence, up to its last patience.
///
/// All members throw Failure with unplugged, with timed_out when the last patience is over, and Interrupted
/// (interruption.hpp).
class Session {
public:
    /// How it sends requests.
    struct Options {
        Milliseconds last_patience{10'000};
        /// No device may take requests for those of a previous session, so it is chosen at random.
        std::uint8_t first_tag = 1;
    };

    /// The pipe must outlive it.
    Session(ReportPipe& pipe, const Options& options);

    /// The device's answer. Throws Refusal.
    template <class A, class M>
    A ask(const M& message, Milliseconds patience = patience_with_ram)
    {
        return ask_with<A>(message, new_tag(), patience);
    }
    template <class A, class M>
    A ask_with(const M& message, std::uint8_t tag, Milliseconds patience)
    {
        const auto is_answer = [](const Report& report) { return link::message_of<A>(report).has_value(); };
        return *link::message_of<A>(exchange(link::report_of(message, tag), patience, is_answer));
    }
    /// A request whose answer says only that it was carried out.
    template <class M>
    void order(const M& message, Milliseconds patience = patience_with_ram)
    {
        ask<link::Done<M::kind>>(message, patience);
    }
    /// A request that is answered only if it fails: see throw_pending_failure().
    template <class M>
    void post(const M& message)
    {
        send(link::report_of(message, 0));
    }
    /// Throws Refusal if a request that was sent was refused. Does not wait.
    void throw_pending_failure();

    /// Different from the recent ones. Never 0.
    std::uint8_t new_tag();
    void send(const Report& report);
    /// The next report with that tag, for which it waits for `patience`.
    std::optional<Report> hear(std::uint8_t tag, Milliseconds patience);
    Milliseconds now() const { return pipe_.now(); }
    Milliseconds last_patience() const { return options_.last_patience; }
    /// The next time of silence, after one that was not enough.
    static Milliseconds longer(Milliseconds patience);

    /// Sends a last report to a device, and waits for it a little, also after an
    /// interruption. Throws nothing.
    void take_leave(const Report& report);

private:
    using IsAnswer = bool (*)(const Report& report);

    /// The first report that is an answer to the request. Throws Refusal.
    Report exchange(const Report& request, Milliseconds patience, IsAnswer is_answer);
    std::optional<Report> await(const Report& request, Milliseconds patience, IsAnswer is_answer);
    std::optional<Report> hear_until(std::uint8_t tag, Milliseconds end);
    void remember_failure(const Report& report);

    ReportPipe& pipe_;
    Options options_;
    std::uint8_t tag_;
    std::optional<link::Failure> pending_failure_; ///< the first failure of a request that was sent
};

/// Why the device refuses a request by a report of that kind, if this says so. That a report
/// came damaged is no reason: it is sent again.
std::optional<link::Failure> refusal_in(const Report& answer, std::uint8_t kind);

/// Throws Failure with timed_out.
[[noreturn]] void give_up(Milliseconds waited);

}
