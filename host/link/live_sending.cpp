#include "host/link/live_sending.hpp"

#include "core/kfb_limits.hpp"
#include "host/drawing_reports.hpp"
#include "host/link/interruption.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>

namespace kfast {
namespace {

/// So often failures and interruptions are looked for.
constexpr Milliseconds unheeded_at_most{100};

/// Numbers the drawings of each input.
class DrawingSending {
public:
    explicit DrawingSending(Session& session) : session_{session} {}

    /// Whether there were any.
    bool send(const std::map<std::uint8_t, ToldDrawing>& drawings)
    {
        for (const auto& [input, drawing] : drawings)
            for (const link::Report& report : drawing_reports(drawing, input, numbers_.at(input)++))
                session_.send(report);
        return !drawings.empty();
    }

private:
    Session& session_;
    std::array<std::uint8_t, kfb::max_inputs> numbers_{};
};

}

void send_live(Session& session, LiveFeed& feed, Milliseconds keep_alive)
{
    Milliseconds told = session.now();
    DrawingSending drawings{session};
    while (const auto reports = feed.take(std::min(keep_alive, unheeded_at_most))) {
        heed_interruption();
        for (const link::Inputs& report : *reports)
            session.tell(report);
        const bool has_drawings = drawings.send(feed.take_drawings());
        if (!reports->empty() || has_drawings) {
            told = session.now();
        } else if (session.now() - told >= keep_alive) {
            session.tell(link::Inputs{});
            told = session.now();
        }
        session.tell_failures();
    }
    session.ask<link::Playing>(link::AskPlaying{}); // what failed of the last values is told before
    session.tell_failures();
}

}
