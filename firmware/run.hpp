#pragma once

#include "core/player.hpp"
#include "core/playhead.hpp"
#include "firmware/blank.hpp"
#include "firmware/board.hpp"
#include "firmware/fault_card.hpp"
#include "firmware/frame_clock.hpp"
#include "firmware/sending.hpp"
#include "firmware/test_card.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace kfast {

/// Draws the picture that `player` shows where it differs from what the panel shows, and sends it. Returns
/// when the panel has all of it. `Animation` is Player, or draws as it does.
///
/// The areas of one buffer are sent one after another; the last of them is on its way while the other buffer
/// is drawn, and has arrived before its own is drawn again.
template <Board B, class Animation>
void draw_frame(B& board, Animation& player)
{
    using P = PanelOf<B>;
    static_assert(P::granularity.height <= tallest_group);
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

/// Lets frames pass, and tells the board the events on the way if it asks for them.
template <Board B>
void advance(B& board, Playhead& playhead, std::uint32_t frames)
{
    playhead.advance(std::int64_t{frames} * Time::ticks_per_frame, [&board](const EventView& event) {
        if constexpr (EventBoard<B>)
            board.event_passed(event);
        else
            static_cast<void>(board), static_cast<void>(event);
    });
}

template <InputBoard B, class Animation>
void place_inputs(B& board, Animation& player)
{
    const std::span<const PlacedInput> inputs = board.inputs();
    for (const auto& [number, place] : inputs)
        player.set_input(number, place);
}

template <Board B>
void sleep_until_frame(B& board, Microseconds moment)
{
    if constexpr (ChangingBoard<B>)
        board.linger_until(moment);
    else
        board.sleep_until(moment);
}

/// Keeps the panel asleep as long as the board wants to rest. What it shows when it wakes is not to be seen.
template <RestingBoard B>
void rest(B& board, Playhead& playhead, FrameClock& clock)
{
    const auto pause = [&board](Microseconds time) { board.sleep_until(board.now() + time); };
    board.panel().sleep(pause);
    while (board.running() && board.wants_rest()) {
        sleep_until_frame(board, clock.due());
        clock.advance(board.now());
        board.steer(playhead);
    }
    board.panel().wake(pause);
}

/// Shows frame after frame, each when `clock` says it is due, as long as the board is running. The events of
/// a frame, and of those left out before it, are told before it is drawn.
template <Board B, class Animation>
void play(B& board, Animation& player, Playhead playhead, FrameClock clock)
{
    FrameReport report;
    std::uint32_t frames = 0;
    bool is_dark = true;
    while (board.running()) {
        advance(board, playhead, frames);
        if constexpr (SteeredBoard<B>)
            board.steer(playhead);
        if constexpr (RestingBoard<B>)
            if (board.wants_rest()) {
                rest(board, playhead, clock);
                player.redraw();
                is_dark = true;
            }
        if constexpr (InputBoard<B>)
            place_inputs(board, player);
        report.time = playhead.moment();
        player.show_moment(report.time);
        if constexpr (RedrawingBoard<B>)
            if (board.wants_redraw())
                player.redraw();
        draw_frame(board, player);
        if (std::exchange(is_dark, false))
            light_panel(board);
        report.is_late = reached(board.now(), clock.following());
        board.frame_shown(report);

        frames = clock.advance(board.now());
        report.skipped += frames - 1;
        sleep_until_frame(board, clock.due());
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

/// Happens once at most, and is compiled for size.
template <Board B>
[[gnu::cold]] void show_why_nothing_plays(B& board, Error error)
{
    if constexpr (NamedBoard<B>)
        if (is_blank(board.scene_bytes()))
            return show_card(board, TestCard{board.names(), board.panel().size()});
    show_card(board, FaultCard{error, board.panel().size()});
}

/// Whether anything can be drawn.
template <Board B>
bool bands_hold_rows(B& board)
{
    return rows_per_band(board.panel(), board.bands()[0].size()) != 0;
}

/// Says on the panel, if the bands hold a row of it, and to the board why nothing is played.
template <Board B>
[[gnu::cold]] void refuse(B& board, Error error)
{
    if (bands_hold_rows(board))
        show_why_nothing_plays(board, error);
    board.fault(error);
}

/// Plays the board's scene, on a panel that has begun, until the board stops running, or reports why it
/// cannot be played: an error of SceneView::parse, or block_too_small, also when the bands do not hold a row.
template <Board B>
void run_scene(B& board)
{
    const auto scene = SceneView::parse(board.scene_bytes());
    if (!scene)
        return refuse(board, scene.error());
    if (!bands_hold_rows(board))
        return refuse(board, Error::block_too_small);
    auto player = Player::create(*scene, board.panel().size(), Fit::contain, board.block());
    if (!player)
        return refuse(board, player.error());

    board.scene_started(*scene);
    if constexpr (ToldBoard<B>)
        board.plays(&*player);
    play(board, *player, playhead_for(board, *scene), {scene->frame_rate(), board.now()});
    if constexpr (ToldBoard<B>)
        board.plays(nullptr);
}

/// Begins the panel, and runs the board's scene.
template <Board B>
void run(B& board)
{
    if (bands_hold_rows(board))
        begin_panel(board);
    run_scene(board);
}

/// Begins the panel, and runs whatever the board has to play, one after another, as long as it wants to run.
template <ChangingBoard B>
void run_stage(B& board)
{
    constexpr Microseconds nap{100'000};
    if (bands_hold_rows(board))
        begin_panel(board);
    while (board.wants_to_run()) {
        if (board.begin())
            run_scene(board);
        while (board.running())
            board.linger_until(board.now() + nap);
    }
}

}
