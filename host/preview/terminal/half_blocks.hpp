#pragma once

#include "host/picture/picture.hpp"

#include <cstdint>
#include <string>

namespace kfast {

enum class TerminalColours : std::uint8_t {
    none,        ///< characters by brightness
    palette_16,  ///< those of every colour terminal
    palette_256, ///< xterm's
    true_colour,
};

/// The colours of a terminal, by the variables COLORTERM, TERM and NO_COLOR of the environment, null where
/// there is none: true colour where one of the first two says so; 16 colours on the console of Linux and
/// others that are known for them; none on a dumb terminal, on one of the VT series, and where NO_COLOR is
/// not empty (no-color.org); else 256.
TerminalColours terminal_colours(const char* colorterm, const char* term, const char* no_color);

/// By the environment of this process.
TerminalColours terminal_colours();

/// The picture as text: each character is two pixels, one above the other, drawn by U+2580 in two colours,
/// or without colours the one of " .:-=+*#%@" that is as bright as both together.
/// Pictures larger than `cells` characters are shrunk in proportion, others keep their size. Every line ends
/// with the colours reset and LF.
std::string half_blocks(const Picture& picture, Size cells, TerminalColours colours);

}
