#include "tests/host/kdl/reading.hpp"

#include <doctest/doctest.h>

#include <string>

using kfast::test::errors;
using kfast::test::reading;

namespace {

std::string repeated(std::string_view piece, std::size_t count)
{
    std::string text;
    while (count-- > 0)
        text += piece;
    return text;
}

}

TEST_CASE("nodes may be nested 256 deep")
{
    CHECK(errors(repeated("a{", 255) + "a" + repeated("}", 255)) == "");
    CHECK(errors(repeated("a{", 256) + repeated("}", 256)) == "");
}

TEST_CASE("deeper nodes are refused where they begin, and once")
{
    CHECK(errors(repeated("a{", 256) + "a" + repeated("}", 256)) ==
          "1:513: nodes are nested deeper than 256\n");
    CHECK(errors(repeated("a{\n", 5000)) == "257:1: nodes are nested deeper than 256\n");
    CHECK(errors(repeated("/-a{\n", 5000)) == "257:3: nodes are nested deeper than 256\n");
}

TEST_CASE("comments may be nested to any depth")
{
    CHECK(reading(repeated("/*", 100'000) + repeated("*/", 100'000) + "a") == "a\n");
}

// A parser that looks at the rest of the text again and again needs minutes for these: no clock
// is asked, the gate's own limit ends it.
TEST_CASE("100 000 repetitions of anything are read in a moment")
{
    for (const char* piece :
         {"{", "}",  "(", ")",  "/*", "/-",  "/",    "\\", "\"", "\"\"\"\n", "#",  "#\"", "=",   ";",
          "1", "0x", "a", "a ", "a=", "a\"", "\"\\", "\n", "-",  "[",        "a{", "a/-", "r\"", "\x01 "}) {
        CAPTURE(piece);
        CHECK(reading(repeated(piece, 100'000)) != "");
    }
}

TEST_CASE("many properties of different names are read in a moment")
{
    std::string text = "n";
    for (int i = 0; i < 100'000; ++i)
        text += " p" + std::to_string(i) + "=1";
    CHECK(errors(text) == "");
}
