#include "host/preview/terminal/terminal_text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace kfast::test {
namespace {

constexpr Colour black{};

Picture square(int side) { return {{side, side}, std::vector(static_cast<std::size_t>(side * side), black)}; }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}

TEST_CASE("status and notice stand below the picture, and old text goes away")
{
    const Picture picture = square(2);
    const TerminalText drawn =
        terminal_text({picture, "frame 0", "read again", {}}, {80, 24}, TerminalColours::none);
    CHECK(drawn.text == "  \x1b[K\nframe 0\x1b[K\nread again\x1b[K\n\x1b[J");
    CHECK(drawn.lines == 3);
}

TEST_CASE("how to get help stands at the right, where there is room")
{
    const Picture picture = square(2);
    const auto drawn = [&](int width) {
        TerminalContent content{picture, "frame 0", "", {}};
        content.hint = "h: help";
        return terminal_text(content, {width, 24}, TerminalColours::none).text;
    };
    CHECK(has(drawn(24), "\nframe 0         h: help\x1b[K\n"));
    CHECK(has(drawn(17), "\nframe 0  h: help\x1b[K\n"));
    CHECK(has(drawn(16), "\nframe 0\x1b[K\n"));
}

TEST_CASE("errors take room from the picture, but no more than half of it")
{
    const Picture picture = square(100);
    const std::vector<std::string> errors(30, "lamp.kfast:7:9: error: what?");
    const TerminalText drawn =
        terminal_text({picture, "frame 0", "", errors}, {40, 24}, TerminalColours::none);
    CHECK(drawn.lines <= 23);
    CHECK(has(drawn.text, "lamp.kfast:7:9"));
    CHECK(has(drawn.text, "... and 19 lines more"));
    CHECK(std::ranges::count(drawn.text, '\n') == drawn.lines);
}

TEST_CASE("lines are cut before they wrap, and say nothing to the terminal")
{
    const Picture picture = square(2);
    const std::vector<std::string> errors{"a\x1b[31mbcd\u00e9fghijklmnopqrstuvwxyz"};
    const TerminalText drawn =
        terminal_text({picture, "frame 0", "", errors}, {16, 24}, TerminalColours::none);
    CHECK(has(drawn.text, "\na<U+001B>[31mbc\x1b[K\n"));
}

TEST_CASE("the help lies over the picture, in columns where it is short of lines")
{
    const Picture picture = square(16);
    OpenHelp help{std::vector<std::string>(12, "n  next")};
    const TerminalText tall =
        terminal_text({picture, "frame 0", "", {}, &help}, {60, 24}, TerminalColours::none);
    CHECK(has(tall.text, "\x1b[12A\x1b[97;40mn  next\x1b[0m\n"));
    CHECK(tall.lines == 14);
    const TerminalText low =
        terminal_text({picture, "frame 0", "", {}, &help}, {60, 11}, TerminalColours::none);
    CHECK(has(low.text, "\x1b[8A\x1b[97;40mn  next   n  next\x1b[0m\n"));
    CHECK(low.lines == 10);
    OpenHelp few{{2, "n  next"}};
    CHECK(has(terminal_text({picture, "frame 0", "", {}, &few}, {60, 24}, TerminalColours::none).text,
              "\x1b[0m\n\x1b[6Bframe 0"));
}

TEST_CASE("any terminal is large enough")
{
    const Picture picture = square(16);
    const std::vector<std::string> lines(40, "n  next");
    OpenHelp help{lines};
    for (int width = 1; width < 6; ++width)
        for (int height = 1; height < 6; ++height)
            CHECK(
                terminal_text({picture, "frame 0", "", lines, &help}, {width, height}, TerminalColours::none)
                    .lines > 0);
}

}
