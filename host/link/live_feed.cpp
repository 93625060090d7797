#include "host/link/live_feed.hpp"

#include <utility>

namespace kfast {
namespace {

std::vector<link::Inputs> reports_of(const std::map<std::uint8_t, Time>& places)
{
    std::vector<link::Inputs> reports;
    for (const auto& [input, place] : places) {
        if (reports.empty() || reports.back().count == link::Inputs::most)
            reports.emplace_back();
        link::Inputs& report = reports.back();
        report.places[report.count++] = {input, place};
    }
    return reports;
}

}

void LiveFeed::put(std::span<const link::InputPlace> places)
{
    {
        const std::lock_guard lock{mutex_};
        for (const link::InputPlace& place : places)
            places_[place.input] = place.place;
    }
    changed_.notify_one();
}

void LiveFeed::put(std::uint8_t input, const ToldDrawing& drawing)
{
    {
        const std::lock_guard lock{mutex_};
        drawings_[input] = drawing;
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

std::optional<std::vector<link::Inputs>> LiveFeed::take(Milliseconds patience)
{
    std::unique_lock lock{mutex_};
    changed_.wait_for(lock, patience, [&] { return is_closed_ || !places_.empty() || !drawings_.empty(); });
    if (is_closed_ && places_.empty() && drawings_.empty())
        return std::nullopt;
    auto reports = reports_of(places_);
    places_.clear();
    return reports;
}

std::map<std::uint8_t, ToldDrawing> LiveFeed::take_drawings()
{
    const std::lock_guard lock{mutex_};
    return std::exchange(drawings_, {});
}

}
