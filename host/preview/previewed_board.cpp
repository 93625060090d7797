#include "host/preview/previewed_board.hpp"

#include "host/fit/board_choice.hpp"

namespace kfast {

fit::Target previewed_board(const Stage& stage)
{
    if (stage.is_beam)
        return fit::chosen_board("pico-xy");
    fit::Target board = fit::chosen_board("pico");
    if (const fit::Display* const display = fit::display_named(stage.panel_name))
        board.display = *display;
    board.display.size = stage.panel;
    return board;
}

}
