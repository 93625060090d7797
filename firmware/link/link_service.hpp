#pragma once

#include "firmware/chip/microseconds.hpp"
#include "firmware/link/link.hpp"
#include "firmware/link/playback_session.hpp"
#include "firmware/report.hpp"
#include "firmware/slots/slot_store.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace kfast::link {

// Compound requirements would be torn apart.
// clang-format off

/// What carries reports, one computer at a time.
template <class P>
concept Pipe = requires(P& pipe, const Report& report) {
    /// The oldest report that has come and was not taken.
    { pipe.take() } -> std::same_as<std::optional<Report>>;
    /// Returns false if there is no room for it now, or nobody to take it.
    { pipe.send(report) } -> std::same_as<bool>;
    /// Whether a computer is there, and awake.
    { pipe.is_connected() } -> std::same_as<bool>;
    /// Changes when a computer begins anew. What was on its way before is lost, in both directions.
    { pipe.connections() } -> std::same_as<std::uint32_t>;
};

// clang-format on

/// Passes the reports of a pipe to what plays, and the answers back: all that a board does for the link,
/// besides drawing.
template <Pipe P, Flash F>
class LinkService {
public:
    /// All of them must outlive the service. Nothing else changes the slots.
    LinkService(P& pipe, PlaybackSession& playback, SlotStore<F>& slots)
        : pipe_{pipe}, playback_{playback}, link_{playback, slots}, connection_{pipe.connections()}
    {
    }

    /// Plays what plays when the device starts. Must be called before anything is drawn.
    void begin() { link_.play_start(); }

    /// Handles what has come, and lets time pass. Must be called often: before each part of a picture, and
    /// while the board waits for anything. `now()` is the time.
    template <class Now>
    void serve(Now&& now)
    {
        look_at_computer();
        send_answers();
        for (int left = max_reports; left > 0 && !playback_.is_changing(); --left) {
            const auto report = pipe_.take();
            if (!report)
                break;
            link_.take(report->bytes, now());
            link_.hear(now());
            send_answers();
        }
        if (!playback_.is_changing())
            link_.pass(now());
        send_answers();
    }

private:
    /// The maximum at once: endless requests do not keep the board from drawing.
    static constexpr int max_reports = 8;

    void look_at_computer()
    {
        const bool is_there = pipe_.is_connected();
        if (was_there_ && !is_there)
            link_.lose_computer();
        was_there_ = is_there;
        if (pipe_.connections() == connection_)
            return;
        connection_ = pipe_.connections();
        link_.begin_session();
        unsent_.reset();
    }

    void send_answers()
    {
        while (true) {
            if (!unsent_)
                unsent_ = link_.next_report();
            if (!unsent_ || !pipe_.send(*unsent_))
                return;
            unsent_.reset();
        }
    }

    P& pipe_;
    PlaybackSession& playback_;
    Link<PlaybackSession, F> link_;
    std::optional<Report> unsent_; ///< the report for which the pipe had no room
    bool was_there_ = false;
    std::uint32_t connection_;
};

}
