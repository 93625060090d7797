#include "host/link/live_feed.hpp"

#include "core/scene/kfb_limits.hpp"
#include "firmware/link/input_message.hpp"
#include "host/player/received_drawing.hpp"
#include "host/program/interruption.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast {

void LiveFeed::put(const LiveValues& values)
{
    {
        const std::lock_guard lock{mutex_};
        values_.take(values);
    }
    changed_.notify_one();
}

void LiveFeed::close()
{
    {
        const std::lock_guard lock{mutex_};
        is_closed_ = true;
    }
    changed_.notify_one();
}

std::optional<LiveValues> LiveFeed::take(Milliseconds patience)
{
    std::unique_lock lock{mutex_};
    changed_.wait_for(lock, patience, [&] { return is_closed_ || !values_.empty(); });
    if (is_closed_ && values_.empty())
        return std::nullopt;
    return std::exchange(values_, {});
}

namespace {

/// How often failures and interruptions are checked.
constexpr Milliseconds unheeded_at_most{100};

/// The values of a line are in one report, as far as it has room.
std::vector<link::Inputs> reports_of(const std::map<std::uint8_t, Time>& places)
{
    std::vector<link::Inputs> reports;
    for (const auto& [input, place] : places) {
        if (reports.empty() || reports.back().count == link::Inputs::max)
            reports.emplace_back();
        link::Inputs& report = reports.back();
        report.places[report.count++] = {input, place};
    }
    return reports;
}

/// `text` has no more bytes than a report.
link::Text report_of(std::uint8_t input, std::string_view text)
{
    link::Text report{.input = input, .length = static_cast<std::uint8_t>(text.size())};
    std::ranges::copy(std::as_bytes(std::span{text}), report.bytes.begin());
    return report;
}

class LiveSending {
public:
    explicit LiveSending(Session& session) : session_{session} {}

    void send(const LiveValues& values)
    {
        for (const link::Inputs& report : reports_of(values.places))
            session_.post(report);
        for (const auto& [input, text] : values.texts)
            session_.post(report_of(input, text));
        for (const auto& [input, drawing] : values.drawings)
            for (const Report& report : drawing_reports(drawing, input, numbers_.at(input)++))
                session_.send(report);
    }
    /// Shows the device that somebody is there.
    void send_nothing() { session_.post(link::Inputs{}); }

private:
    Session& session_;
    std::array<std::uint8_t, kfb::max_inputs> numbers_{}; ///< of the next drawing of each input
};

}

void send_live(Session& session, LiveFeed& feed, Milliseconds keep_alive)
{
    Milliseconds last_sent = session.now();
    LiveSending sending{session};
    while (const auto values = feed.take(std::min(keep_alive, unheeded_at_most))) {
        heed_interruption();
        const bool is_time = session.now() - last_sent >= keep_alive;
        if (!values->empty())
            sending.send(*values);
        else if (is_time)
            sending.send_nothing();
        if (!values->empty() || is_time)
            last_sent = session.now();
        session.throw_pending_failure();
    }
    session.ask<link::Playing>(link::AskPlaying{}); // failures of the last values are reported before
    session.throw_pending_failure();
}

}
