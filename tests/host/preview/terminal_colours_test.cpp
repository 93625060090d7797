#include "host/preview/terminal/half_blocks.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("a terminal gets the colours that it says it has")
{
    CHECK(terminal_colours("truecolor", "xterm-256color", nullptr) == TerminalColours::true_colour);
    CHECK(terminal_colours("24bit", "linux", "") == TerminalColours::true_colour);
    CHECK(terminal_colours(nullptr, "xterm-direct", nullptr) == TerminalColours::true_colour);
    CHECK(terminal_colours("", "tmux-256color", nullptr) == TerminalColours::palette_256);
    CHECK(terminal_colours(nullptr, nullptr, nullptr) == TerminalColours::palette_256);
    CHECK(terminal_colours(nullptr, "linux", nullptr) == TerminalColours::palette_16);
    CHECK(terminal_colours(nullptr, "xterm-16color", nullptr) == TerminalColours::palette_16);
    CHECK(terminal_colours(nullptr, "vt220", nullptr) == TerminalColours::none);
    CHECK(terminal_colours("truecolor", "dumb", nullptr) == TerminalColours::none);
    CHECK(terminal_colours("truecolor", "xterm", "1") == TerminalColours::none);
}

}
