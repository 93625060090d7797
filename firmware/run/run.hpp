#pragma once

#include "core/playhead.hpp"
#include "firmware/run/beam_show.hpp"
#include "firmware/run/board.hpp"
#include "firmware/run/frame_clock.hpp"
#include "firmware/run/panel_show.hpp"

#include <cstdint>
#include <span>
#include <utility>

namespace kfast {

/// Lets frames pass, and notifies the board of the events on the way if it wants them.
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

/// Keeps the display asleep as long as the board wants to rest.
template <RestingBoard B>
void rest(B& board, Playhead& playhead, FrameClock& clock)
{
    sleep_display(board);
    while (board.running() && board.wants_rest()) {
        sleep_until_frame(board, clock.due());
        clock.advance(board.now());
        board.steer(playhead);
    }
    wake_display(board);
}

/// Shows frame after frame, each when `clock` says it is due, as long as the board is running. The events of
/// a frame, and of those left out before it, are reported before it is drawn.
template <Board B, class Animation>
void play(B& board, Animation& player, Playhead playhead, FrameClock clock)
{
    FrameReport report;
    std::uint32_t frames = 0;
    [[maybe_unused]] bool is_dark = true;
    while (board.running()) {
        advance(board, playhead, frames);
        if constexpr (SteeredBoard<B>)
            board.steer(playhead);
        if constexpr (RestingBoard<B>)
            if (board.wants_rest()) {
                rest(board, playhead, clock);
                if constexpr (PanelBoard<B>)
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
        if constexpr (PanelBoard<B>)
            if (std::exchange(is_dark, false))
                light_panel(board);
        report.is_coarse = player.is_coarse();
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

/// Shows on the display, if it can, and reports to the board why nothing is played.
template <Board B>
[[gnu::cold]] void refuse(B& board, Error error)
{
    show_why_nothing_plays(board, error);
    board.fault(error);
}

/// Part of run_scene(), apart from parsing: the player takes much of the stack.
template <Board B>
[[gnu::noinline]] void play_scene(B& board, const SceneView& scene)
{
    auto player = player_for(board, scene);
    if (!player)
        return refuse(board, player.error());

    board.scene_started(scene);
    if constexpr (LiveInputBoard<B>)
        board.plays(&*player);
    play(board, *player, playhead_for(board, scene), {scene.frame_rate(), board.now()});
    if constexpr (LiveInputBoard<B>)
        board.plays(nullptr);
}

/// Plays the board's scene, on a display that has begun, until the board stops running, or reports why it
/// cannot be played: an error of SceneView::parse, or of player_for().
template <Board B>
void run_scene(B& board)
{
    const auto scene = SceneView::parse(board.scene_bytes(), features_of(board));
    if (scene)
        play_scene(board, *scene);
    else
        refuse(board, scene.error());
}

/// Begins the display, and runs the board's scene.
template <Board B>
void run(B& board)
{
    begin_display(board);
    run_scene(board);
    hold_display(board);
}

/// Begins the display, shows what the board has to say, if it has, and runs whatever it has to play, one
/// after another, as long as it wants to run.
template <ChangingBoard B>
void run_scenes(B& board)
{
    constexpr Microseconds nap{100'000};
    constexpr Microseconds notice_time{5'000'000};
    begin_display(board);
    if (show_notice(board))
        board.sleep_until(board.now() + notice_time);
    while (board.wants_to_run()) {
        if (board.begin())
            run_scene(board);
        else
            hold_display(board);
        while (board.running())
            board.linger_until(board.now() + nap);
    }
    hold_display(board);
}

}
