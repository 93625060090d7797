#pragma once

#include "host/preview/terminal/borrowed_terminal.hpp"
#include "host/preview/viewer/viewer.hpp"

namespace kfast {

/// Plays in the terminal that standard output is, until a key quits or it has played as often as requested. A
/// signal that ends the program leaves the terminal as it was. Throws Failure when that cannot be written.
void play_in_terminal(Viewer& viewer, Keyboard& keyboard);

/// Writes one picture as text to standard output, whatever that is. Throws Failure.
void write_as_text(const Picture& picture);

}
