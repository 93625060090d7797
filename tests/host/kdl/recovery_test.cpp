#include "tests/host/kdl/reading.hpp"

#include "host/kdl/canonical.hpp"
#include "host/kdl/parser.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using kfast::test::errors;
using kfast::test::hint;

namespace {

std::string survivors(std::string_view text)
{
    Diagnostics diagnostics;
    const kdl::Document document = kdl::parse(text, diagnostics);
    REQUIRE(diagnostics.has_errors());
    return kdl::canonical(document);
}

}

TEST_CASE("one run finds the errors of several nodes")
{
    CHECK(errors("a 0x\nb true\nc\nd \"x\n") == "1:3: \"0x\" is not a hexadecimal number\n"
                                                "2:3: \"true\" is not a value\n"
                                                "4:3: this string is not closed on its line\n");
}

TEST_CASE("one run finds the errors of a node and of its children")
{
    CHECK(errors("a 0x {\n b 1x\n c\n}\nd .1") == "1:3: \"0x\" is not a hexadecimal number\n"
                                                  "2:4: \"1x\" begins like a number but is none\n"
                                                  "5:3: a number cannot begin with its point\n");
}

TEST_CASE("what follows an error in a node is not reported again")
{
    CHECK(errors("a [1, 2] = (x y) \"\nb") == "1:3: \"[\" cannot stand here\n");
    CHECK(errors("a b\"c d\" e\"f\"") == "1:4: a space is missing here\n");
    CHECK(errors("a { b 1x } 1x 1y\nc 1z") == "1:7: \"1x\" begins like a number but is none\n"
                                              "1:12: more follows on the line after a children block\n"
                                              "2:3: \"1z\" begins like a number but is none\n");
}

TEST_CASE("an error does not end its node")
{
    CHECK(survivors("a 1x 2 p=3 {\n b\n}\nc") == "a 2 p=3 {\n    b\n}\nc\n");
    CHECK(survivors("a\n}\nb") == "a\nb\n");
}

TEST_CASE("a node without a name is left out") { CHECK(survivors("a\n12 b\nc") == "a\nc\n"); }

TEST_CASE("an unclosed block is the only error about its end")
{
    CHECK(errors("a {\n b {\n  c {\n") == "3:5: this { is not closed\n");
}

TEST_CASE("what is not indented under an unclosed block tells where its end is missing")
{
    CHECK(hint("a {\n b\n") == "add a closing }");
    CHECK(hint("a {\n b\nc\n") == "add a closing }, perhaps before line 3");
    CHECK(hint("a {\n\tb {\n\t\tc\n\td {\n\t}\n}\n") == "add a closing }");
    CHECK(hint("a {\r\n b {\r\n  c\r\n}\r\nd {\r\n}") == "add a closing }, perhaps before line 5");
    CHECK(hint("a { b; c") == "add a closing }");
}

TEST_CASE("a string without an end hides the rest, and nothing is said about it")
{
    CHECK(errors("a {\n b \"\"\"\n c 1x\n}\n") == "2:4: this string is not closed\n");
    CHECK(errors("a {\n b /* 1x\n}\n") == "2:4: this comment is not closed\n");
}

TEST_CASE("twenty errors are shown, and one line says that there are more")
{
    std::string text;
    for (int line = 0; line < 20; ++line)
        text += "n 1x\n";
    const std::string twenty = errors(text);
    CHECK(twenty.ends_with("20:3: \"1x\" begins like a number but is none\n"));
    CHECK(errors(text + "n 1x\nn 1x\n") ==
          twenty + "20:3: there are more than 20 errors; the rest is not shown\n");
}
