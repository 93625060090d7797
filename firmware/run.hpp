#pragma once

#include "core/player.hpp"
#include "firmware/board.hpp"
#include "firmware/frame_clock.hpp"
#include "firmware/playhead.hpp"

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

/// Shows frame after frame, each when `clock` says it is due, as long as the board is running.
template <Board B, class Animation>
void play(B& board, Animation& player, Playhead playhead, FrameClock clock)
{
    FrameReport report;
    while (board.running()) {
        report.time = playhead.time();
        player.show(report.time);
        draw_frame(board, player);
        board.frame_shown(report);

        const std::uint32_t frames = clock.advance(board.now());
        playhead.advance(frames);
        report.skipped += frames - 1;
        board.sleep_until(clock.due());
    }
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
    play(board, *player, {scene->length(), scene->loop()}, {scene->frame_rate(), board.now()});
}

}
