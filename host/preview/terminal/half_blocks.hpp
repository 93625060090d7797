#pragma once

#include "host/picture/picture.hpp"
#include "host/preview/terminal/terminal_colours.hpp"

#include <string>

namespace kfast {

/// The picture as text: each character is two pixels, one above the other, drawn by U+2580 in two colours,
/// or without colours the one of " .:-=+*#%@" that is as bright as both together.
/// Pictures larger than `cells` characters are shrunk in proportion, others keep their size. Every line ends
/// with the colours reset and LF.
std::string half_blocks(const Picture& picture, Size cells, TerminalColours colours);

}
