#include "host/preview/controls/help_pages.hpp"

#include "host/preview/painter/text_columns.hpp"

#include <doctest/doctest.h>

#include <map>
#include <utility>

namespace kfast::test {
namespace {

/// All words of the pages but those of their numbers.
std::string schema_of(const std::vector<HelpPage>& pages)
{
    std::string words;
    for (const HelpPage& page : pages)
        for (const HelpLine& line : page.lines)
            if (pages.size() == 1 || line.row + 1 < page.cells.height)
                words += line.text + ' ';
    std::erase(words, ' ');
    return words;
}

std::string schema_of(const std::vector<std::string>& rows)
{
    std::string words;
    for (const std::string& row : rows)
        words += row;
    std::erase(words, ' ');
    return words;
}

const std::vector<std::string> rows = preview_help(PreviewFront::window);

}

TEST_CASE("the help is whole in the smallest window and in a usual terminal: nothing is cut, and no line "
          "leaves its place")
{
    for (const Size cells : {Size{41, 11}, Size{79, 21}, Size{124, 30}, Size{60, 100}}) {
        const auto pages = help_pages(rows, cells);
        CHECK(schema_of(pages) == schema_of(rows));
        for (const HelpPage& page : pages) {
            std::map<std::pair<int, int>, int> taken;
            CHECK(page.cells.width <= cells.width);
            CHECK(page.cells.height <= cells.height);
            for (const HelpLine& line : page.lines) {
                CHECK(line.row < page.cells.height);
                CHECK(line.column + columns_of(line.text) <= page.cells.width);
                CHECK(++taken[{line.column, line.row}] == 1);
            }
        }
    }
}

TEST_CASE("there are as few columns and pages as the rows fit in")
{
    const auto columns = [](Size cells) {
        std::map<int, int> found;
        const HelpPage page = help_pages(rows, cells).front();
        for (const HelpLine& line : page.lines)
            ++found[line.column];
        return found.size();
    };
    CHECK(columns({60, 100}) == 1);
    CHECK(columns({124, 30}) == 2);
    CHECK(help_pages(rows, {124, 30}).size() == 1);
    CHECK(help_pages(preview_help(PreviewFront::terminal), {79, 21}).size() == 1);
    CHECK(help_pages(rows, {41, 11}).size() > 1);
}

TEST_CASE("a long row goes on below its own words")
{
    const std::vector<std::string> one{"tab   selects the next object"};
    const auto pages = help_pages(one, {18, 9});
    REQUIRE(pages.size() == 1);
    REQUIRE(pages[0].lines.size() == 2);
    CHECK(pages[0].lines[0].text == "tab   selects the");
    CHECK(pages[0].lines[0].key_columns == 3);
    CHECK(pages[0].lines[1].text == "      next object");
    CHECK(pages[0].lines[1].key_columns == 0);
}

TEST_CASE("any room will do")
{
    for (int width = -1; width < 8; ++width)
        for (int height = -1; height < 8; ++height)
            CHECK_FALSE(help_pages(rows, {width, height}).empty());
}

TEST_CASE("h turns the pages and then closes the help, which begins anew with its first one")
{
    OpenHelp help{rows};
    const auto first = help.page({41, 11}).lines.front().text;
    const std::size_t pages = help_pages(rows, {41, 11}).size();
    for (std::size_t i = 1; i < pages; ++i) {
        CHECK(help.turns(PreviewKey::help, true));
        CHECK(help.page({41, 11}).lines.front().text != first);
    }
    CHECK(help.page({41, 11}).lines.back().text.find("h  closes this") == 0);
    CHECK_FALSE(help.turns(PreviewKey::help, true));
    CHECK(help.page({41, 11}).lines.front().text == first);
    CHECK(help.turns(PreviewKey::help, true));
    CHECK_FALSE(help.turns(PreviewKey::next_key, true));
    CHECK_FALSE(help.turns(PreviewKey::help, false));
    CHECK(help.page({41, 11}).lines.front().text == first);
}

}
