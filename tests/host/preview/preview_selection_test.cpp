#include "tests/host/preview/window_of_halves.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <memory>
#include <vector>

namespace kfast::test {

TEST_CASE("what is selected is described at the side: its line, its values, and the keys around the moment")
{
    Window window;
    window.viewer.select(window.viewer.time_table().row_named("left")->item);
    window.draw();
    for (const char* const text :
         {"halves.kfast:6", "opacity", "fill", "#ff0000", "shape", "  0: constant", "  50"})
        CHECK_MESSAGE(window.has_text(text), text);
}

TEST_CASE("a click on the line opens the editor there")
{
    struct Kept : Editor {
        explicit Kept(std::vector<TextLine>& opened) : opened_{opened} {}
        void open(const TextLine& at) override { opened_.push_back(at); }
        std::vector<TextLine>& opened_;
    };
    std::vector<TextLine> opened;
    Window window;
    window.viewer.let_edit(std::make_unique<Kept>(opened));
    window.viewer.select(window.viewer.time_table().row_named("right")->item);
    window.draw();
    const RecordingPainter::Text* const line = window.painter.find("halves.kfast:10");
    REQUIRE(line != nullptr);
    window.click(line->place.x + 5, line->place.y + 30);
    CHECK(opened.empty());
    window.click(line->place.x + 5, line->place.y + 5);
    REQUIRE(opened.size() == 1);
    CHECK(opened[0].line == 10);
}

TEST_CASE("a click on the triangle of a row unfolds it, and its quantities have keys to click on")
{
    Window window;
    const RecordingPainter::Text* const triangle = window.painter.find("▸");
    REQUIRE(triangle != nullptr);
    window.click(triangle->place.x + 3, triangle->place.y + 3);
    CHECK(window.selected().empty());
    window.draw();
    CHECK(window.has_text("▾"));
    CHECK(window.has_text("shape"));
    window.press(PreviewKey::quantities);
    window.draw();
    CHECK_FALSE(window.has_text("shape"));

    window.press(PreviewKey::quantities);
    const TimeTable table = window.viewer.unfolded_table();
    const int height = TimeLine::wanted_height(table);
    const TimeLine line{table, {0, 576 - height, 900, height}};
    const auto shape = std::ranges::find_if(table.rows, [](const TimeRow& row) {
        return row.is_quantity && row.name == "shape" && row.keys.size() == 2;
    });
    REQUIRE(shape != table.rows.end());
    const Rect row = line.row(static_cast<std::size_t>(shape - table.rows.begin()));
    window.draw();
    CHECK(window.frame() == 0);
    window.click(static_cast<int>(line.x_of(Time::frame(50))) + 2, row.y + 5);
    CHECK(window.frame() == 50);
}

}
