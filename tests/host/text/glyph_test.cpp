#include "host/text/characters.hpp"

#include <doctest/doctest.h>

using namespace kfast;

TEST_CASE("printable text is shown as it is") { CHECK(visible("lamp ä€😀") == "lamp ä€😀"); }

TEST_CASE("nothing that steers a terminal gets through")
{
    CHECK(visible("\x1B[31m") == "<U+001B>[31m");
    CHECK(visible("a\nb\rc") == "a<U+000A>b<U+000D>c");
    CHECK(visible("\u009B\u202E\u2066\uFEFF\u200B") == "<U+009B><U+202E><U+2066><U+FEFF><U+200B>");
    CHECK(visible("\x7F\xFF") == "<U+007F><0xFF>");
    CHECK(visible(std::string_view{"\0", 1}) == "<U+0000>");
}

TEST_CASE("JSON keeps its meaning and has nothing that steers a terminal")
{
    CHECK(printable_json("{\n  \"a\": \"ä😀\\u001b\u009B\u202E\x7F\"\n}") ==
          "{\n  \"a\": \"ä😀\\u001b\\u009b\\u202e\\u007f\"\n}");
}

TEST_CASE("a glyph knows its columns")
{
    CHECK(glyph({.value = 'a'}).columns == 1);
    CHECK(glyph({.value = '\t'}).columns == 4);
    CHECK(glyph({.value = 0x0301}).columns == 0);
    CHECK(glyph({.value = 0x6F22}).columns == 2);
    CHECK(glyph({.value = 0x1F600}).columns == 2);
    CHECK(glyph({.value = 0x1B}).columns == 8);
    CHECK(glyph({.value = 0xFF, .length = 1, .valid = false}).columns == 6);
}

TEST_CASE("a long text is cut for a message")
{
    CHECK(in_quotes("blu") == "\"blu\"");
    CHECK(in_quotes(std::string(40, 'x')) == '"' + std::string(40, 'x') + '"');
    CHECK(in_quotes(std::string(41, 'x')) == '"' + std::string(40, 'x') + "…\"");
}
