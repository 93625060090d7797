#pragma once

#include "core/math/point.hpp"
#include "core/pixel/pixel_format.hpp"
#include "firmware/panel/panel.hpp"
#include "firmware/run/board.hpp"

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

namespace kfast {

template <PanelBoard B>
using PanelOf = std::remove_reference_t<decltype(std::declval<B&>().panel())>;

/// The number of rows that a buffer of `bytes` holds and that the panel takes at once.
template <Panel P>
int rows_per_band(const P& panel, std::size_t bytes)
{
    const int rows = static_cast<int>(bytes / row_bytes(P::format, panel.size().width));
    return rows - rows % P::granularity.height;
}

template <Panel P>
void wait_for(P& panel)
{
    while (panel.busy()) {
    }
}

/// Starts to send an area as soon as the one before it has arrived.
template <PanelBoard B>
void send(B& board, Rect area, std::span<const std::byte> pixels)
{
    if constexpr (WatchingBoard<B>)
        board.watch(area, pixels);
    wait_for(board.panel());
    board.panel().start(area, pixels);
}

/// Its start-up tables are not to be on the stack while pictures are drawn.
template <PanelBoard B>
[[gnu::noinline]] void begin_panel(B& board)
{
    board.panel().begin([&board](Microseconds time) { board.sleep_until(board.now() + time); });
}

/// Lets the panel show what was sent, if it was dark until now.
template <PanelBoard B>
void light_panel(B& board)
{
    if constexpr (LightedPanel<PanelOf<B>>)
        board.panel().light();
    else
        static_cast<void>(board);
}

}
