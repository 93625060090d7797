#include "host/commands/live/live_line.hpp"
#include "host/program/failure.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

namespace {

const std::vector<LiveInput> inputs{
    {"gaze", InputType::number, -1000, 1000}, {"left lid", InputType::number, 0, 100'000},
    {"a\"b\\", InputType::number, 0, 1000},   {"#1", InputType::number, 0, 1000},
    {"my plot", InputType::drawing},          {"label", InputType::text, 0, 5}};

using Places = std::map<std::uint8_t, Time>;

LiveValues read(std::string_view line) { return read_live_line(line, 1, inputs); }
Places places(std::string_view line) { return read(line).places; }

std::string mistake(std::string_view line)
{
    try {
        read_live_line(line, 12, inputs);
    } catch (const Failure& failure) {
        CHECK(failure.status() == ExitStatus::wrong_input);
        return failure.what();
    }
    return "none";
}

}

TEST_CASE("a line has names of inputs and values in the inputs' own units")
{
    CHECK(places("gaze 0") == Places{{0, Time{32768}}});
    CHECK(places("gaze -1") == Places{{0, Time{0}}});
    CHECK(places("\t gaze  +1 \r") == Places{{0, Time{65536}}});
    CHECK(places("gaze 0.5 \"left lid\" 25") == Places{{0, Time{49152}}, {1, Time{16384}}});
    CHECK(places("\"a\\\"b\\\\\" 1 \"#1\" 0") == Places{{2, Time{65536}}, {3, Time{0}}});
}

TEST_CASE("empty lines and comments say nothing")
{
    for (const std::string_view line : {"", "  ", "# gaze 1", "\t#", "\r"})
        CHECK(read(line).empty());
    CHECK(places("gaze 1 # to the right").size() == 1);
}

TEST_CASE("mistakes are told with their line")
{
    CHECK(mistake("gase 1") == "line 12: there is no input 'gase': did you mean \"gaze\"?");
    CHECK(mistake("gaze") == "line 12: 'gaze' has no value: write it like gaze 0.5");
    CHECK(mistake("gaze 1 gaze") == "line 12: 'gaze' has no value: write it like gaze 0.5");
    CHECK(mistake("gaze 1.01") == "line 12: '1.01' is no value of gaze: it goes from -1 to 1");
    CHECK(mistake("gaze nan") == "line 12: 'nan' is no value of gaze: it goes from -1 to 1");
    CHECK(mistake("gaze 1e999") == "line 12: '1e999' is no value of gaze: it goes from -1 to 1");
    CHECK(mistake("gaze 1x") == "line 12: '1x' is no value of gaze: it goes from -1 to 1");
    CHECK(mistake("\"left lid 1").find("line 12: a \" is missing") == 0);
    CHECK(mistake("\"left lid\\").find("line 12: a \" is missing") == 0);
    CHECK(mistake("\x1b 1").find("'<U+001B>'") != std::string::npos);
}

TEST_CASE("a text may stand beside other values")
{
    CHECK(read("label 12:45 gaze 1") == LiveValues{.places = {{0, Time{65536}}}, .texts = {{5, "12:45"}}});
    CHECK(read("label \"\"") == LiveValues{.texts = {{5, ""}}});
    CHECK(read("label \"a # b\"") == LiveValues{.texts = {{5, "a # b"}}});
    CHECK(read("label \"\u00b0\u00b0\u00b0\u00b0\u00b0\"").texts.size() == 1);
    CHECK(mistake("label") == "line 12: 'label' has no value: write it like label \"12:45\"");
    CHECK(mistake("label 123456") == "line 12: '123456' has 6 characters: label has 5 at most");
    CHECK(mistake("label \xFF") == "line 12: '<0xFF>' is no UTF-8");
}

TEST_CASE("a line that begins with the name of a drawing is that drawing")
{
    CHECK(read("\"my plot\" 1,2 3,4.5 / 5,6 # a comment, 7,8") ==
          LiveValues{.drawings = {{4, {{{16, 32}, {48, 72}}, {{80, 96}}}}}});
    CHECK(read("\"my plot\"") == LiveValues{.drawings = {{4, {}}}});
    CHECK(mistake("\"my plot\" 1,2 3") ==
          "line 12: \"3\" is no point: write it like 10,20.5, each within -2047 and 2047");
    CHECK(mistake("gaze 1 \"my plot\" 1,2") ==
          "line 12: 'my plot' is a drawing, which has a line for itself");
}

}
