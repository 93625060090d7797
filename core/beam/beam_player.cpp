#include "core/beam/beam_player.hpp"

#include "core/beam/beam_tracer.hpp"
#include "core/block_cutter.hpp"

#include <algorithm>
#include <array>

namespace kfast {
namespace {

/// How the lent block is divided: one part after the other.
struct BlockPlan {
    std::size_t lines; ///< bytes of each part
    std::size_t legs;
    std::size_t live;

    BlockPlan(const SceneView& scene, std::size_t live_bytes)
        : lines{scene.outline_bytes() + 64}, legs{lines / sizeof(BeamLine) * sizeof(BeamLeg) / 4 * 4},
          live{live_bytes}
    {
    }

    std::size_t size() const { return lines + legs + live; }
};

Size field_panel(const BeamProfile& profile) { return {profile.resolution, profile.resolution}; }

}

std::size_t BeamPlayer::block_bytes(const SceneView& scene, const BeamProfile&)
{
    return BlockPlan{scene, bytes_for(scene)}.size();
}

Result<BeamPlayer> BeamPlayer::create(const SceneView& scene, const BeamProfile& profile,
                                      std::uint32_t budget, std::span<std::byte> block)
{
    const std::size_t bytes = block_bytes(scene, profile);
    if (block.size() < bytes)
        return Error::block_too_small;
    return BeamPlayer{scene, profile, budget, block.first(bytes)};
}

BeamPlayer::BeamPlayer(const SceneView& scene, const BeamProfile& profile, std::uint32_t budget,
                       std::span<std::byte> block)
    : LiveScene{scene, field_panel(profile), Fit::contain, block.last(bytes_for(scene))}, profile_{profile},
      budget_{std::min(budget, profile.rate / profile.least_refresh)}
{
    const BlockPlan plan{scene, bytes_for(scene)};
    BlockCutter cutter{block};
    lines_ = BeamLines{cutter.cut(plan.lines)};
    leg_storage_ = cutter.cut_as<BeamLeg>(plan.legs);
    trace({});
}

void BeamPlayer::show(Time time) { show_moment(wrap(time, scene().length(), scene().loop())); }

void BeamPlayer::show_moment(Time moment)
{
    moment = std::clamp(moment, Time{}, scene().length());
    if (!still_.holds(moment, take_moved()))
        trace(moment);
}

void BeamPlayer::trace(Time time)
{
    const Moment moment = pose(time);
    BeamTracer tracer{on_panel(), moment, profile_.resolution, lines_};
    tracer.run();
    still_ = tracer.still();
    const std::span<BeamLeg> legs = leg_storage_.first(std::min(lines_.size(), leg_storage_.size()));
    find_route(lines_, profile_.park, legs);
    legs_ = legs;
    measure();
}

void BeamPlayer::measure()
{
    report_ = {.lines = static_cast<std::uint32_t>(lines_.size()), .is_complete = !lines_.is_full()};
    BeamPlot counted = plot();
    std::array<BeamPoint, 32> points;
    while (const std::size_t count = counted.next(points)) {
        report_.points += static_cast<std::uint32_t>(count);
        for (const BeamPoint& point : std::span{points}.first(count))
            report_.lit_points += point.is_lit() ? 1 : 0;
    }
}

}
