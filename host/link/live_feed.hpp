#pragma once

#include "firmware/link/message.hpp"
#include "host/link/report_pipe.hpp"
#include "host/told_drawing.hpp"

#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace kfast {

/// What a device is to be told of live values, handed from the thread that reads them to the one that sends
/// them. What has not been sent yet is replaced by what is newer.
class LiveFeed {
public:
    /// Values that belong together: they are sent together, as far as a report has room.
    void put(std::span<const link::InputPlace> places);
    void put(std::uint8_t input, const ToldDrawing& drawing);
    /// Nothing more will come.
    void close();

    /// What is new, for which it waits so long; nothing once all has been sent and nothing more will come.
    /// None if only drawings are new.
    std::optional<std::vector<link::Inputs>> take(Milliseconds patience);
    /// The drawings that are new, by their inputs. Does not wait.
    std::map<std::uint8_t, ToldDrawing> take_drawings();

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::map<std::uint8_t, Time> places_;
    std::map<std::uint8_t, ToldDrawing> drawings_;
    bool is_closed_ = false;
};

}
