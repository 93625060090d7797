#include "host/kdl/parser.hpp"

#include <doctest/doctest.h>

using namespace kfast;

namespace {

struct Reading {
    std::string text;
    kdl::Node node;

    std::string at(SourceSpan place) const { return text.substr(place.offset, place.length); }
};

Reading first_node(std::string text)
{
    Diagnostics diagnostics;
    kdl::Document document = kdl::parse(text, diagnostics);
    REQUIRE_FALSE(diagnostics.has_errors());
    return {.text = std::move(text), .node = std::move(document.nodes.at(0))};
}

}

TEST_CASE("names and values know their places, with quotes and types")
{
    const Reading it = first_node("// x\n(kind)\"a node\" ( ms ) 500 \"b\\n\" größe = (deg)90 { c }");
    CHECK(it.at(it.node.name_span) == "\"a node\"");
    CHECK(it.at(it.node.arguments[0].place) == "( ms ) 500");
    CHECK(it.at(it.node.arguments[1].place) == "\"b\\n\"");
    CHECK(it.at(it.node.properties[0].name_span) == "größe");
    CHECK(it.at(it.node.properties[0].value.place) == "(deg)90");
    CHECK(it.at(it.node.children[0].name_span) == "c");
}

TEST_CASE("a byte order mark counts in places") { CHECK(first_node("\uFEFFab").node.name_span.offset == 3); }

TEST_CASE("a string that stands in the source as it is knows where")
{
    const Reading it = first_node("n word \"M 0 0\" ##\"a\"#\"## (t)\"typed\" \"\"");
    for (const kdl::Value& value : it.node.arguments) {
        REQUIRE(value.text_offset.has_value());
        CHECK(it.text.substr(*value.text_offset, value.string()->size()) == *value.string());
    }
    CHECK(it.node.arguments[1].text_offset == 8);
}

TEST_CASE("strings with escapes or of several lines and other values have no such place")
{
    const Reading it = first_node("n \"a\\nb\" \"a\\ b\" 12 #true\\\n \"\"\"\n x\n \"\"\"");
    CHECK(it.node.arguments.size() == 5);
    for (const kdl::Value& value : it.node.arguments)
        CHECK_FALSE(value.text_offset.has_value());
}
