#include "tests/host/kdl/reading.hpp"

#include "host/kdl/parser.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using kfast::test::reading;

namespace {

kdl::Document parsed(std::string_view text)
{
    Diagnostics diagnostics;
    kdl::Document document = kdl::parse(text, diagnostics);
    REQUIRE_FALSE(diagnostics.has_errors());
    return document;
}

}

TEST_CASE("a document may be empty")
{
    CHECK(parsed("").nodes.empty());
    CHECK(parsed(" \n\t\n// nothing\n").nodes.empty());
}

TEST_CASE("a node has a name, arguments in order, properties and children")
{
    const kdl::Document document = parsed("lamp on size=3 off { bulb; wire }");
    REQUIRE(document.nodes.size() == 1);
    const kdl::Node& lamp = document.nodes[0];
    CHECK(lamp.name == "lamp");
    REQUIRE(lamp.arguments.size() == 2);
    CHECK(*lamp.arguments[0].string() == "on");
    CHECK(*lamp.arguments[1].string() == "off");
    REQUIRE(lamp.properties.size() == 1);
    CHECK(lamp.properties[0].name == "size");
    CHECK(lamp.properties[0].value.number()->value == 3);
    REQUIRE(lamp.children.size() == 2);
    CHECK(lamp.children[0].name == "bulb");
    CHECK(lamp.children[1].name == "wire");
}

TEST_CASE("a property that stands twice knows where its name stood first")
{
    const kdl::Node node = parsed("n a=1 b=2 a=3 a=4").nodes[0];
    REQUIRE(node.properties.size() == 2);
    CHECK(node.properties[0].name == "b");
    CHECK(!node.properties[0].replaces);
    CHECK(node.properties[1].value.number()->value == 4);
    REQUIRE(node.properties[1].replaces);
    CHECK(node.properties[1].replaces->offset == 2);
    CHECK(node.properties[1].replaces->length == 1);
}

TEST_CASE("new lines, semicolons, line comments, closing braces and the end of the text end a node")
{
    CHECK(reading("a\nb; c // rest\nd {e}") == "a\nb\nc\nd {\n    e\n}\n");
    CHECK(reading("a;b;") == "a\nb\n");
    CHECK(reading("a {};b") == "a\nb\n");
}

TEST_CASE("a block may follow its node without a space")
{
    CHECK(reading("a{b{c}}") == "a {\n    b {\n        c\n    }\n}\n");
}

TEST_CASE("keywords are values of their own kinds")
{
    const kdl::Node node = parsed("n #true #false #null").nodes[0];
    CHECK(std::get<bool>(node.arguments[0].data));
    CHECK_FALSE(std::get<bool>(node.arguments[1].data));
    CHECK(std::holds_alternative<kdl::Null>(node.arguments[2].data));
}

TEST_CASE("a property that is given again replaces the earlier one and stands in its own place")
{
    const kdl::Node node = parsed("n a=1 b=2 a=3 c=4").nodes[0];
    REQUIRE(node.properties.size() == 3);
    CHECK(node.properties[0].name == "b");
    CHECK(node.properties[1].name == "a");
    CHECK(node.properties[1].value.number()->value == 3);
    CHECK(node.properties[2].name == "c");
}

TEST_CASE("a property name may be any string, and spaces may stand around its =")
{
    CHECK(reading("n \"two words\"=1 #\"raw\"#=2 c = 3 d= 4 e =5") ==
          "n c=3 d=4 e=5 raw=2 \"two words\"=1\n");
    CHECK(reading("n a \\\n = \\\n 1") == "n a=1\n");
}

TEST_CASE("arguments and properties may alternate")
{
    CHECK(reading("n 1 b=2 3 a=4 5") == "n 1 3 5 a=4 b=2\n");
}

TEST_CASE("nodes and values may have types")
{
    CHECK(reading("(kind)n (ms)500 at=(deg)90") == "(kind)n (ms)500 at=(deg)90\n");
    CHECK(reading("( kind ) n ( /*x*/ ms ) 500 at= ( deg ) 90") == "(kind)n (ms)500 at=(deg)90\n");
    CHECK(reading("(\"two words\")n (#\"raw\"#)x") == "(\"two words\")n (raw)x\n");
    CHECK(reading("n (\"\")1") == "n (\"\")1\n");
}

TEST_CASE("a value without a type has none, which is not the same as an empty one")
{
    const kdl::Node node = parsed("n 1 (\"\")2").nodes[0];
    CHECK_FALSE(node.type.has_value());
    CHECK_FALSE(node.arguments[0].type.has_value());
    CHECK(node.arguments[1].type == "");
}

TEST_CASE("a node name may be empty or in quotes")
{
    CHECK(reading("\"\" 1") == "\"\" 1\n");
    CHECK(reading("\"12\"; #\"a b\"#") == "\"12\"\n\"a b\"\n");
}

TEST_CASE("a version marker is a comment, and another version is pointed out")
{
    CHECK(reading("/- kdl-version 2\nn") == "n\n");
    CHECK(test::errors("/- kdl-version 2\nn") == "");
    CHECK(test::errors("\uFEFF/-kdl-version 1\nn") ==
          "1:2: this text says that it is not KDL 2, but is read as KDL 2.0\n");
    CHECK(reading("/- kdl-version 1\nn") == "n\n");
    CHECK(test::errors("n\n/- kdl-version 1") == "");
}
