#include "host/preview/painter/text_columns.hpp"

#include <doctest/doctest.h>
#include <string>
#include <vector>

namespace kfast::test {

TEST_CASE("columns are code points, and invalid bytes one each")
{
    CHECK(columns_of("") == 0);
    CHECK(columns_of("Größe") == 5);
    CHECK(columns_of("a\xFFz") == 3);
}

TEST_CASE("text that is too long ends in an ellipsis")
{
    CHECK(cut("lamp", 4) == "lamp");
    CHECK(cut("lamps", 4) == "lam…");
    CHECK(cut("ööö", 2) == "ö…");
    CHECK(cut("lamp", 1) == "…");
    CHECK(cut("lamp", 0).empty());
    CHECK(cut("lamp", -3).empty());
}

TEST_CASE("lines are broken at spaces, long words where the line is full")
{
    using Lines = std::vector<std::string>;
    CHECK(wrapped("one two three", 7) == Lines{"one two", "three"});
    CHECK(wrapped("one  two", 4) == Lines{"one", "two"});
    CHECK(wrapped("abcdefg hi", 4) == Lines{"abcd", "efg", "hi"});
    CHECK(wrapped("", 4) == Lines{""});
    CHECK(wrapped("ää ää", 2) == Lines{"ää", "ää"});
}

TEST_CASE("wrapped lines are indented like the first")
{
    using Lines = std::vector<std::string>;
    CHECK(wrapped("  one two", 5) == Lines{"  one", "  two"});
    CHECK(wrapped("one two six", 5, 2) == Lines{"one", "  two", "  six"});
    CHECK(wrapped("  one two", 7, 2) == Lines{"  one", "    two"});
    CHECK(wrapped("a b c", 2, 2) == Lines{"a", "b", "c"});
    CHECK(wrapped("     a b", 3) == Lines{"a b"}); // no room for it
    CHECK(wrapped("   ", 2) == Lines{""});
}

}
