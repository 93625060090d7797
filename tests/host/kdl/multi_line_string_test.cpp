#include "tests/host/kdl/reading.hpp"

#include <doctest/doctest.h>

using kfast::test::errors;
using kfast::test::hint;
using kfast::test::reading;

TEST_CASE("the spaces of the closing line are taken from every line")
{
    CHECK(reading("n \"\"\"\n  a\n    b\n  \"\"\"") == "n \"a\\n  b\"\n");
    CHECK(reading("n \"\"\"\n  a\n \"\"\"") == "n \" a\"\n");
    CHECK(reading("n \"\"\"\na\n\"\"\"") == "n a\n");
    CHECK(reading("n \"\"\"\n\t a\n\t \"\"\"") == "n a\n");
    CHECK(reading("n \"\"\"\n\u3000a\n\u3000\"\"\"") == "n a\n");
}

TEST_CASE("lines of spaces alone are empty lines")
{
    CHECK(reading("n \"\"\"\n  a\n\n \n      \n  b\n  \"\"\"") == "n \"a\\n\\n\\n\\nb\"\n");
    CHECK(reading("n \"\"\"\n\n  \"\"\"") == "n \"\"\n");
    CHECK(reading("n \"\"\"\n\n\n\"\"\"") == "n \"\\n\"\n");
}

TEST_CASE("the first and the last new line may be the same")
{
    CHECK(reading("n \"\"\"\n\"\"\"") == "n \"\"\n");
    CHECK(reading("n \"\"\"\n   \"\"\"") == "n \"\"\n");
}

TEST_CASE("every new line becomes LF, but escaped ones stay as they are")
{
    CHECK(reading("n \"\"\"\r\na\r\nb\rc\u2028\\r\\nd\v\"\"\"") == "n \"a\\nb\\nc\\n\\r\\nd\"\n");
}

TEST_CASE("quotes may stand in the text")
{
    CHECK(reading("n \"\"\"\na \" \"\" \\\"\"\" b\n\"\"\"") == R"(n "a \" \"\" \"\"\" b")"
                                                               "\n");
}

TEST_CASE("escaped white space is taken out before the lines are compared")
{
    CHECK(reading("n \"\"\"\n  a \\\nb\n  c\n  \"\"\"") == "n \"a b\\nc\"\n");
    CHECK(reading("n \"\"\"\n  a\n  \\  \"\"\"") == "n a\n");
    CHECK(reading("n \"\"\"\n  a\n\\\n  \"\"\"") == "n \"  a\"\n");
    CHECK(errors("n \"\"\"\n  a\\\n  \"\"\"") == "3:3: text stands before the closing \"\"\"\n");
}

TEST_CASE("escapes are no indentation and make no empty lines")
{
    CHECK(reading("n \"\"\"\n  \\t\n  \"\"\"") == "n \"\\t\"\n");
    CHECK(errors("n \"\"\"\n\\s a\n  \"\"\"") ==
          "2:1: this line does not begin with the spaces of the closing line\n");
    CHECK(errors("n \"\"\"\n  a\n\\s\"\"\"") == "3:3: text stands before the closing \"\"\"\n");
}

TEST_CASE("raw strings may have several lines, without escapes")
{
    CHECK(reading("n #\"\"\"\n  a\\\n  \"\"\" b\n  \"\"\"#") == R"(n "a\\\n\"\"\" b")"
                                                                "\n");
    CHECK(reading("n ##\"\"\"\n\"\"\"#\n\"\"\"##") == "n \"\\\"\\\"\\\"#\"\n");
}

TEST_CASE("the opening quotes end their line")
{
    CHECK(errors("n \"\"\"a\"\"\"") == "1:3: text follows the opening \"\"\" on its line\n");
    CHECK(errors("n \"\"\" \na\n\"\"\"") == "1:3: text follows the opening \"\"\" on its line\n");
    CHECK(errors("n \"\"\"\\\na\n\"\"\"") == "1:3: text follows the opening \"\"\" on its line\n");
    CHECK(errors("n #\"\"\"#") == "1:3: text follows the opening \"\"\" on its line\n");
    CHECK(hint("n \"\"\"a\"\"\"") == "begin a new line after it, or use \" for a text of one line");
}

TEST_CASE("the closing quotes stand on a line of their own")
{
    CHECK(errors("n \"\"\"\n  a\"\"\"") == "2:4: text stands before the closing \"\"\"\n");
    CHECK(errors("n #\"\"\"\n  a\n\"\"\"\"#") == "3:2: text stands before the closing \"\"\"\n");
}

TEST_CASE("a line with other spaces than the closing line is pointed at")
{
    const std::string rule = "this line does not begin with the spaces of the closing line\n";
    CHECK(errors("n \"\"\"\n  a\n b\n  \"\"\"") == "3:1: " + rule);
    CHECK(errors("n \"\"\"\n\ta\n  \"\"\"") == "2:1: " + rule);
    CHECK(errors("n #\"\"\"\n  a\n \tb\n  \"\"\"#") == "3:1: " + rule);
}

TEST_CASE("a string of several lines must be closed")
{
    CHECK(errors("a\nn \"\"\"\nb {\n") == "2:3: this string is not closed\n");
    CHECK(errors("n #\"\"\"\nb\n\"\"\"") == "1:3: this string is not closed\n");
    CHECK(hint("n \"\"\"\n") ==
          "add a closing \"\"\" on a line of its own, with as many # after it as before");
}

TEST_CASE("wrong escapes are pointed at in strings of several lines")
{
    CHECK(errors("n \"\"\"\n  a\\q\n  \"\"\"\nm 1x") == "2:4: \\q means nothing in a string\n"
                                                        "4:3: \"1x\" begins like a number but is none\n");
}
