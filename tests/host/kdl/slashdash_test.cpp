#include "tests/host/kdl/reading.hpp"

#include <doctest/doctest.h>

using kfast::test::errors;
using kfast::test::reading;

TEST_CASE("/- leaves out a node with all that belongs to it")
{
    CHECK(reading("/-a 1 { b }\nc") == "c\n");
    CHECK(reading("/- (kind)a\nc") == "c\n");
    CHECK(reading("x { /-a; b }") == "x {\n    b\n}\n");
}

TEST_CASE("/- leaves out an argument or a whole property")
{
    CHECK(reading("n /-1 2") == "n 2\n");
    CHECK(reading("n /- (ms)1 2") == "n 2\n");
    CHECK(reading("n /-a=1 b=2") == "n b=2\n");
    CHECK(reading("n a=1 /-a=2") == "n a=1\n");
}

TEST_CASE("no space is needed before /-")
{
    CHECK(reading("n/-1 2") == "n 2\n");
    CHECK(reading("n \"a\"/-\"b\"/-c{}/-{}") == "n a\n");
}

TEST_CASE("/- leaves out blocks, before and after the one that counts")
{
    CHECK(reading("n /-{ a } { b } /-{ c } /-{ d }") == "n {\n    b\n}\n");
    CHECK(reading("n /-{ a }") == "n\n");
}

TEST_CASE("new lines and comments may stand between /- and what it leaves out")
{
    CHECK(reading("/-\n\n// comment\na\nb") == "b\n");
    CHECK(reading("n 1 /- // comment\n /* more */ 2 3") == "n 1 3\n");
    CHECK(reading("n /-\n{ a }\nb") == "n\nb\n");
}

TEST_CASE("what is left out must be right all the same")
{
    CHECK(errors("n /-0x") == "1:5: \"0x\" is not a hexadecimal number\n");
    CHECK(errors("/-n {\n a \"\n}") == "2:4: this string is not closed on its line\n");
}

TEST_CASE("/- must stand before something")
{
    CHECK(errors("/-") == "1:1: nothing follows this /-\n");
    CHECK(errors("n /-;") == "1:3: nothing follows this /-\n");
    CHECK(errors("n { a; /- }") == "1:8: nothing follows this /-\n");
    CHECK(errors("n /-\n") == "1:3: nothing follows this /-\n");
    CHECK(errors("/- /- n") == "1:1: two /- follow each other\n");
}

TEST_CASE("/- stands before types and property names, not behind them")
{
    CHECK(errors("(kind)/-n") == "1:7: a node name is missing here\n");
    CHECK(errors("n a=/-1") == "1:5: a value is missing here\n");
    CHECK(errors("n (ms)/-1") == "1:7: a value is missing here\n");
    CHECK(errors("n (/-ms)1") == "1:4: the name of a type is missing here\n");
}

TEST_CASE("only blocks may follow a block, even one that is left out")
{
    CHECK(errors("n /-{} 1") == "1:8: more follows on the line after a children block\n");
    CHECK(errors("n /-{} /-1") == "1:8: more follows on the line after a children block\n");
}
