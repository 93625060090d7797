#pragma once

#include "core/player.hpp"
#include "firmware/run/blank.hpp"
#include "firmware/run/board.hpp"
#include "firmware/run/fault_card.hpp"
#include "firmware/run/notice_card.hpp"
#include "firmware/run/sending.hpp"
#include "firmware/run/test_card.hpp"

#include <array>
#include <cstddef>
#include <utility>

/// What the run loop (run.hpp) does with a panel.
namespace kfast {

/// Whether anything can be drawn.
template <PanelBoard B>
bool bands_hold_rows(B& board)
{
    return rows_per_band(board.panel(), board.bands()[0].size()) != 0;
}

template <PanelBoard B>
void begin_display(B& board)
{
    if (bands_hold_rows(board))
        begin_panel(board);
}

/// Fails as Player::create() does, or with block_too_small if the bands do not hold a row.
template <PanelBoard B>
Result<Player> player_for(B& board, const SceneView& scene)
{
    if (!bands_hold_rows(board))
        return Error::block_too_small;
    return Player::create(scene, board.panel().size(), Fit::contain, board.block());
}

/// Draws the picture that `player` shows where it differs from what the panel shows, and sends it. Returns
/// when the panel has all of it. `Animation` is Player, or draws as it does.
///
/// The areas of one buffer are sent one after another; the last of them is on its way while the other buffer
/// is drawn, and has arrived before its own is drawn again.
template <PanelBoard B, class Animation>
void draw_frame(B& board, Animation& player)
{
    using P = PanelOf<B>;
    static_assert(P::granularity.width <= raster::max_granularity.width &&
                  P::granularity.height <= raster::max_granularity.height);
    std::array bands = board.bands();
    for (bool is_first = true; true; is_first = false) {
        if constexpr (ListeningBoard<B>)
            board.listen();
        const auto changes =
            player.template draw_changes<P::format>(bands[0], P::granularity, P::window_bytes);
        if (changes.empty())
            break;
        if constexpr (SynchronizedBoard<B>)
            if (is_first)
                board.wait_for_blank();
        for (const auto& [area, pixels] : changes)
            send(board, area, pixels);
        std::swap(bands[0], bands[1]);
    }
    wait_for(board.panel());
}

/// The old picture is not to be visible when the panel wakes.
template <PoweredPanelBoard B>
void sleep_display(B& board)
{
    board.panel().sleep([&board](Microseconds time) { board.sleep_until(board.now() + time); });
}

template <PoweredPanelBoard B>
void wake_display(B& board)
{
    board.panel().wake([&board](Microseconds time) { board.sleep_until(board.now() + time); });
}

/// Shows what the board has to say, if it has. Returns whether it does.
template <PanelBoard B>
[[gnu::cold]] bool show_notice(B& board)
{
    if constexpr (NoticingBoard<B>) {
        const Notice notice = board.notice();
        if (notice.title.empty() || !bands_hold_rows(board))
            return false;
        show_card(board, NoticeCard{notice.title, notice.words, board.panel().size()});
        board.notice_shown();
        return true;
    } else {
        static_cast<void>(board);
        return false;
    }
}

/// Shows on the panel why nothing is played, if the bands hold a row of it. Happens once at most, and is
/// compiled for size.
template <PanelBoard B>
[[gnu::cold]] void show_why_nothing_plays(B& board, Error error)
{
    if (!bands_hold_rows(board))
        return;
    const bool has_scene = !is_blank(board.scene_bytes());
    if (!has_scene && show_notice(board))
        return;
    if constexpr (NamedBoard<B>)
        if (!has_scene)
            return show_card(board, TestCard{board.names(), board.panel().size()});
    show_card(board, FaultCard{error, board.panel().size()}.notice());
}

/// Nothing is drawn: the panel shows what it shows.
template <PanelBoard B>
void hold_display(B&)
{
}

}
