#include "host/preview/controls/preview_key.hpp"
#include "host/preview/painter/raster_painter.hpp"
#include "host/preview/panes/picture_pane.hpp"
#include "host/preview/panes/side_panel.hpp"
#include "host/preview/panes/text_box.hpp"
#include "host/preview/panes/time_line_pane.hpp"
#include "tests/host/preview/recording_painter.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

const std::vector<std::string> errors{
    "eyes.kfast:12:5: error: a long message that does not fit into one line of a window of usual width, "
    "and not even into two of them",
    "   12 |     ellipse 20", "1 error"};

SidePanel panel_of(int lines)
{
    SidePanel panel;
    panel.add_heading("inputs");
    panel.add_value("a name that is longer than the side", "and a value that is as long", true, 0.5);
    for (int i = 0; i < lines; ++i)
        panel.add("line " + std::to_string(i) + " which is so long that it has to be wrapped somewhere");
    return panel;
}

Picture picture_of(Size size)
{
    return {size, std::vector<Colour>(static_cast<std::size_t>(size.width * size.height), Colour{9, 9, 9})};
}

void draw_everything(Painter& painter, Rect pane)
{
    const Overlay overlay{{{{2, 2, 9, 9}, MarkKind::changed_area}},
                          {{{0, 0}, {5, 5}, MarkKind::bone}},
                          {{{5, 5}, MarkKind::point}},
                          {{{5, 5}, "12", MarkKind::point}},
                          {}};
    for (const int zoom : {0, 1, 40}) {
        const PictureLayout place{{32, 32}, pane, zoom, {3, 3}, module_margin(pane)};
        for (const bool is_round : {false, true})
            draw_picture(painter, picture_of({32, 32}), place, {is_round, true});
        draw_overlay(painter, overlay, place);
    }
    panel_of(50).draw(painter, pane);
    draw_status(painter, pane, "frame 1  0.033 s  playing");
    draw_help(painter, pane, help_pages(preview_help(PreviewFront::window), help_cells(pane)).front());
    draw_errors(painter, pane, errors);
    draw_notice(painter, pane, "eyes.png is written");
    draw_progress(painter, pane, "writing", 0.5);
    TimeTable table{
        Time{1}, {{0, "a", 0, {Time{0}}}}, {{"clip", {Time{0}, Time{1}, Loop::once}}}, {{Time{0}, "e"}}};
    draw_time_line(painter, TimeLine{table, pane}, {});
    table.end = Time{0};
    draw_time_line(painter, TimeLine{table, pane}, {});
}

}

TEST_CASE("every part can be drawn in every window")
{
    RasterPainter painter;
    for (const Size window : window_sizes()) {
        painter.begin(window);
        draw_everything(painter, {0, 0, window.width, window.height});
        draw_everything(painter, {window.width / 2, window.height / 2, 0, 0});
        CHECK(painter.drawn().size == window);
    }
}

TEST_CASE("no line of the side leaves it, and one that has no room is told")
{
    for (const Rect pane : {Rect{600, 0, 200, 200}, Rect{160, 0, 160, 100}, Rect{0, 10, 340, 900}}) {
        RecordingPainter painter{{940, 940}};
        panel_of(50).draw(painter, pane);
        for (const auto& written : painter.texts)
            CHECK_MESSAGE(lies_within(written.place, pane), written.text);
        CHECK(painter.texts.back().text == "…");
    }
    RecordingPainter painter{{940, 940}};
    panel_of(1).draw(painter, {0, 0, 340, 900});
    CHECK(painter.texts.back().text != "…");
}

TEST_CASE("a line of the side that goes on does so below its words")
{
    SidePanel panel;
    panel.add("speed: every second frame takes longer");
    RecordingPainter painter{{200, 300}};
    panel.draw(painter, {0, 0, 28 + 20 * Painter::letter.width, 300});
    CHECK(painter.find("speed: every second") != nullptr);
    CHECK(painter.find("  frame takes longer") != nullptr);
}

TEST_CASE("a bar of the side is filled as far as its value")
{
    SidePanel panel;
    panel.add_value("gaze", "0.25", false, 0.25);
    panel.add_value("mood", "7", false, 7);
    RecordingPainter painter{{300, 300}};
    panel.draw(painter, {0, 0, 228, 300});
    std::vector<int> widths;
    for (const auto& filled : painter.fills)
        if (filled.colour == theme::accent)
            widths.push_back(filled.area.width);
    CHECK(widths == std::vector{50, 200});
}

TEST_CASE("the help lies over the middle of its room")
{
    const std::vector<std::string> help = preview_help(PreviewFront::window);
    for (const Rect room : {Rect{0, 0, 900, 576}, Rect{0, 0, 640, 1000}, Rect{0, 0, 320, 216}}) {
        RecordingPainter painter{{room.width, room.height}};
        const HelpPage page = help_pages(help, help_cells(room)).front();
        draw_help(painter, room, page);
        for (const auto& written : painter.texts)
            CHECK_MESSAGE(lies_within(written.place, room), written.text);
        for (const HelpLine& line : page.lines)
            CHECK_MESSAGE(painter.find(line.text) != nullptr, line.text);
    }
}

TEST_CASE("errors stay within their room: long lines are wrapped, too many left out")
{
    for (const Rect room : {Rect{0, 0, 600, 300}, Rect{0, 0, 200, 120}}) {
        RecordingPainter painter{{900, 600}};
        draw_errors(painter, room, errors);
        for (const auto& written : painter.texts)
            CHECK_MESSAGE(lies_within(written.place, room), written.text);
        CHECK((painter.texts.back().text == "…") == (room.height < 200));
    }
}

TEST_CASE("notices are wrapped to their room, and the status is cut to it")
{
    const Rect room{50, 50, 130, 140};
    RecordingPainter painter{{900, 600}};
    draw_notice(painter, room, "a-file.png is written");
    draw_progress(painter, room, "writing a-long.gif", 2);
    draw_status(painter, room, "frame 1  0.033 s  playing  and so on");
    REQUIRE(painter.texts.size() == 5);
    CHECK(painter.texts[1].text == "written");
    for (const auto& written : painter.texts)
        CHECK_MESSAGE(lies_within(written.place, room), written.text);
}

TEST_CASE("an edge lies around the picture, not over it")
{
    RasterPainter painter;
    painter.begin({40, 40});
    const PictureLayout place{{16, 16}, {0, 0, 40, 40}, 1};
    draw_picture(painter, picture_of({16, 16}), place, {});
    const Rect edge = {place.rect().x - 1, place.rect().y - 1, 18, 18};
    int edges = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            const Colour seen = painter.drawn().pixels[static_cast<std::size_t>(y * 40 + x)];
            CHECK((seen == Colour{9, 9, 9}) == contains(place.rect(), x, y));
            if (seen == theme::border) {
                CHECK(contains(edge, x, y));
                ++edges;
            }
        }
    CHECK(edges == 4 * 17);
}

TEST_CASE("a grid tells pixels apart once they are large")
{
    const auto lines = [](int zoom) {
        RecordingPainter painter{{200, 200}};
        draw_picture(painter, picture_of({4, 4}), {{4, 4}, {0, 0, 200, 200}, zoom}, {});
        return std::ranges::count(painter.fills, theme::pixel_grid, &RecordingPainter::Filled::colour);
    };
    CHECK(lines(7) == 0);
    CHECK(lines(8) == 8);
    CHECK(lines(64) == 6); // 256 pixels wide: three lines each way are seen
}

TEST_CASE("marks lie where the picture shows what they mark")
{
    const PictureLayout place{{10, 10}, {0, 0, 100, 100}, 10};
    RecordingPainter painter{{100, 100}};
    draw_overlay(painter, {{}, {}, {{{5, 2}, MarkKind::point}}, {{{5, 2}, "7", MarkKind::point}}, {}}, place);
    REQUIRE(painter.shapes.size() == 2);
    double x = 0;
    for (const WindowSpot corner : painter.shapes[1].corners)
        x = std::max(x, corner.x);
    CHECK(x == doctest::Approx(53));
    REQUIRE(painter.texts.size() == 1);
    CHECK(painter.texts[0].place.x == 55);
    CHECK(painter.texts[0].colour == theme::mark(MarkKind::point));
}

}
