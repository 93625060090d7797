#include "host/preview/painter/painter.hpp"
#include "host/preview/panes/theme.hpp"
#include "host/preview/panes/time_line.hpp"
#include "host/preview/panes/time_line_pane.hpp"
#include "tests/host/preview/recording_painter.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <string>

namespace kfast::test {
namespace {

constexpr Rect pane{0, 300, 900, 200};

TimeTable table_of(std::size_t rows)
{
    TimeTable table;
    table.end = Time::frame(120);
    table.clips = {{"idle", {Time{0}, Time::frame(60), Loop::repeat}},
                   {"blink with a long name", {Time::frame(60), Time::frame(61), Loop::once}}};
    table.events = {{Time::frame(10), "step"}, {Time::frame(119), "the last event of all"}};
    for (std::size_t i = 0; i < rows; ++i)
        table.rows.push_back({i,
                              "item " + std::to_string(i),
                              static_cast<int>(i % 3),
                              {Time::frame(static_cast<int>(i)), Time::frame(80)}});
    return table;
}

std::size_t diamonds(const RecordingPainter& painter, Colour colour)
{
    std::size_t count = 0;
    for (const auto& shape : painter.shapes)
        count += shape.corners.size() == 4 && shape.colour == colour ? 1 : 0;
    return count;
}

}

TEST_CASE("a pixel of the time line is a moment, and that moment is drawn there")
{
    const TimeTable table = table_of(3);
    const TimeLine line{table, pane};
    for (double x = line.x_of(Time{0}); x < line.x_of(table.end); x += 1)
        CHECK(std::abs(line.x_of(line.time_at(x)) - x) < 0.01);
    for (int frame = 0; frame <= 120; ++frame)
        CHECK(line.time_at(line.x_of(Time::frame(frame))) == Time::frame(frame));
}

TEST_CASE("beside the time line are its ends")
{
    const TimeTable table = table_of(3);
    const TimeLine line{table, pane};
    CHECK(line.time_at(-5) == Time{0});
    CHECK(line.time_at(5000) == table.end);
}

TEST_CASE("rows, lanes and the ruler lie below each other within the pane")
{
    for (const Size window : window_sizes())
        for (const std::size_t rows : std::array<std::size_t, 4>{0, 1, 4, 300}) {
            const TimeTable table = table_of(rows);
            const Rect place{0, 5, window.width, window.height};
            const TimeLine line{table, place, 2};
            CHECK(lies_within(line.ruler(), place));
            CHECK(line.clips().y >= bottom_of(line.ruler()));
            CHECK(line.events().y >= bottom_of(line.clips()));
            CHECK((is_empty(line.rows()) || lies_within(line.rows(), place)));
            CHECK(line.end_row() <= rows);
        }
}

TEST_CASE("a row is found where it is drawn, and its keys")
{
    const TimeTable table = table_of(40);
    const TimeLine line{table, pane, 5};
    REQUIRE(line.first_row() == 5);
    for (std::size_t row = line.first_row(); row < line.end_row(); ++row) {
        const Rect place = line.row(row);
        CHECK(line.row_at(place.x, place.y) == row);
        CHECK(line.row_at(right_of(place) - 1, bottom_of(place) - 1) == row);
        const int x = static_cast<int>(line.x_of(Time::frame(80)));
        CHECK(line.key_at(row, x) == Time::frame(80));
        CHECK(line.key_at(row, x + 20) == std::nullopt);
    }
    CHECK(line.row_at(10, line.row(line.first_row()).y - 1) == std::nullopt);
    CHECK(line.row_at(10, bottom_of(line.rows())) == std::nullopt);
}

TEST_CASE("many rows are scrolled, no farther than to the last")
{
    const TimeTable table = table_of(40);
    const TimeLine end{table, pane, 1000};
    CHECK(end.first_row() == end.last_first_row());
    CHECK(end.end_row() == 40);
    CHECK(end.end_row() - end.first_row() == 6);
    const TimeTable few = table_of(2);
    CHECK(TimeLine{few, pane, 1}.first_row() == 0);
}

TEST_CASE("a time line that gets what it wants shows all its rows")
{
    const TimeTable table = table_of(7);
    const TimeLine line{table, {0, 0, 500, TimeLine::wanted_height(table)}};
    CHECK(line.end_row() == 7);
}

TEST_CASE("the ruler has round numbers with room for each")
{
    CHECK(ruler_step(40, 30) == 1);
    CHECK(ruler_step(16, 30) == 2);
    CHECK(ruler_step(6, 30) == 5);
    CHECK(ruler_step(0.4, 30) == 100);
    CHECK(ruler_step(0, 30) == 1'000'000);
}

TEST_CASE("a time line shows names, clips, events and keys where they belong")
{
    const TimeTable table = table_of(3);
    const TimeLine line{table, pane};
    RecordingPainter painter{{900, 600}};
    draw_time_line(painter, line, {.now = Time::frame(80), .selected = 1, .clip = "idle"});
    for (const char* text : {"item 0", "item 2", "idle", "step", "0", "120", "0 s", "4 s"})
        CHECK_MESSAGE(painter.find(text) != nullptr, text);
    CHECK(diamonds(painter, theme::key) == 3);
    CHECK(diamonds(painter, theme::play_head) == 4); // three keys at this moment, and the line of the head
    REQUIRE(painter.find("item 1") != nullptr);
    CHECK(painter.find("item 1")->colour == theme::text);
    CHECK(painter.find("item 0")->colour == theme::quiet_text);
    REQUIRE(painter.find("step") != nullptr);
    CHECK(painter.find("step")->place.x == static_cast<int>(line.x_of(Time::frame(10))) + 11);
}

TEST_CASE("no text of a time line leaves its pane")
{
    for (const Size window : window_sizes()) {
        const TimeTable table = table_of(30);
        const Rect place{0, 0, window.width, window.height};
        RecordingPainter painter{window};
        draw_time_line(painter, TimeLine{table, place}, {.now = Time::frame(3)});
        for (const auto& written : painter.texts)
            if (place.width >= 300 && place.height >= 40)
                CHECK_MESSAGE(lies_within(written.place, place), written.text);
    }
}

}
