#include "host/text/source.hpp"

#include <doctest/doctest.h>

using namespace kfast;

namespace {

/// The excerpt as it looks on a terminal, one line below the other.
std::string shown(std::string_view text, SourceSpan place)
{
    const Excerpt it = excerpt(text, place);
    return it.line + '\n' + it.marks;
}

}

TEST_CASE("the marks stand under the place")
{
    CHECK(shown("object lamp red", {.offset = 7, .length = 4}) == "object lamp red\n"
                                                                  "       ^~~~");
}

TEST_CASE("a place of no length gets one mark")
{
    CHECK(shown("ab", {.offset = 1, .length = 0}) == "ab\n ^");
    CHECK(shown("ab", {.offset = 2, .length = 0}) == "ab\n  ^");
    CHECK(shown("", {.offset = 0, .length = 0}) == "\n^");
}

TEST_CASE("the marks end with the line, and a place with the text")
{
    CHECK(shown("abc\ndef", {.offset = 1, .length = 5}) == "abc\n ^~");
    CHECK(shown("abc\ndef", {.offset = 99, .length = 5}) == "def\n   ^");
    CHECK(shown("abc\ndef", {.offset = 3, .length = 1}) == "abc\n   ^");
    CHECK(shown("abc\r\ndef", {.offset = 4, .length = 1}) == "abc\n   ^");
}

TEST_CASE("tabs, wide and combining characters do not shift the marks")
{
    CHECK(shown("\tx y", {.offset = 3, .length = 1}) == "    x y\n      ^");
    CHECK(shown("漢 x", {.offset = 4, .length = 1}) == "漢 x\n   ^");
    CHECK(shown("e\u0301 x", {.offset = 4, .length = 1}) == "e\u0301 x\n  ^");
    CHECK(shown("\x01 x", {.offset = 0, .length = 1}) == "<U+0001> x\n^~~~~~~~");
}

TEST_CASE("a line of 120 columns is shown whole")
{
    const std::string line(120, 'x');
    CHECK(excerpt(line, {.offset = 119, .length = 1}).line == line);
}

TEST_CASE("a longer line is cut around the place")
{
    const std::string line = std::string(500, 'a') + "HERE" + std::string(500, 'b');
    const Excerpt middle = excerpt(line, {.offset = 500, .length = 4});
    CHECK(middle.line == "…" + std::string(60, 'a') + "HERE" + std::string(56, 'b') + "…");
    CHECK(middle.marks == std::string(61, ' ') + "^~~~");

    const Excerpt begin = excerpt(line, {.offset = 0, .length = 1});
    CHECK(begin.line == std::string(120, 'a') + "…");
    CHECK(begin.marks == "^");

    const Excerpt end = excerpt(line, {.offset = line.size(), .length = 0});
    CHECK(end.line == "…" + std::string(60, 'b'));
    CHECK(end.marks == std::string(61, ' ') + "^");
}

TEST_CASE("a cut falls between code points")
{
    std::string line;
    for (int i = 0; i < 300; ++i)
        line += "€";
    const Excerpt it = excerpt(line, {.offset = 450, .length = 3});
    CHECK(it.line.find("<0x") == std::string::npos);
    CHECK(it.marks == std::string(61, ' ') + "^");
}

TEST_CASE("a long run of combining marks is cut too")
{
    std::string line = "x";
    for (int i = 0; i < 5000; ++i)
        line += "\u0301";
    CHECK(excerpt(line, {.offset = 0, .length = 1}).line.size() < 500);
}
