#include "tests/fuzz/played.hpp"

#include "core/beam/beam_player.hpp"
#include "core/player.hpp"
#include "tests/demand.hpp"
#include "tests/fuzz/memory.hpp"
#include "tests/fuzz/stored.hpp"
#include "tests/fuzz/told_inputs.hpp"
#include "tests/known.hpp"

#include <algorithm>
#include <array>

namespace kfast::test {
namespace {

/// More of outlines, or for a whole player, takes too long.
constexpr std::size_t max_drawn_bytes = 20000;
constexpr std::size_t max_block_bytes = std::size_t{64} << 20;

Memory pixels_for(Size panel, PixelFormat format)
{
    return Memory{row_bytes(format, panel.width) * static_cast<std::size_t>(panel.height)};
}

void draw(Player& player, PixelFormat format)
{
    const Memory pixels = pixels_for(player.panel(), format);
    with_format(format,
                [&]<PixelFormat known>() { player.draw_rows<known>(player.panel().height, pixels.bytes()); });
    demand_known(pixels.bytes());
}

void draw_changes(Player& player, PixelFormat format)
{
    const Memory pixels = pixels_for(player.panel(), format);
    const Size granularity{pixels_in_whole_bytes(format), 1};
    with_format(format, [&]<PixelFormat known>() {
        for (;;) {
            const auto changes = player.draw_changes<known>(pixels.bytes(), granularity, 11);
            if (changes.empty())
                return;
            for (const Change& change : changes)
                demand_known(change.pixels);
        }
    });
}

/// Calls show(time, round) from the beginning of the scene to its end.
template <class Show>
void each_moment(const SceneView& scene, int moments, std::uint32_t round, Show show)
{
    const std::int32_t step = std::max(Time::ticks_per_frame / 2, scene.length().ticks / moments);
    for (Time time; time <= scene.length(); time.ticks += step)
        show(time, round++);
}

void play_on_panel(const SceneView& scene, const Way& way, Played& played)
{
    const Memory block{Player::block_bytes(scene, way.panel)};
    if (block.bytes().size() > max_block_bytes)
        return;
    auto player = Player::create(scene, way.panel, way.fit, block.bytes());
    demand(static_cast<bool>(player));
    each_moment(scene, way.moments, way.first_round, [&](Time time, std::uint32_t round) {
        tell_inputs(*player, round);
        player->show(time);
        demand(player->picture().step_count <= scene.paint_steps());
        played.coarse += player->is_coarse() ? 1 : 0;
        if (player->picture().outlines.needed_bytes() > max_drawn_bytes)
            return;
        const PixelFormat format = pixel_formats[round % pixel_formats.size()];
        draw_changes(*player, format);
        draw(*player, format);
        ++played.pictures;
    });
}

/// The points are as many as were promised, and each is lit or dark.
void plot(const BeamPlayer& player, std::uint32_t budget)
{
    std::array<BeamPoint, 100> piece;
    PointStream stream = player.plot();
    std::size_t count = 0;
    while (const std::size_t some = stream.next(piece)) {
        const auto points = std::span{piece}.first(some);
        demand_known(points);
        demand(std::ranges::all_of(points, [](const BeamPoint& point) {
            return point.colour.opacity == (point.is_lit() ? 255 : 0);
        }));
        count += some;
    }
    demand(count >= 1 && count == player.report().points && count <= budget);
}

void play_by_beam(const SceneView& scene, const Way& way, Played& played)
{
    const Memory block{BeamPlayer::block_bytes(scene, way.beam)};
    if (block.bytes().size() > max_block_bytes)
        return;
    auto player = BeamPlayer::create(scene, way.beam, way.budget, block.bytes());
    demand(static_cast<bool>(player));
    each_moment(scene, way.beam_moments, way.first_round, [&](Time time, std::uint32_t round) {
        tell_inputs(*player, round);
        player->show(time);
        plot(*player, way.budget);
        ++played.beam_pictures;
    });
}

}

Way way_of(std::uint32_t seed)
{
    constexpr std::array panels{Size{24, 17}, Size{40, 9}, Size{7, 64}, Size{1, 3}, Size{130, 20}};
    constexpr std::array fits{Fit::contain, Fit::cover, Fit::none};
    constexpr std::array beams{scope_profile, crt_profile, galvo_profile};
    constexpr std::array<std::uint32_t, 4> budgets{4000, 400, 16, 100'000};
    return {.panel = panels[seed % panels.size()],
            .fit = fits[seed % fits.size()],
            .beam = beams[seed / 3 % beams.size()],
            .budget = budgets[seed % budgets.size()],
            .first_round = seed};
}

Played& Played::operator+=(const Played& more)
{
    scenes += more.scenes;
    pictures += more.pictures;
    coarse += more.coarse;
    beam_pictures += more.beam_pictures;
    return *this;
}

Played play(std::span<const std::byte> bytes, const Way& way)
{
    Played played;
    const auto scene = SceneView::parse(bytes);
    if (!scene)
        return played;
    played.scenes = 1;
    read_all(*scene);
    play_on_panel(*scene, way, played);
    play_by_beam(*scene, way, played);
    return played;
}

}
