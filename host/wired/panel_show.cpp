#include "host/wired/panel_show.hpp"

#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"
#include "host/wired/parallel_bus.hpp"
#include "host/wired/spidev_bus.hpp"
#include "host/wired/wired_board.hpp"

namespace kfast {
namespace {

template <Panel P>
void run_until_dark(WiredBoard<P>& board)
{
    try {
        board.wake_up();
        run_scene(board);
    } catch (const Interrupted&) { // in the middle of a picture
    } catch (...) {
        try {
            board.go_dark();
        } catch (const Failure&) { // of the bus that has failed already
        }
        throw;
    }
    board.go_dark();
}

template <DisplayBus Bus>
ShownFrames show_on(Bus bus, PanelLines& lines, const PanelShow& show)
{
    return with_driver<Bus>(show.panel.controller, [&]<Panel P>() {
        P panel = make_panel<P>(bus, show.panel);
        WiredBoard<P> board{panel, lines, show};
        static_assert(ChoosingBoard<WiredBoard<P>> && LiveInputBoard<WiredBoard<P>> &&
                      ListeningBoard<WiredBoard<P>>);
        run_until_dark(board);
        return board.frames();
    });
}

}

ShownFrames show_on_spi(const PanelShow& show, SpiDevice& spi, PanelLines& lines)
{
    return show_on(SpidevBus{spi, lines}, lines, show);
}

ShownFrames show_on_parallel(const PanelShow& show, PanelLines& lines)
{
    return show_on(ParallelBus{lines}, lines, show);
}

}
