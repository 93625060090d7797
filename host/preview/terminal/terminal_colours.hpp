#pragma once

#include <cstdint>

namespace kfast {

enum class TerminalColours : std::uint8_t {
    none,        ///< characters by brightness
    palette_16,  ///< those that every colour terminal has
    palette_256, ///< xterm's
    true_colour,
};

/// What a terminal shows, by the variables COLORTERM, TERM and NO_COLOR of the environment, null where there
/// is none: true colour where one of the first two says so; 16 colours on the console of Linux and others
/// that are known for them; none on a dumb terminal, on one of the VT series, and where NO_COLOR is not empty
/// (no-color.org); else 256.
TerminalColours terminal_colours(const char* colorterm, const char* term, const char* no_color);

/// By the environment of this process.
TerminalColours terminal_colours();

}
