#include "host/preview/headless.hpp"
#include "host/preview/painter/raster_painter.hpp"
#include "host/preview/panes/theme.hpp"
#include "tests/host/preview/window_of_halves.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace kfast::test {
namespace {

using Kind = PointerEvent::Kind;

}
TEST_CASE("a window shows the picture, the scene's facts, the time line and the status")
{
    Window window;
    REQUIRE(window.painter.pictures.size() == 1);
    const Rect picture = window.painter.pictures[0];
    CHECK(picture.width % 20 == 0);
    CHECK(picture.width == picture.height);
    for (const char* text : {"halves.kfast", "20 x 20", "100 at 10/s", "10 s", "gaze", "left", "right",
                             "blink", "step", "nothing: click, or press tab"})
        CHECK_MESSAGE(window.has_text(text), text);
}

TEST_CASE("a window of any size can be drawn, with everything in it")
{
    Window window;
    for (const PreviewKey key : {PreviewKey::bones, PreviewKey::numbers, PreviewKey::panel_frame,
                                 PreviewKey::onion_skin, PreviewKey::changed_areas, PreviewKey::help})
        window.screen.press(key, window.viewer, window.now);
    for (const Size size : window_sizes())
        CHECK(window.draw(size).pictures.size() == 1);
}

TEST_CASE("a click on the picture selects what is under it, and beside it nothing")
{
    Window window;
    const Rect picture = window.painter.pictures[0];
    window.click(picture.x + 5, picture.y + 5);
    CHECK(window.selected() == "left");
    window.click(right_of(picture) - 5, picture.y + 5);
    CHECK(window.selected() == "right");
    window.draw();
    CHECK(window.has_text("right"));
    window.click(picture.x - 5, picture.y + 5);
    CHECK(window.selected().empty());
}

TEST_CASE("dragging along the ruler scrubs frame by frame")
{
    Window window;
    const TimeLine line = window.time_line();
    const int y = line.ruler().y + 10;
    const auto x = [&](int frame) { return static_cast<int>(line.x_of(Time::frame(frame))); };
    window.touch(Kind::press, x(20), y);
    CHECK(window.frame() == 20);
    CHECK_FALSE(window.viewer.playback().playing());
    for (const int frame : {21, 40, 7}) {
        window.touch(Kind::move, x(frame), y + 300);
        CHECK(window.viewer.playback().time() == Time::frame(frame));
    }
    window.touch(Kind::move, -100, y);
    CHECK(window.frame() == 0);
    window.touch(Kind::release, -100, y);
    window.touch(Kind::move, x(50), y);
    CHECK(window.frame() == 0);
}

TEST_CASE("a click on a row selects it, one on a key goes to it as well")
{
    Window window;
    const TimeLine line = window.time_line();
    const auto row_of = [&](const char* name) {
        std::size_t row = 0;
        while (line.table().rows[row].name != name)
            ++row;
        return row;
    };
    const Rect left = line.row(row_of("left"));
    window.click(5, left.y + 5);
    CHECK(window.selected() == "left");
    CHECK(window.frame() == 0);
    window.click(static_cast<int>(line.x_of(Time::frame(50))) + 2, left.y + 5);
    CHECK(window.frame() == 50);
    const Rect right = line.row(row_of("right"));
    window.click(static_cast<int>(line.x_of(Time::frame(70))), right.y + 5);
    CHECK(window.selected() == "right");
    CHECK(window.frame() == 50);
}

TEST_CASE("the wheel zooms at the pointer, and dragging pans what is larger than the pane")
{
    Window window;
    const Rect before = window.painter.pictures[0];
    for (int i = 0; i < 8; ++i)
        window.touch(Kind::wheel, before.x + 10, before.y + 10, 1);
    window.draw();
    const Rect large = window.painter.pictures[0];
    CHECK(large.width > 1000);
    window.drag({{200, 200}, {150, 150}, {100, 180}});
    window.draw();
    CHECK(window.painter.pictures[0].x == large.x - 100);
    CHECK(window.painter.pictures[0].y == large.y - 20);
    CHECK(window.selected().empty());
    for (int i = 0; i < 20 && window.painter.pictures[0].width > before.width; ++i) {
        window.touch(Kind::wheel, 300, 200, -1);
        window.draw();
    }
    CHECK(window.painter.pictures[0] == before);
    CHECK(window.viewer.view().zoom == 0);
}

TEST_CASE("the keys zoom from what is seen on")
{
    Window window;
    const int before = window.painter.pictures[0].width / 20;
    window.screen.press(PreviewKey::zoom_in, window.viewer, window.now);
    window.draw();
    CHECK(window.painter.pictures[0].width / 20 > before);
    window.screen.press(PreviewKey::zoom_out, window.viewer, window.now);
    window.draw();
    CHECK(window.painter.pictures[0].width / 20 <= before);
}

TEST_CASE("at first the picture is seen, and at the edge how to get help")
{
    Window window;
    CHECK(window.has_text("h: help"));
    CHECK_FALSE(window.has_text("next key frame"));
    CHECK(std::ranges::none_of(window.painter.texts, [](const RecordingPainter::Text& written) {
        return written.text.find("next key frame") != std::string::npos;
    }));
    window.draw({320, 240});
    CHECK(window.has_text("h: help"));
    window.press(PreviewKey::help);
    window.draw();
    CHECK_FALSE(window.has_text("h: help"));
}

TEST_CASE("a click closes the help and does nothing else")
{
    Window window;
    window.viewer.press(PreviewKey::help, window.now);
    REQUIRE(window.viewer.playback().help_open());
    const WindowSpot middle = middle_of(window.painter.pictures[0]);
    window.click(static_cast<int>(middle.x), static_cast<int>(middle.y));
    CHECK_FALSE(window.viewer.playback().help_open());
    CHECK(window.selected().empty());
}

TEST_CASE("in a small window h turns the pages of the help, and any other key closes it")
{
    Window window;
    window.press(PreviewKey::help);
    window.draw({320, 240});
    CHECK(window.has_text("h  next page, 1 of 5"));
    window.press(PreviewKey::help);
    window.draw({320, 240});
    CHECK(window.has_text("h  next page, 2 of 5"));
    window.press(PreviewKey::leave);
    CHECK_FALSE(window.viewer.playback().help_open());
    CHECK_FALSE(window.viewer.wants_to_quit());
    window.press(PreviewKey::help);
    window.draw({320, 240});
    CHECK(window.has_text("h  next page, 1 of 5"));
    window.draw({900, 600});
    window.press(PreviewKey::help);
    CHECK_FALSE(window.viewer.playback().help_open());
}

TEST_CASE("only the left button of the mouse does something")
{
    Window window;
    const Rect picture = window.painter.pictures[0];
    const TimeLine line = window.time_line();
    for (const auto& [x, y] : {std::pair{picture.x + 5, picture.y + 5},
                               std::pair{static_cast<int>(line.x_of(Time::frame(20))), line.ruler().y + 10}})
        for (const Kind kind : {Kind::press, Kind::release})
            window.screen.touch({.kind = kind, .x = x, .y = y, .button = PointerEvent::Button::other},
                                window.viewer, window.now);
    CHECK(window.selected().empty());
    CHECK(window.frame() == 0);
}

TEST_CASE("the facts that were asked for are at the beginning of the status")
{
    Window window;
    window.press(PreviewKey::changed_areas);
    window.draw({320, 240});
    CHECK(std::ranges::any_of(window.painter.texts, [](const RecordingPainter::Text& written) {
        return written.text.find("1 area, 811 bytes, 100 % of the panel") == 0;
    }));
}

TEST_CASE("the picture is as large as fits, and the time line has as many rows as are left")
{
    Window window;
    std::string rows = "kfast 1\ncanvas 240 240\n";
    for (int i = 0; i < 20; ++i)
        rows += "object part" + std::to_string(i) + " fill=red { key 0 { rect 0 0 9 9 } }\n";
    std::ofstream{window.folder / "rows.kfast"} << rows;
    window.viewer.open(window.folder / "rows.kfast", window.now);
    window.draw({960, 720});
    CHECK(window.painter.pictures[0].width == 480);
    CHECK(window.has_text("part19"));
    CHECK(window.has_text("part14"));
    CHECK_FALSE(window.has_text("part0"));
}

TEST_CASE("a notice goes away after a while, errors stay until the file is good")
{
    Window window;
    std::ofstream{window.folder / "bad.kfast"} << "kfast 1\nnonsense";
    window.viewer.open(window.folder / "bad.kfast", window.now);
    window.viewer.press(PreviewKey::screenshot, window.now);
    const std::string notice = window.viewer.notice();
    REQUIRE_FALSE(notice.empty());
    const auto shows_notice = [&] {
        window.draw({4000, 600}); // so that the path is not cut
        return window.has_text(notice.c_str());
    };
    CHECK(shows_notice());
    CHECK_FALSE(window.screen.is_outdated(window.now));
    window.now += Viewer::Seconds{5};
    CHECK(window.screen.is_outdated(window.now));
    CHECK_FALSE(shows_notice());
    CHECK_FALSE(window.screen.is_outdated(window.now));
    CHECK(std::ranges::count(window.painter.texts, theme::bad, &RecordingPainter::Text::colour) > 0);
}

TEST_CASE("the help and the errors do not cover each other")
{
    Window window;
    std::ofstream{window.folder / "bad.kfast"} << "kfast 1\nnonsense";
    window.viewer.open(window.folder / "bad.kfast", window.now);
    window.press(PreviewKey::help);
    for (const Size size : {Size{900, 600}, Size{400, 300}}) {
        window.draw(size);
        int errors_end = 0;
        int help_begin = size.height;
        for (const auto& text : window.painter.texts) {
            if (text.colour == theme::bad)
                errors_end = std::max(errors_end, bottom_of(text.place));
            if (text.colour == theme::key)
                help_begin = std::min(help_begin, text.place.y);
        }
        CHECK(errors_end > 0);
        CHECK(help_begin < size.height);
        CHECK(errors_end < help_begin);
    }
}

TEST_CASE("a notice that is told again is shown again")
{
    Window window;
    const auto shows_notice = [&] {
        window.viewer.press(PreviewKey::screenshot, window.now);
        window.draw({4000, 600});
        return window.has_text(window.viewer.notice().c_str());
    };
    CHECK(shows_notice());
    const std::string first = window.viewer.notice();
    std::filesystem::remove(window.folder / "halves-0000.png");
    window.now += Viewer::Seconds{5};
    CHECK(shows_notice());
    CHECK(window.viewer.notice() == first);
}

TEST_CASE("a key that zooms closes the help, as others do")
{
    Window window;
    window.screen.press(PreviewKey::help, window.viewer, window.now);
    REQUIRE(window.viewer.playback().help_open());
    window.screen.press(PreviewKey::zoom_in, window.viewer, window.now);
    CHECK_FALSE(window.viewer.playback().help_open());
}

TEST_CASE("a snapshot is the window after a script")
{
    Window window;
    std::ostringstream out;
    const std::vector<ScriptStep> script{*script_step("select=left"), *script_step("frame=50")};
    const Picture picture = snapshot(window.viewer, script, {640, 480}, out);
    CHECK(picture.size == Size{640, 480});
    CHECK(window.frame() == 50);
    CHECK(out.str().find("frame 50") != std::string::npos);
    RasterPainter painter;
    painter.begin({640, 480});
    window.screen.draw(painter, window.viewer, window.now);
    CHECK(painter.drawn().pixels == picture.pixels);
}

}
