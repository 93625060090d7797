#include "host/text/source.hpp"

#include <doctest/doctest.h>

#include <array>
#include <random>

using namespace kfast;

namespace {

std::string where(std::string_view text, std::size_t offset)
{
    const LineColumn at = line_column(text, offset);
    return std::to_string(at.line) + ':' + std::to_string(at.column);
}

}

TEST_CASE("lines and columns count from 1")
{
    CHECK(where("", 0) == "1:1");
    CHECK(where("ab\ncd", 0) == "1:1");
    CHECK(where("ab\ncd", 2) == "1:3"); // the LF itself
    CHECK(where("ab\ncd", 3) == "2:1");
    CHECK(where("ab\ncd", 4) == "2:2");
}

TEST_CASE("a column is a code point, not a byte")
{
    CHECK(where("ä€😀x", 9) == "1:4");
    CHECK(where("ä€😀x", 4) == "1:2"); // inside the euro sign
    CHECK(where("\xFF\xFFx", 2) == "1:3");
}

TEST_CASE("CR LF, LF and CR each end one line")
{
    CHECK(where("a\r\nb", 1) == "1:2");
    CHECK(where("a\r\nb", 2) == "1:3");
    CHECK(where("a\r\nb", 3) == "2:1");
    CHECK(where("a\rb\nc", 4) == "3:1");
    CHECK(where("\n\n\n", 3) == "4:1");
}

TEST_CASE("an offset beyond the end means the end")
{
    CHECK(where("ab\ncd", 99) == "2:3");
    CHECK(where("ab\n", 99) == "2:1");
    CHECK(line_at("ab\ncd", 99) == "cd");
    CHECK(line_at("ab\n", 99) == "");
}

TEST_CASE("the line that holds an offset comes without its end")
{
    CHECK(line_at("ab\r\ncd\n", 0) == "ab");
    CHECK(line_at("ab\r\ncd\n", 2) == "ab");
    CHECK(line_at("ab\r\ncd\n", 3) == "ab");
    CHECK(line_at("ab\r\ncd\n", 4) == "cd");
    CHECK(line_at("ab\rcd", 3) == "cd");
    CHECK(line_at("", 0) == "");
}

TEST_CASE("many places are found as single ones are")
{
    std::mt19937 random{1};
    std::string text;
    for (int left = 3000; left > 0; --left)
        text += std::array<std::string_view, 9>{
            "a", "bc", "\n", "\r", "\r\n", "ä", "😀", "\xFF", "\xF0\x9F"}[random() % 9];
    const Places places{text};
    for (std::size_t offset = 0; offset <= text.size() + 2; ++offset) {
        const LineColumn at = places.line_column(offset);
        CHECK(std::to_string(at.line) + ':' + std::to_string(at.column) == where(text, offset));
    }
}

TEST_CASE("in UTF-16 a character beyond the first plane is two code units")
{
    const std::string_view text = "ä😀x\n😀";
    const Places places{text};
    CHECK(places.code_units(0) == 0);
    CHECK(places.code_units(2) == 1);
    CHECK(places.code_units(6) == 3);
    CHECK(places.code_units(8) == 0);
    CHECK(places.code_units(99) == 2);
}
