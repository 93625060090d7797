#include "tests/host/simulator/wired_model.hpp"

#include <doctest/doctest.h>

#include <array>

namespace kfast::test {
namespace {

/// 16 bytes.
WiredModel& start(WiredModel& wired, int segments = 0xA1, int lines = 0xC8, int addressing = 0)
{
    return wired.low({0xAE, 0xD3, 0, 0x40, 0xA8, 63, 0x8D, 0x14, 0x20, addressing, segments, lines, 0xDA,
                      0x12, 0xA6, 0xAF});
}

WiredModel& window(WiredModel& wired, int left, int right, int first_page, int last_page)
{
    return wired.low({0x21, left, right, 0x22, first_page, last_page});
}

/// A line of text for each row, without those below the last lit one.
std::string lit(const WiredModel& wired)
{
    CHECK(wired.error() == "none");
    const Frame picture = wired.model->picture();
    std::string text;
    const std::vector<int> pixels = pixels_of<PixelFormat::mono1>(picture);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        text += pixels[i] != 0 ? '#' : '.';
        if ((i + 1) % static_cast<std::size_t>(picture.size.width) == 0)
            text += '\n';
    }
    return text;
}

constexpr const char* dark_glass = "....\n....\n....\n....\n....\n....\n....\n....\n";

/// A glass of 4 x 8 at (5, 16).
WiredModel small_glass() { return WiredModel{with_glass(Controller::ssd1306, {4, 8}, 5, 16)}; }

}

TEST_CASE("SSD1306 model: every orientation reaches the corners of a glass with an offset")
{
    struct Orientation {
        int segments;
        int lines;
        std::array<int, 2> columns; ///< of the left and the right edge of the glass
        int page;
        int upper; ///< the bit of the upper line
        int lower;
    };
    for (const Orientation& way :
         {Orientation{0xA1, 0xC8, {5, 8}, 2, 0x01, 0x80}, Orientation{0xA0, 0xC8, {122, 119}, 2, 0x01, 0x80},
          Orientation{0xA1, 0xC0, {5, 8}, 5, 0x80, 0x01},
          Orientation{0xA0, 0xC0, {122, 119}, 5, 0x80, 0x01}}) {
        CAPTURE(way.segments);
        CAPTURE(way.lines);
        WiredModel wired = small_glass();
        start(wired, way.segments, way.lines);
        window(wired, way.columns[0], way.columns[0], way.page, way.page).high({way.upper | way.lower});
        window(wired, way.columns[1], way.columns[1], way.page, way.page).high({way.lower});
        CHECK(lit(wired) == "#...\n....\n....\n....\n....\n....\n....\n#..#\n");
    }
}

TEST_CASE("SSD1306 model: windows are filled along columns, along pages, or a page alone")
{
    const auto middle = [](WiredModel& wired) {
        return pixels_of<PixelFormat::mono1>(wired.model->picture());
    };
    WiredModel wired{with_glass(Controller::ssd1306, {2, 16})};
    std::vector<int> expected(32);
    SUBCASE("horizontal")
    {
        window(start(wired), 0, 1, 0, 1).high({1, 2, 4, 8});
        expected[0] = expected[3] = expected[20] = expected[23] = 1;
    }
    SUBCASE("vertical")
    {
        window(start(wired, 0xA1, 0xC8, 1), 0, 1, 0, 1).high({1, 4, 2, 8});
        expected[0] = expected[3] = expected[20] = expected[23] = 1;
    }
    SUBCASE("pages")
    {
        start(wired, 0xA1, 0xC8, 2).low({0xB1, 0x00, 0x10}).high({4, 8});
        expected[20] = expected[23] = 1;
    }
    SUBCASE("pages, from a column on")
    {
        start(wired, 0xA1, 0xC8, 2).low({0xB0, 0x01, 0x10}).high({2});
        expected[3] = 1;
    }
    CHECK(wired.error() == "none");
    CHECK(middle(wired) == expected);
}

TEST_CASE("SSD1306 model: a glass of fewer lines is mirrored within them")
{
    WiredModel wired{with_glass(Controller::ssd1306, {1, 32})};
    start(wired, 0xA0, 0xC0).low({0xA8, 31, 0xDA, 0x02});
    window(wired, 127, 127, 0, 0).high({0x01});
    CHECK(lit(wired).find('#') == 31 * 2);
    wired.low({0x41});
    CHECK(lit(wired).find('#') == std::string::npos);
}

TEST_CASE("SSD1306 model: inverted, all lit, off")
{
    WiredModel wired = small_glass();
    start(wired);
    window(wired, 5, 5, 2, 2).high({0xFE});
    const std::string plain = "....\n#...\n#...\n#...\n#...\n#...\n#...\n#...\n";
    const std::string inverse = "####\n.###\n.###\n.###\n.###\n.###\n.###\n.###\n";
    CHECK(lit(wired) == plain);
    CHECK(lit(wired.low({0xA7})) == inverse);
    CHECK(lit(wired.low({0xA4})) == inverse);
    CHECK(lit(wired.low({0xA5})).find('.') == std::string::npos);
    CHECK(lit(wired.low({0xA4, 0xA6})) == plain);
    CHECK(lit(wired.low({0xAE})) == dark_glass);
    CHECK(lit(wired.low({0xAF})) == plain);

    window(wired.low({0xAE}), 5, 5, 2, 2).high({0x00});
    CHECK(lit(wired) == dark_glass);
    CHECK(lit(wired.low({0xA7, 0xAF})).find('.') == std::string::npos); // written in the dark

    PanelSettings inverted = with_glass(Controller::ssd1306, {4, 8}, 5, 16);
    inverted.inverted = true;
    WiredModel other{inverted};
    window(start(other).low({0xA7}), 5, 5, 2, 2).high({0xFE});
    CHECK(lit(other) == plain);
}

TEST_CASE("SSD1306 model: every mistake is named with the place of its byte")
{
    WiredModel wired = small_glass();
    start(wired); // 16 bytes
    const auto error = [&wired] { return wired.error().substr(wired.error().find(": ") + 2); };
    SUBCASE("the place")
    {
        CHECK(wired.wait(2).low({0x23}).error() == "byte 16 at 2.000 ms: unknown command 0x23");
    }
    SUBCASE("scrolling")
    {
        wired.low({0x2F});
        CHECK(error() == "command 0x2F is not modelled");
    }
    SUBCASE("parameters missing")
    {
        wired.low({0x21, 5}).high({0});
        CHECK(error() == "data where command 0x21 lacks parameters");
    }
    SUBCASE("parameters with D/C high")
    {
        wired.low({0x21}).high({5, 5});
        CHECK(error() == "data where command 0x21 lacks parameters");
    }
    SUBCASE("columns beyond")
    {
        wired.low({0x21, 0, 128});
        CHECK(error() == "columns 0 to 128: the last one is 127");
    }
    SUBCASE("pages reversed")
    {
        wired.low({0x22, 3, 2});
        CHECK(error() == "rows 3 to 2: reversed");
    }
    SUBCASE("no window")
    {
        wired.low({0x21, 5, 5}).high({0});
        CHECK(error() == "pixels before a window is set");
    }
    SUBCASE("window overrun")
    {
        window(wired, 5, 5, 2, 2).high({0, 0});
        CHECK(error() == "more pixels than the window holds");
    }
    SUBCASE("page overrun")
    {
        WiredModel paged{with_glass(Controller::ssd1306, {128, 64})};
        start(paged, 0xA1, 0xC8, 2).low({0xB0, 0x0F, 0x17}).high({0, 0});
        CHECK(paged.error() == "byte 20 at 0.000 ms: more pixels than the window holds");
    }
    SUBCASE("outside the glass")
    {
        window(wired, 9, 9, 2, 2).high({0});
        CHECK(error() == "a pixel outside the glass: column 9, row 16 of the memory");
    }
    SUBCASE("above the glass")
    {
        window(wired, 5, 5, 1, 1).high({0});
        CHECK(error() == "a pixel outside the glass: column 5, row 8 of the memory");
    }
    SUBCASE("off while the window waits")
    {
        window(wired, 5, 6, 2, 2).high({0}).low({0xAE});
        CHECK(error() == "sleep while the window waits for pixels");
    }
    SUBCASE("a page in horizontal addressing")
    {
        wired.low({0xB0});
        CHECK(error() == "command 0xB0 in horizontal or vertical addressing");
    }
    SUBCASE("a window in page addressing")
    {
        wired.low({0x20, 2, 0x21});
        CHECK(error() == "command 0x21 in page addressing");
    }
    SUBCASE("no such addressing")
    {
        wired.low({0x20, 3});
        CHECK(error() == "there is no addressing 0x03");
    }
    SUBCASE("too few lines")
    {
        wired.low({0xA8, 14});
        CHECK(error() == "the last line is 14: it lies between 15 and 63");
    }
    SUBCASE("display offset")
    {
        wired.low({0xD3, 8});
        CHECK(error() == "a display offset of 8 is not modelled");
    }
    SUBCASE("wiring of the lines")
    {
        wired.low({0xDA, 0x22});
        CHECK(error() == "lines wired like 0x22 are not modelled");
    }
    SUBCASE("wiring of another glass")
    {
        WiredModel high{with_glass(Controller::ssd1306, {128, 64})};
        CHECK(high.low({0xDA, 0x02}).error() ==
              "byte 1 at 0.000 ms: the lines of this glass are not wired like 0x02");
        WiredModel flat{with_glass(Controller::ssd1306, {128, 32})};
        CHECK(flat.low({0xDA, 0x12}).error() ==
              "byte 1 at 0.000 ms: the lines of this glass are not wired like 0x12");
    }
    SUBCASE("the pump while it is needed")
    {
        wired.low({0x8D, 0x10});
        CHECK(error() == "the voltage pump is switched while the display is on");
    }
    SUBCASE("no such pump")
    {
        wired.low({0x8D, 0x04});
        CHECK(error() == "the voltage pump has no setting 0x04");
    }
}

TEST_CASE("SSD1306 model: the start-up is complete before pixels come")
{
    WiredModel wired{with_glass(Controller::ssd1306, {128, 64})};
    SUBCASE("no pump")
    {
        CHECK(wired.low({0xAF}).error() ==
              "byte 0 at 0.000 ms: the display is switched on before the voltage pump");
    }
    SUBCASE("no addressing")
    {
        CHECK(wired.low({0xA8, 63, 0x8D, 0x14, 0xA1, 0xC8, 0xDA, 0x12, 0xAF}).high({0}).error() ==
              "byte 9 at 0.000 ms: pixels before 0x20 was given");
    }
    SUBCASE("no orientation of the lines")
    {
        CHECK(wired.low({0xA8, 63, 0x8D, 0x14, 0xA1, 0x20, 0, 0xDA, 0x12, 0xAF}).high({0}).error() ==
              "byte 10 at 0.000 ms: pixels before 0xC0 was given");
    }
}

}
