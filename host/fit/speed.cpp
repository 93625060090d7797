#include "host/fit/speed.hpp"

#include "firmware/run/frame_clock.hpp"
#include "host/fit/cost_table.hpp"
#include "host/fit/scene_run.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::fit {

namespace {

/// Well below the 35 minutes of FrameClock.
constexpr double longest_frame = 1000;

Microseconds microseconds_of(double seconds)
{
    return {static_cast<std::uint32_t>(std::min(seconds / slack, longest_frame) * 1e6)};
}

}

Lateness lateness(std::span<const double> seconds, double frames_per_second)
{
    Lateness found{.frames = seconds.size()};
    const long rate = std::max(1L, std::lround(frames_per_second * 1000));
    FrameClock clock{static_cast<std::uint32_t>(rate), Microseconds{}};
    Microseconds now;
    for (std::size_t frame = 0; frame < seconds.size();) {
        now = now + microseconds_of(seconds[frame]);
        const bool is_late = reached(now, clock.following());
        const std::size_t moved = std::min<std::size_t>(clock.advance(now), seconds.size() - frame);
        found.left_out += moved - 1;
        found.late += moved - 1 + (is_late ? 1 : 0);
        frame += moved;
        if (!reached(now, clock.due()))
            now = clock.due();
    }
    return found;
}

std::string late_text(const Lateness& lateness)
{
    if (lateness.late == 0)
        return {};
    std::string text =
        std::to_string(lateness.late) + " of " + std::to_string(lateness.frames) + " pictures late";
    return lateness.left_out == 0 ? text
                                  : text + ", " + std::to_string(lateness.left_out) + " of them left out";
}

namespace {

class SpeedMeter {
public:
    SpeedMeter(const Target& target, const std::stop_token& stop, Speed& speed)
        : target_{target}, stop_{stop}, costs_{costs_of(target.processor)}, speed_{speed}
    {
    }

    void take_first(const FrameOps& frame) { speed_.first = cost_of(frame); }

    void take_noise(const FrameOps& frame) { speed_.noise = cost_of(frame); }

    void take(const FrameOps& frame)
    {
        go_on(stop_);
        const FrameCost cost = cost_of(frame);
        if (speed_.frames.empty() || cost.seconds() > worst_seconds_) {
            worst_seconds_ = cost.seconds();
            speed_.heaviest = heaviest_of(frame, cost);
        }
        speed_.frames.push_back(cost);
        speed_.coarse_pictures += frame.picture.coarseness != 0 ? 1 : 0;
        speed_.unrecorded_bands = std::max(speed_.unrecorded_bands, frame.unrecorded_bands);
        if (frame.picture.outlines.needed_bytes() > speed_.outlines.bytes)
            speed_.outlines = outlines_of(frame.moment, frame.picture);
    }

private:
    FrameCost cost_of(const FrameOps& frame) const
    {
        return cost_on(target_, {frame.moment, frame.work(), frame.areas, frame.bytes});
    }

    HeaviestItem heaviest_of(const FrameOps& frame, const FrameCost& cost) const
    {
        HeaviestItem heaviest;
        for (const auto& [path, work] : frame.by_item) {
            const double share = instructions(work, costs_) / cost.instructions;
            if (path != 0 && share > heaviest.share)
                heaviest = {path, share};
        }
        return heaviest;
    }

    const Target& target_;
    const std::stop_token& stop_;
    const ProcessorCosts& costs_;
    Speed& speed_;
    double worst_seconds_ = 0;
};

Limits limits_of(const std::vector<FrameCost>& frames, double FrameCost::*seconds)
{
    std::vector<double> sorted;
    std::ranges::transform(frames, std::back_inserter(sorted), seconds);
    std::ranges::sort(sorted);
    return {sorted[sorted.size() / 2], sorted.back()};
}

}

Speed measured_speed(const SceneView& scene, const Target& target, Fit fit, const std::stop_token& stop,
                     const ProgressCallback& on_progress)
{
    Speed speed;
    SpeedMeter meter{target, stop, speed};
    SceneRun run{scene, target, fit};
    const auto take = [&](const FrameOps& frame) {
        on_progress(speed.frames.size(), run.frames_of_all());
        meter.take(frame);
    };
    const auto take_into = [&](std::vector<double>& seconds) {
        return [&](const FrameOps& frame) {
            take(frame);
            seconds.push_back(speed.frames.back().seconds());
        };
    };
    run.visit_first(Time{0}, [&](const FrameOps& frame) { meter.take_first(frame); });
    run.visit_turn(Time{0}, take_into(speed.turn));
    run.visit_turn(Time{Time::ticks_per_frame / 2}, take);
    run.visit_presses([&](const FrameOps& frame) {
        take(frame);
        speed.leap = std::max(speed.leap, speed.frames.back().seconds());
    });
    run.visit_turn_with_inputs(take_into(speed.busy_turn));
    run.visit_end(take);
    run.visit_noise([&](const FrameOps& frame) { meter.take_noise(frame); });
    speed.overfull = run.overfull();
    speed.stride = run.stride();
    std::ranges::stable_sort(speed.frames, {}, &FrameCost::seconds);
    speed.by_cpu = limits_of(speed.frames, &FrameCost::cpu_seconds);
    speed.by_bus = limits_of(speed.frames, &FrameCost::bus_seconds);
    return speed;
}

}
