#pragma once

#include "core/beam/beam_player.hpp"
#include "firmware/run/board.hpp"

#include <array>
#include <cstddef>
#include <span>

/// What the run loop (run.hpp) does with a beam.
namespace kfast {

template <BeamBoard B>
void begin_display(B&)
{
}

/// Fails as BeamPlayer::create() does.
template <BeamBoard B>
Result<BeamPlayer> player_for(B& board, const SceneView& scene)
{
    const auto& beam = board.beam();
    return BeamPlayer::create(scene, beam.profile(), beam.room(), board.block());
}

template <BeamBoard B>
void listen_to(B& board)
{
    if constexpr (ListeningBoard<B>)
        board.listen();
    else
        static_cast<void>(board);
}

/// Plots the picture that `player` shows, and lets the beam show it. The one before has begun when there is
/// room for it, so it is never more than a picture late.
template <BeamBoard B, class Animation>
void draw_frame(B& board, const Animation& player)
{
    constexpr std::size_t piece = 32;
    auto& beam = board.beam();
    while (!beam.takes_picture())
        listen_to(board);
    auto plot = player.plot();
    std::array<BeamPoint, piece> points;
    while (const std::size_t count = plot.next(points)) {
        listen_to(board);
        beam.plot(std::span{points}.first(count));
    }
    beam.show();
}

template <BeamBoard B>
void sleep_display(B& board)
{
    board.beam().park();
}

/// The beam shines when there is something to show.
template <BeamBoard B>
void wake_display(B&)
{
}

/// A beam says nothing.
template <BeamBoard B>
bool show_notice(B&)
{
    return false;
}

/// The board shows it with its light.
template <BeamBoard B>
void show_why_nothing_plays(B& board, Error)
{
    board.beam().park();
}

template <BeamBoard B>
void hold_display(B& board)
{
    board.beam().park();
}

}
