#include "tests/host/kdl/reading.hpp"

#include <doctest/doctest.h>

#include <string>

using kfast::test::errors;
using kfast::test::reading;

TEST_CASE("every kind of space separates values")
{
    for (const char* space :
         {"\t", " ", "\u00A0", "\u1680", "\u2000", "\u2001", "\u2002", "\u2003", "\u2004", "\u2005", "\u2006",
          "\u2007", "\u2008", "\u2009", "\u200A", "\u202F", "\u205F", "\u3000"})
        CHECK(reading(std::string("n") + space + "1" + space + space + "2") == "n 1 2\n");
}

TEST_CASE("every kind of new line ends a node")
{
    for (const char* newline : {"\r\n", "\r", "\n", "\v", "\f", "\u0085", "\u2028", "\u2029"})
        CHECK(reading(std::string("a 1") + newline + "b // c" + newline + newline + "d") == "a 1\nb\nd\n");
}

TEST_CASE("other invisible characters belong to a name") { CHECK(reading("a\u200Bb") == "a\u200Bb\n"); }

TEST_CASE("block comments are white space, nest, and may span lines")
{
    CHECK(reading("a/**/1") == "a 1\n");
    CHECK(reading("/* one /* two\n */ one */ a /* b\n c */ 1 /***/ 2 /*/*/**/*/*/") == "a 1 2\n");
    CHECK(reading("a /* \" // */ 1") == "a 1\n");
}

TEST_CASE("a line comment ends with its line or with the text")
{
    CHECK(reading("a //\nb // /*\n// \"\nc // end") == "a\nb\nc\n");
}

TEST_CASE("a \\ joins lines")
{
    CHECK(reading("a \\\n 1 \\ // why\r\n 2\\\n3 \\ /* x */ \n 4\nb") == "a 1 2 3 4\nb\n");
    CHECK(reading("a \\") == "a\n");
    CHECK(reading("a \\\n\n b") == "a\nb\n");
    CHECK(reading("\\\na") == "a\n");
    CHECK(reading("a{\\\n}") == "a\n");
}

TEST_CASE("a \\ within a line joins nothing")
{
    CHECK(errors("a \\ 1") == "1:3: more follows on the line after this \\\n");
    CHECK(errors("a\\b") == "1:2: more follows on the line after this \\\n");
}

TEST_CASE("a comment must be closed")
{
    CHECK(errors("a\n /* b /* c */ \n") == "2:2: this comment is not closed\n");
    CHECK(errors("a /*/") == "1:3: this comment is not closed\n");
    CHECK(kfast::test::hint("/*") == "add a closing */");
}

TEST_CASE("a byte order mark may begin a text")
{
    CHECK(reading("\uFEFFa") == "a\n");
    CHECK(reading("\uFEFF") == "\n");
}
