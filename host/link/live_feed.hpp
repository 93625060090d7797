#pragma once

#include "core/time/time.hpp"
#include "host/link/report_pipe.hpp"
#include "host/link/session.hpp"
#include "host/player/received_drawing.hpp"

#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace kfast {

/// New values of inputs of a scene, by their numbers.
struct LiveValues {
    std::map<std::uint8_t, Time> places = {}; ///< of numbers: 0 … whole_input
    std::map<std::uint8_t, std::string> texts = {};
    std::map<std::uint8_t, ReceivedDrawing> drawings = {};

    bool empty() const { return places.empty() && texts.empty() && drawings.empty(); }
    /// Newer values replace those here.
    void take(LiveValues newer)
    {
        newer.places.merge(places);
        newer.texts.merge(texts);
        newer.drawings.merge(drawings);
        *this = std::move(newer);
    }

    friend bool operator==(const LiveValues&, const LiveValues&) = default;
};

/// Live values to be sent to a device, handed from the thread that reads them to the one that sends
/// them. What has not been sent yet is replaced by what is newer.
class LiveFeed {
public:
    /// Adds values that belong together.
    void put(const LiveValues& values);
    /// Ends the feed: nothing more will come.
    void close();

    /// The new values, waiting for `patience`; none once all has been taken and nothing more will come.
    std::optional<LiveValues> take(Milliseconds patience);

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    LiveValues values_;
    bool is_closed_ = false;
};

/// Sends what the feed has, until nothing more will come; the device is sent something at least every
/// `keep_alive`, so that it does not take a pause of the values for the end. Throws what Session throws, and
/// Refusal.
void send_live(Session& session, LiveFeed& feed, Milliseconds keep_alive);

}
