#include "host/commands/help/help_page.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace kfast::test {
namespace {

OptionWords option(const std::vector<std::string>& names, const std::string& help)
{
    OptionWords words;
    words.names = names;
    words.help = help;
    return words;
}

CommandWords lamp()
{
    OptionWords name = option({"LAMP"}, "Which one");
    name.is_positional = name.is_required = true;
    OptionWords shades = option({"SHADE"}, "What is on it");
    shades.is_positional = shades.takes_many = true;
    OptionWords brightness =
        option({"-b", "--brightness"}, "How bright it is in the end, after some seconds in which it glows");
    brightness.takes_value = brightness.takes_many = true;
    brightness.type = "SHARE";
    OptionWords colour = option({"--colour-of-the-whole-lamp"}, "In colour");
    brightness.group = colour.group = "The light";
    return {"lamp", "Light a lamp", "", "Example:\n  kfast lamp:\n", {name, shades, brightness, colour}, {}};
}

}

TEST_CASE("a page has the arguments, the options below their headings, and the examples")
{
    CHECK(help_page(lamp(), {}) ==
          "Light a lamp\n"
          "Usage: kfast lamp [OPTIONS] LAMP [SHADE ...]\n"
          "\n"
          "Arguments:\n"
          "  LAMP                        Which one\n"
          "  SHADE ...                   What is on it\n"
          "\n"
          "The light:\n"
          "  -b, --brightness SHARE      How bright it is in the end, after some seconds in which it glows\n"
          "  --colour-of-the-whole-lamp  In colour\n"
          "\n"
          "Example:\n"
          "  kfast lamp:\n");
}

TEST_CASE("a term that is too wide for its column has its text in the next line")
{
    CommandWords words = lamp();
    words.options.back().names = {"--colour-of-the-whole-lamps"};
    const std::string page = help_page(words, {});
    CHECK(page.find("  --colour-of-the-whole-lamps\n                          In colour\n") !=
          std::string::npos);
    CHECK(page.find("  LAMP                    Which one\n") != std::string::npos);
}

TEST_CASE("lines are broken where the terminal ends, and headings are in colour")
{
    const std::string page = help_page(lamp(), {.has_colour = true, .width = 60});
    CHECK(page.find("\x1b[1;36mThe light:\x1b[0m\n") != std::string::npos);
    CHECK(page.find("\x1b[1;36mExample:\x1b[0m\n  kfast lamp:\n") != std::string::npos);
    CHECK(page.find("SHARE      How bright it is in the end,\n"
                    "                              after some seconds in which it\n"
                    "                              glows\n") != std::string::npos);
    CHECK(help_page(lamp(), {.width = 59}).find("after some seconds in which\n") != std::string::npos);
}

}
