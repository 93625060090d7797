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

/// What inputs of a scene are to be from now on, by their numbers.
struct LiveValues {
    std::map<std::uint8_t, Time> places = {}; ///< of numbers: 0 … whole_input
    std::map<std::uint8_t, std::string> texts = {};
    std::map<std::uint8_t, ReceivedDrawing> drawings = {};

    bool empty() const { return places.empty() && texts.empty() && drawings.empty(); }
    /// What is newer takes the place of what is here.
    void take(LiveValues newer)
    {
        newer.places.merge(places);
        newer.texts.merge(texts);
        newer.drawings.merge(drawings);
        *this = std::move(newer);
    }

    friend bool operator==(const LiveValues&, const LiveValues&) = default;
};

/// What a device is to be sent of live values, handed from the thread that reads them to the one that sends
/// them. What has not been sent yet is replaced by what is newer.
class LiveFeed {
public:
    /// They belong together.
    void put(const LiveValues& values);
    /// Nothing more will come.
    void close();

    /// What is new, for which it waits so long; nothing once all has been taken and nothing more will come.
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
