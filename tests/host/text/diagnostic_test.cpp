#include "host/text/diagnostic.hpp"

#include <doctest/doctest.h>

using namespace kfast;

TEST_CASE("a diagnostic is shown with its line, its place and its remedy")
{
    const SourceText source{.name = "lamp.kfast", .text = "scene\n\tobject lamp blu\n"};
    const Diagnostic diagnostic{.severity = Severity::error,
                                .place = {.offset = 19, .length = 3},
                                .message = "unknown colour \"blu\"",
                                .hint = "did you mean \"blue\"?"};
    CHECK(format(diagnostic, source) == "lamp.kfast:2:14: error: unknown colour \"blu\"\n"
                                        "   2 |     object lamp blu\n"
                                        "     |                 ^~~\n"
                                        "     = help: did you mean \"blue\"?\n");
}

TEST_CASE("without a remedy there is no help line, and a warning is called one")
{
    const SourceText source{.name = "a", .text = "x"};
    const Diagnostic diagnostic{
        .severity = Severity::warning, .place = {.offset = 0, .length = 1}, .message = "odd", .hint = ""};
    CHECK(format(diagnostic, source) == "a:1:1: warning: odd\n"
                                        "   1 | x\n"
                                        "     | ^\n");
}

TEST_CASE("the same warning at the same place is reported once")
{
    Diagnostics diagnostics;
    for (int copy = 0; copy < 3; ++copy)
        diagnostics.warning({.offset = 4, .length = 1}, "odd");
    diagnostics.warning({.offset = 4, .length = 1}, "even");
    diagnostics.warning({.offset = 5, .length = 1}, "odd");
    CHECK(diagnostics.in_order_found().size() == 3);
}

TEST_CASE("the gutter grows with the line number")
{
    const SourceText source{.name = "a", .text = std::string(12344, '\n') + "x"};
    const Diagnostic diagnostic{.place = {.offset = 12344, .length = 1}, .message = "m", .hint = "r"};
    CHECK(format(diagnostic, source) == "a:12345:1: error: m\n"
                                        "12345 | x\n"
                                        "      | ^\n"
                                        "      = help: r\n");
}

TEST_CASE("names, messages and remedies cannot steer the terminal")
{
    const SourceText source{.name = "\x1B", .text = ""};
    const Diagnostic diagnostic{.place = {}, .message = "\x07", .hint = "\n"};
    CHECK(format(diagnostic, source) == "<U+001B>:1:1: error: <U+0007>\n"
                                        "   1 | \n"
                                        "     | ^\n"
                                        "     = help: <U+000A>\n");
}

TEST_CASE("only errors count as errors")
{
    Diagnostics diagnostics;
    CHECK_FALSE(diagnostics.has_errors());
    diagnostics.warning({}, "w");
    CHECK_FALSE(diagnostics.has_errors());
    diagnostics.error({}, "e");
    CHECK(diagnostics.has_errors());
}

TEST_CASE("diagnostics come in the order of their places, those of one place in the order of reporting")
{
    Diagnostics diagnostics;
    diagnostics.error({.offset = 9, .length = 1}, "c");
    diagnostics.warning({.offset = 2, .length = 1}, "a");
    diagnostics.error({.offset = 2, .length = 1}, "b");
    std::string order;
    for (const Diagnostic& diagnostic : diagnostics.sorted())
        order += diagnostic.message;
    CHECK(order == "abc");
}
