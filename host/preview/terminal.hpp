#pragma once

#include "host/preview/keyboard.hpp"
#include "host/preview/terminal_colours.hpp"
#include "host/preview/viewer.hpp"

namespace kfast {

/// Plays in the terminal that standard output is, until a key quits or it has played as often as it was to. A
/// signal that ends the program leaves the terminal as it was. Throws Failure when that cannot be written.
void play_in_terminal(Viewer& viewer, Keyboard& keyboard);

/// Whether standard output is a terminal that pictures can be drawn on one above the other.
bool can_play_in_terminal();

/// Of the terminal that standard output is, in characters; 80 x 24 where it is none.
Size terminal_size();

/// What that terminal shows, by the environment.
TerminalColours colours_of_terminal();

/// Writes one picture as text to standard output, whatever that is. Throws Failure.
void write_as_text(const Frame& frame);

}
