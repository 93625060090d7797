#include "host/kdl/canonical.hpp"

#include "tests/host/kdl/reading.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using kfast::test::reading;

namespace {

std::string form_of_text(std::string text)
{
    kdl::Value value;
    value.data = std::move(text);
    kdl::Node node;
    node.name = "n";
    node.arguments.push_back(std::move(value));
    return kdl::canonical({.nodes = {std::move(node)}}).substr(2);
}

}

TEST_CASE("an empty document is one empty line") { CHECK(kdl::canonical({}) == "\n"); }

TEST_CASE("children are indented by four spaces, and empty blocks left out")
{
    CHECK(reading("a{b{c{}};d}") == "a {\n    b {\n        c\n    }\n    d\n}\n");
}

TEST_CASE("properties are sorted by name and stand after the arguments")
{
    CHECK(reading("n z=1 \"\"=2 a=3 Z=4 5") == "n 5 \"\"=2 Z=4 a=3 z=1\n");
}

TEST_CASE("quotes stand only where they must")
{
    CHECK(form_of_text("plain") == "plain\n");
    CHECK(form_of_text("größe") == "größe\n");
    for (const char* text : {"", "two words", "12", "-1", ".5", "+.5", "true", "-inf", "a=b", "a/b", "a#b",
                             "a;b", "{", "a(b", "a]b", "a\u00A0b"})
        CHECK(form_of_text(text) == '"' + std::string(text) + "\"\n");
}

TEST_CASE("what cannot stand between quotes is escaped")
{
    CHECK(form_of_text("\"\\\b\f\n\r\t /") == R"("\"\\\b\f\n\r\t /")"
                                              "\n");
    CHECK(form_of_text("a\v\u0085\u2028b") == R"("a\u{b}\u{85}\u{2028}b")"
                                              "\n");
    CHECK(form_of_text("\u0001\u007F\u200E\uFEFF") == R"("\u{1}\u{7f}\u{200e}\u{feff}")"
                                                      "\n");
}

TEST_CASE("the canonical form of a canonical form is the same")
{
    const std::string once = reading("(t)a 1e5 0xff \"x\\ny\" #\"\\\"# k=#nan {\n b /-c\n}\n");
    CHECK(once == "(t)a 1E+5 255 \"x\\ny\" \"\\\\\" k=#nan {\n    b\n}\n");
    CHECK(reading(once) == once);
}
