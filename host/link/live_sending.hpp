#pragma once

#include "host/link/live_feed.hpp"
#include "host/link/session.hpp"

namespace kfast {

/// Sends what the feed has, until nothing more will come; the device is sent something at least every
/// `keep_alive`, so that it does not take a pause of the values for the end. Throws what Session throws, and
/// Refusal.
void send_live(Session& session, LiveFeed& feed, Milliseconds keep_alive);

}
