#pragma once

#include "host/link/live_values.hpp"
#include "host/link/report_pipe.hpp"

#include <condition_variable>
#include <mutex>
#include <optional>

namespace kfast {

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

}
