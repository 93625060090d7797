#pragma once

#include "host/picture/picture.hpp"
#include "host/preview/controls/help_pages.hpp"
#include "host/preview/terminal/half_blocks.hpp"

#include <span>
#include <string>
#include <string_view>

namespace kfast {

/// What a preview shows in a terminal.
struct TerminalContent {
    const Picture& picture;
    std::string status;
    std::string notice;
    std::span<const std::string> errors; ///< below the picture, with as many lines as there is space for
    OpenHelp* help = nullptr;            ///< over the picture; null where it is closed
    const Picture* beside = nullptr;     ///< of another panel, right of the picture; or null
    std::string caption = {};            ///< of that one
    std::string_view hint = {};          ///< at the right of the status, as far as there is room for it
};

struct TerminalText {
    std::string text;
    int lines = 0; ///< that the cursor goes down
};

/// The text for a terminal of `cells` characters, from the beginning of a line: the picture and the lines
/// below it, at most cells.height - 1 in all where that is 4 or more. What was there before is cleared.
TerminalText terminal_text(const TerminalContent& content, Size cells, TerminalColours colours);

}
