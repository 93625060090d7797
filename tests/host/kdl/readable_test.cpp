#include "host/kdl/readable.hpp"

#include "host/kdl/canonical.hpp"
#include "host/kdl/parser.hpp"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>

namespace kfast::kdl {
namespace {

constexpr std::array<std::string_view, 1> crowded{"at"};

Document parsed(std::string_view text)
{
    Diagnostics diagnostics;
    Document document = parse(text, diagnostics);
    CHECK(!diagnostics.has_errors());
    return document;
}

/// What is read again is the same.
std::string written(std::string_view text)
{
    const Document document = parsed(text);
    std::string result = readable(document.nodes, crowded);
    CHECK(canonical(parsed(result)) == canonical(document));
    return result;
}

}

TEST_CASE("short nodes stand on one line, with their children")
{
    CHECK(written("canvas 10 20 fps=30\n") == "canvas 10 20 fps=30\n");
    CHECK(written("palette {\n ink red\n night \"#001\"\n}") == "palette { ink red; night \"#001\" }\n");
    CHECK(written("a \"two words\" flag=#true { b (ms)5 }") == "a \"two words\" flag=#true { b (ms)5 }\n");
}

TEST_CASE("nodes in nodes, and different ones with properties, stand below each other")
{
    CHECK(written("group { object a { line 0 0 5 5 } }") == "group {\n    object a { line 0 0 5 5 }\n}\n");
    CHECK(written("object a { line 0 0 5 5; key 0 x=5 }") ==
          "object a {\n    line 0 0 5 5\n    key 0 x=5\n}\n");
}

TEST_CASE("crowded nodes fill lines")
{
    std::string track = "track x {";
    for (int i = 0; i < 30; ++i)
        track += " at " + std::to_string(i) + " 5;";
    const std::string text = written(track + " }");
    CHECK(text.starts_with("track x {\n    at 0 5; at 1 5;"));
    CHECK(std::ranges::count(text, '\n') == 5);
}

TEST_CASE("texts of several lines keep them")
{
    CHECK(written("path \"M 0 0\\nL 5 5\"") == "path \"\"\"\n    M 0 0\n    L 5 5\n    \"\"\"\n");
    CHECK(written("key 0 { path \"M 0 0\\nL 5 5\" }") ==
          "key 0 {\n    path \"\"\"\n        M 0 0\n        L 5 5\n        \"\"\"\n}\n");
}

TEST_CASE("what nobody would see is written as codes")
{
    CHECK(written("\"a\\u{200b}b\" \"\\u{9b}\" x=\"\\u{1b}\"") ==
          "\"a\\u{200b}b\" \"\\u{9b}\" x=\"\\u{1b}\"\n");
    CHECK(written("path \"a\\n\\u{9b}\"") == "path \"a\\n\\u{9b}\"\n");
}

}
