#include "host/commands/help/law_page.hpp"

#include "host/words/easing_names.hpp"
#include "host/words/law_words.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <sstream>
#include <string>

namespace kfast::test {
namespace {

std::size_t letters_in(const std::string& line)
{
    return static_cast<std::size_t>(std::ranges::count_if(
        line, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }));
}

std::size_t widest_line(const std::string& text)
{
    std::istringstream lines{text};
    std::size_t widest = 0;
    for (std::string line; std::getline(lines, line);)
        widest = std::max(widest, letters_in(line));
    return widest;
}

}

TEST_CASE("the page about laws has all of them, and all other names")
{
    const std::string page = law_page({});
    for (const LawWord& word : law_words)
        CHECK(page.find(word.form) != std::string::npos);
    for (const EasingName& easing : easing_names())
        CHECK(page.find("\n  " + std::string{easing.name} + ' ') != std::string::npos);
    CHECK(page.find("spring(100,10)") != std::string::npos);
    CHECK(page.find('\x1b') == std::string::npos);
}

TEST_CASE("curves stand beside each other as the terminal is wide")
{
    CHECK(law_page({}) == law_page({.width = 80}));
    for (const std::size_t width : {60U, 80U, 100U})
        CHECK(widest_line(law_page({.width = width})) <= width);
    CHECK(law_page({.width = 30}).find("constant\n") != std::string::npos);
    CHECK(law_page({.width = 80}).find("constant                  accelerate                decelerate\n") !=
          std::string::npos);
}

TEST_CASE("a curve goes from the line of the earlier key to that of the next one")
{
    const std::string page = law_page({.width = 30});
    CHECK(page.find("\nconstant\n"
                    "⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀\n"
                    "⠂⠀⠂⠀⠂⠀⠂⠀⠂⠀⠂⠀⠂⠀⠂⠀⠂⠀⠂⢀⣂⠤⠦⠒\n"
                    "⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⣀⣀⠤⠔⠒⠊⠉⠁⠀⠀⠀⠀\n"
                    "⠀⠀⠀⠀⢀⣀⡠⠤⠔⠒⠉⠉⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀\n"
                    "⠤⠒⠖⠉⠅⠀⠄⠀⠄⠀⠄⠀⠄⠀⠄⠀⠄⠀⠄⠀⠄⠀⠄⠀\n"
                    "⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀\n") != std::string::npos);
}

}
