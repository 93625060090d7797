#pragma once

#include "firmware/run/board.hpp"
#include "tests/firmware/run/slow_panel.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast::test {

/// Keeps what it is told while frames take as long as a test says.
class SlowBoard {
public:
    explicit SlowBoard(std::size_t band_bytes) { bands_.fill(std::vector<std::byte>(band_bytes)); }

    SlowPanel& panel() { return panel_; }
    Microseconds now() const { return now_; }
    void sleep_until(Microseconds moment)
    {
        if (!reached(now_, moment))
            now_ = moment;
    }
    std::span<const std::byte> scene_bytes() const { return scene; }
    std::span<std::byte> block() { return {}; }
    std::array<std::span<std::byte>, 2> bands() { return {bands_[0], bands_[1]}; }
    bool running() const { return reports.size() < durations.size(); }
    void scene_started(const SceneView&) {}
    void watch(Rect area, std::span<const std::byte> pixels)
    {
        watched_areas.push_back(area);
        watched.insert(watched.end(), pixels.begin(), pixels.end());
    }
    void event_passed(const EventView& event) { story += std::string{event.name} + ' '; }
    void frame_shown(FrameReport report)
    {
        story += std::to_string(report.time.ticks / Time::ticks_per_frame) + ' ';
        shown_at.push_back(now_.count);
        now_ = now_ + Microseconds{durations[reports.size()]};
        reports.push_back(report);
    }
    void fault(Error error) { reported = error; }

    std::vector<std::byte> scene;
    std::vector<std::uint32_t> durations; ///< microseconds that each frame takes
    std::vector<FrameReport> reports;
    std::vector<std::uint32_t> shown_at;
    std::string story; ///< the events and the numbers of the frames, in order
    std::vector<Rect> watched_areas;
    std::vector<std::byte> watched;
    std::optional<Error> reported;

private:
    SlowPanel panel_;
    std::array<std::vector<std::byte>, 2> bands_;
    Microseconds now_{0xFFFF'FFFF - 49'999}; // wraps within the first frames
};

static_assert(WatchingBoard<SlowBoard>);
static_assert(EventBoard<SlowBoard>);
static_assert(!ChoosingBoard<SlowBoard>);
static_assert(!RedrawingBoard<SlowBoard>);

}
