#include "core/beam/beam_player.hpp"

#include "core/beam/beam_tracer.hpp"
#include "core/beam/hatching.hpp"
#include "core/bytes/bump_allocator.hpp"

#include <algorithm>
#include <array>

namespace kfast {
namespace {

constexpr std::size_t whole_words(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

/// How the lent block is divided: one part after the other.
struct BlockPlan {
    std::size_t lines; ///< bytes of each part
    std::size_t legs;
    std::size_t live;

    BlockPlan(const SceneView& scene, const BeamProfile& profile, std::size_t live_bytes)
        : lines{line_bytes(scene, profile)},
          legs{whole_words(BeamLines::max_in(lines) * sizeof(BeamLeg))},
          live{live_bytes}
    {
    }

    /// Outlines take 8 bytes for each corner while they come in, twice that for a stroke, and then at least
    /// 88 for each contour (core/raster/outline/outline_store.hpp). A closed line in the field takes 4 for
    /// each piece, and 16, or 20 for each piece if all of them leave the field and come back: there is room
    /// for any contour, and for any number of contours of 50 pieces. Curves cross the border three times at
    /// most, so that the same room is enough for four times as many pieces: they double where a field has 4
    /// times as many pixels as the canvas. Dots with flat ends, which only a beam shows, are not counted
    /// there.
    static std::size_t line_bytes(const SceneView& scene, const BeamProfile& profile)
    {
        std::size_t bytes = scene.outline_bytes() * std::size_t{20} / 8;
        for (int reach = 16 * std::max(scene.canvas().width, scene.canvas().height);
             reach < profile.resolution; reach *= 4)
            bytes *= 2;
        return whole_words(bytes) + hatching_bytes(scene) + 64;
    }

    std::size_t size() const { return lines + legs + live; }
};

/// The number of lit points as they are sent: a laser is not always lit where its lines are (StandingLight).
std::uint32_t lit_points(PointStream plot)
{
    std::uint32_t lit = 0;
    std::array<BeamPoint, 32> points;
    while (const std::size_t count = plot.next(points))
        for (const BeamPoint& point : std::span{points}.first(count))
            lit += point.is_lit() ? 1 : 0;
    return lit;
}

Size field_panel(const BeamProfile& profile) { return {profile.resolution, profile.resolution}; }

}

std::size_t BeamPlayer::block_bytes(const SceneView& scene, const BeamProfile& profile)
{
    return BlockPlan{scene, profile, bytes_for(scene)}.size();
}

Result<BeamPlayer> BeamPlayer::create(const SceneView& scene, const BeamProfile& profile,
                                      std::uint32_t budget, std::span<std::byte> block)
{
    const std::size_t bytes = block_bytes(scene, profile);
    if (block.size() < bytes)
        return Error::block_too_small;
    return Result<BeamPlayer>{std::in_place, scene, profile, budget, block.first(bytes)};
}

BeamPlayer::BeamPlayer(const SceneView& scene, const BeamProfile& profile, std::uint32_t budget,
                       std::span<std::byte> block)
    : SceneState{scene, field_panel(profile), Fit::contain, block.last(bytes_for(scene))},
      profile_{profile},
      budget_{std::min(budget, profile.rate / std::max<std::uint32_t>(profile.min_refresh, 1))}
{
    const BlockPlan plan{scene, profile, bytes_for(scene)};
    BumpAllocator cutter{block};
    lines_ = BeamLines{cutter.cut(plan.lines)};
    leg_storage_ = cutter.cut_as<BeamLeg>(plan.legs);
    move_to({});
    trace();
}

void BeamPlayer::show(Time time) { show_moment(wrap(time, scene().length(), scene().loop())); }

void BeamPlayer::show_moment(Time moment)
{
    moment = std::clamp(moment, Time{}, scene().length());
    if (dependence_.is_touched_by(move_to(moment)))
        trace();
}

/// Traces the scene at the time to which it was moved.
void BeamPlayer::trace()
{
    pose_bones();
    BeamTracer tracer{on_panel(), profile_.resolution, lines_};
    tracer.run();
    dependence_ = tracer.dependence();
    wider_hatchings_ = tracer.wider_hatchings();
    is_coarse_ = tracer.coarseness() != 0 || wider_hatchings_ != 0 || lines_.is_full();
    const std::span<BeamLeg> legs = leg_storage_.first(lines_.size());
    compared_ = find_route(lines_, profile_.park, legs);
    legs_ = legs;
    measure();
}

void BeamPlayer::measure()
{
    timing_ = find_timing(lines_, legs_, profile_, budget_, timing_.speed_level);
    const BeamAmount& amount = timing_.amount;
    report_ = {.points = amount.points,
               .lit_points = profile_.is_laser ? lit_points(plot()) : amount.lit_points,
               .lit_length = amount.lit_length,
               .blanked_length = amount.blanked_length,
               .lines = static_cast<std::uint32_t>(timing_.legs),
               .corners = static_cast<std::uint32_t>(lines_.corners()),
               .compared = compared_,
               .speed_level = timing_.speed_level,
               .is_complete = !lines_.is_full() && timing_.legs == lines_.size(),
               .wider_hatchings = wider_hatchings_};
}

}
