#include "host/link/live_sending.hpp"

#include "host/link/interruption.hpp"

#include <algorithm>

namespace kfast {
namespace {

/// So often failures and interruptions are looked for.
constexpr Milliseconds unheeded_at_most{100};

}

void send_live(Session& session, LiveFeed& feed, Milliseconds keep_alive)
{
    Milliseconds told = session.now();
    while (const auto reports = feed.take(std::min(keep_alive, unheeded_at_most))) {
        heed_interruption();
        for (const link::Inputs& report : *reports)
            session.tell(report);
        if (!reports->empty()) {
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
