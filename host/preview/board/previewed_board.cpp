#include "host/preview/board/previewed_board.hpp"

#include "host/fit/board_choice.hpp"
#include "host/program/failure.hpp"

namespace kfast {
namespace {

fit::Target with_beam(fit::Target board, const BeamProfile& beam)
{
    if (!board.beam)
        throw Failure("--beam: the board " + board.name +
                      " has a panel, not a beam: leave out --beam, or choose a board with one, like pico-xy");
    board.beam = beam;
    return board;
}

fit::Display controller_for(PixelFormat format, const fit::Display& own)
{
    if (bits_per_pixel(own.format) == bits_per_pixel(format))
        return own;
    const fit::Display* const other = fit::display_like(format);
    return other == nullptr ? own : *other;
}

fit::Display with_pixels(const ShownDisplay& shown, const fit::Display& own)
{
    if (const fit::Display* const named = fit::display_named(shown.controller))
        return *named;
    return shown.format ? fit::taking(*shown.format, controller_for(*shown.format, own)) : own;
}

}

fit::Target previewed_board(const ShownDisplay& shown, const std::optional<fit::Target>& named)
{
    if (shown.beam)
        return with_beam(named ? *named : fit::chosen_board("pico-xy"), *shown.beam);
    fit::Target board = named ? *named : fit::chosen_board("pico");
    if (board.beam)
        throw Failure("the board " + board.name +
                      " has a beam, not a panel: leave out --panel, --scaling and --format");
    board.display = with_pixels(shown, board.display);
    board.display.size = shown.size;
    return board;
}

}
