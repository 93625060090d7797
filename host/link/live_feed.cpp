#include "host/link/live_feed.hpp"

#include <utility>

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

}
