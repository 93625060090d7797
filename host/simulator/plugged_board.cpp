#include "host/simulator/plugged_board.hpp"

#include "firmware/panel/panel_choice.hpp"

namespace kfast {

void run_plugged_board(const PluggedParts& parts)
{
    with_driver<SimulatedBus>(parts.settings.panel.controller, [&]<Panel P> {
        PluggedBoard<P> board{parts};
        using B = PluggedBoard<P>;
        static_assert(ChangingBoard<B> && ChoosingBoard<B> && EventBoard<B> && InputBoard<B> &&
                      ListeningBoard<B> && NamedBoard<B> && LiveInputBoard<B>);
        run_scenes(board);
    });
}

}
