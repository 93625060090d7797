#pragma once

#include "core/player.hpp"
#include "core/playhead.hpp"
#include "firmware/board.hpp"
#include "firmware/frame_clock.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace kfast {

/// The rows that a buffer of `bytes` holds and that the panel takes at once.
template <Panel P>
int rows_per_band(const P& panel, std::size_t bytes)
{
    const int rows = static_cast<int>(bytes / row_bytes(P::format, panel.size().width));
    return rows - rows % P::granularity.height;
}

/// Draws the picture that `player` shows and sends it: while one band is on its way the next one is drawn.
/// Returns when the panel has all of it. `Animation` is Player, or draws as it does.
template <Board B, class Animation>
void draw_frame(B& board, Animation& player)
{
    auto& panel = board.panel();
    constexpr PixelFormat format = std::remove_reference_t<decltype(panel)>::format;
    const Size size = panel.size();
    std::array bands = board.bands();
    const int band_rows = rows_per_band(panel, bands[0].size());

    for (int y = 0; y < size.height; y += band_rows) {
        const int rows = std::min(band_rows, size.height - y);
        const auto pixels = bands[0].first(static_cast<std::size_t>(rows) * row_bytes(format, size.width));
        player.template draw_rows<format>(rows, pixels);
        if constexpr (WatchingBoard<B>)
            board.watch(pixels);
        while (panel.busy()) {
        }
        panel.start({.x = 0, .y = y, .width = size.width, .height = rows}, pixels);
        std::swap(bands[0], bands[1]);
    }
    while (panel.busy()) {
    }
}

/// Lets frames pass, and tells the board the events on the way if it asks for them.
template <Board B>
void advance(B& board, Playhead& playhead, std::uint32_t frames)
{
    playhead.advance(std::int64_t{frames} * Time::ticks_per_frame,
                     [&board]([[maybe_unused]] const EventView& event) {
                         if constexpr (EventBoard<B>)
                             board.event_passed(event);
                     });
}

/// Shows frame after frame, each when `clock` says it is due, as long as the board is running. The events of
/// a frame, and of those left out before it, are told before it is drawn.
template <Board B, class Animation>
void play(B& board, Animation& player, Playhead playhead, FrameClock clock)
{
    FrameReport report;
    std::uint32_t frames = 0;
    while (board.running()) {
        advance(board, playhead, frames);
        report.time = playhead.moment();
        player.show_moment(report.time);
        draw_frame(board, player);
        board.frame_shown(report);

        frames = clock.advance(board.now());
        report.skipped += frames - 1;
        board.sleep_until(clock.due());
    }
}

/// The whole scene from its beginning, unless the board chooses.
template <Board B>
Playhead playhead_for(B& board, const SceneView& scene)
{
    if constexpr (ChoosingBoard<B>)
        return board.playhead(scene);
    else
        return Playhead{scene};
}

/// Plays the board's scene until the board stops running, or reports why it cannot be played: an error of
/// SceneView::parse, or block_too_small, also when the bands do not hold a row.
template <Board B>
void run(B& board)
{
    const auto scene = SceneView::parse(board.scene_bytes());
    if (!scene)
        return board.fault(scene.error());
    if (rows_per_band(board.panel(), board.bands()[0].size()) == 0)
        return board.fault(Error::block_too_small);
    auto player = Player::create(*scene, board.panel().size(), Fit::contain, board.block());
    if (!player)
        return board.fault(player.error());

    board.panel().begin([&board](Microseconds time) { board.sleep_until(board.now() + time); });
    board.scene_started(*scene);
    play(board, *player, playhead_for(board, *scene), {scene->frame_rate(), board.now()});
}

}
