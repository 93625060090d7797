#include "host/commands/live_line.hpp"
#include "host/failure.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

using link::InputPlace;

namespace {

const std::vector<LiveInput> inputs{
    {"gaze", -1000, 1000}, {"left lid", 0, 100'000}, {"a\"b\\", 0, 1000}, {"#1", 0, 1000}};

std::vector<InputPlace> read(std::string_view line) { return read_live_line(line, 1, inputs); }

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
    CHECK(read("gaze 0") == std::vector{InputPlace{0, Time{32768}}});
    CHECK(read("gaze -1") == std::vector{InputPlace{0, Time{0}}});
    CHECK(read("\t gaze  +1 \r") == std::vector{InputPlace{0, Time{65536}}});
    CHECK(read("gaze 0.5 \"left lid\" 25") ==
          std::vector{InputPlace{0, Time{49152}}, InputPlace{1, Time{16384}}});
    CHECK(read("\"a\\\"b\\\\\" 1 \"#1\" 0") ==
          std::vector{InputPlace{2, Time{65536}}, InputPlace{3, Time{0}}});
}

TEST_CASE("empty lines and comments say nothing")
{
    for (const std::string_view line : {"", "  ", "# gaze 1", "\t#", "\r"})
        CHECK(read(line).empty());
    CHECK(read("gaze 1 # to the right").size() == 1);
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

TEST_CASE("a line that begins with the name of a drawing is that drawing")
{
    const std::vector<LiveInput> mixed{{"gaze", -1000, 1000}, {"my plot", 0, 0, InputType::drawing}};
    const auto drawing = read_live_drawing("\"my plot\" 1,2 3,4.5 / 5,6 # a comment, 7,8", 1, mixed);
    REQUIRE(drawing);
    CHECK(drawing->input == 1);
    CHECK(drawing->drawing == ToldDrawing{{{16, 32}, {48, 72}}, {{80, 96}}});
    CHECK(read_live_drawing("\"my plot\"", 1, mixed)->drawing.empty());
    CHECK_FALSE(read_live_drawing("gaze 1", 1, mixed));
    CHECK_FALSE(read_live_drawing("plot 1,2", 1, mixed));
    CHECK_FALSE(read_live_drawing("# my plot", 1, mixed));
    CHECK_THROWS_WITH(read_live_drawing("\"my plot\" 1,2 3", 7, mixed),
                      "line 7: \"3\" is no point: write it like 10,20.5, each within -2047 and 2047");
    CHECK_THROWS_WITH(read_live_line("gaze 1 \"my plot\" 1,2", 7, mixed),
                      "line 7: 'my plot' is no number: a drawing has a line for itself");
}

}
