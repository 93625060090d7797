#include "host/preview/terminal/terminal_colours.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

namespace kfast {
namespace {

constexpr std::array with_16{"linux", "ansi", "cygwin", "cons25", "pcansi"};

std::string_view word(const char* text) { return text == nullptr ? "" : text; }

}

TerminalColours terminal_colours(const char* colorterm, const char* term, const char* no_color)
{
    const std::string_view says = word(colorterm);
    const std::string_view type = word(term);
    if (!word(no_color).empty() || type == "dumb")
        return TerminalColours::none;
    if (says == "truecolor" || says == "24bit" || type.ends_with("-direct"))
        return TerminalColours::true_colour;
    if (type.starts_with("vt"))
        return TerminalColours::none;
    if (std::ranges::any_of(with_16, [type](const char* name) { return type == name; }) ||
        type.ends_with("-16color"))
        return TerminalColours::palette_16;
    return TerminalColours::palette_256;
}

TerminalColours terminal_colours()
{
    return terminal_colours(std::getenv("COLORTERM"), std::getenv("TERM"), std::getenv("NO_COLOR"));
}

}
