#include "host/preview/viewer/beside.hpp"

#include "host/picture/png.hpp"
#include "host/preview/files/panel_pictures.hpp"
#include "host/preview/terminal/terminal_text.hpp"
#include "host/preview/window/preview_screen.hpp"
#include "host/program/failure.hpp"
#include "tests/host/preview/opened_scenes.hpp"
#include "tests/host/preview/recording_painter.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <fstream>
#include <memory>
#include <string>

namespace kfast::test {
namespace {

constexpr Size panel{20, 10};
constexpr const char* moving_dot = R"(kfast 1
canvas 20 10 fps=10 frames=10
object dot fill="#ffffff" { key 0 { rect 0 0 4 4 }; key 9 { rect 16 0 4 4 } }
)";

Picture plain(Size size, Colour colour)
{
    return {size, std::vector(static_cast<std::size_t>(size.width * size.height), colour)};
}

constexpr Colour red{255, 0, 0};
constexpr Colour blue{0, 0, 255};

/// A preview beside which pictures of another panel are shown.
struct Compared {
    Compared() { std::ofstream{folder / "dot.kfast"} << moving_dot; }

    void shows(const char* name, const Picture& picture) { write_png(folder / name, picture); }
    Viewer viewer()
    {
        auto scene = open_scene(folder / "dot.kfast");
        scene->beside = std::make_shared<PanelPictures>(folder / ".", panel);
        return Viewer{open_scene, std::move(scene), Viewer::Seconds{0}, 1};
    }
    /// What the preview itself shows at a frame.
    Picture at(int frame)
    {
        const auto scene = open_scene(folder / "dot.kfast");
        return widen(scene->source->show(Time::frame(frame)));
    }

    TemporaryFolder folder;
};

}

TEST_CASE("another panel shows the latest picture that it has for a frame")
{
    Compared with;
    with.shows("0002.png", plain(panel, red));
    with.shows("5.png", plain(panel, blue));
    std::ofstream{with.folder / "notes.txt"} << "no picture";
    with.shows("cover.png", plain({3, 3}, blue));
    const PanelPictures pictures{with.folder / ".", panel};
    CHECK(pictures.at(0).at(0, 0) == red);
    CHECK(pictures.at(4).at(0, 0) == red);
    CHECK(pictures.at(5).at(0, 0) == blue);
    CHECK(pictures.at(99).at(0, 0) == blue);
}

TEST_CASE("pictures that cannot be compared are refused with the remedy")
{
    Compared with;
    const auto reason = [&] {
        try {
            const PanelPictures pictures{with.folder / ".", panel};
        } catch (const Failure& failure) {
            return std::string{failure.what()};
        }
        return std::string{};
    };
    CHECK(reason().find("has no pictures 0000.png") != std::string::npos);
    with.shows("0000.png", plain({40, 20}, red));
    CHECK(reason().find("has 40x20 pixels and the panel of the preview 20x10") != std::string::npos);
    std::ofstream{with.folder / "0000.png"} << "kfast 1";
    CHECK(reason().find("0000.png is no PNG") != std::string::npos);
    CHECK_THROWS_AS((PanelPictures{with.folder / "nowhere", panel}), Failure);
}

TEST_CASE("the caption says whether both show the same, frame by frame")
{
    Compared with;
    with.shows("0000.png", with.at(0));
    Picture other = with.at(3);
    other.pixels[0] = red;
    with.shows("0003.png", other);
    other.pixels[1] = red;
    with.shows("0004.png", other);
    Viewer viewer = with.viewer();
    CHECK(beside(viewer)->caption == "board: the same picture");
    viewer.scrub(Time::frame(3));
    CHECK(beside(viewer)->caption == "board: 1 pixel differs");
    CHECK(beside(viewer)->picture.pixels[0] == red);
    viewer.scrub(Time::frame(4));
    CHECK(beside(viewer)->caption.find(" pixels differ") != std::string::npos);
}

TEST_CASE("a scene without pictures of another panel has nothing beside it")
{
    Compared with;
    Viewer viewer{open_scene, open_scene(with.folder / "dot.kfast"), Viewer::Seconds{0}, 1};
    CHECK(!beside(viewer));
}

TEST_CASE("a terminal shows both pictures, each above its caption")
{
    const Picture left = plain({20, 4}, red);
    const Picture right = plain({20, 4}, blue);
    const TerminalText drawn =
        terminal_text({left, "frame 0", "", {}, nullptr, &right, "board: the same picture"}, {80, 24},
                      TerminalColours::true_colour);
    CHECK(drawn.lines == 5);
    CHECK(drawn.text.find("this computer           board: the same picture\x1b[K\n") != std::string::npos);
    CHECK(drawn.text.find("\x1b[38;2;255;0;0m") < drawn.text.find("\x1b[38;2;0;0;255m"));
}

TEST_CASE("in a narrow terminal both are shrunk, and any is large enough")
{
    const Picture left = plain({128, 64}, red);
    const Picture right = plain({128, 64}, blue);
    const TerminalContent content{left, "frame 0", "", {}, nullptr, &right, "board: the same picture"};
    const TerminalText drawn = terminal_text(content, {80, 24}, TerminalColours::none);
    CHECK(drawn.lines <= 23);
    const std::size_t line = drawn.text.find("this computer");
    const std::size_t column = drawn.text.find("board: ") - line;
    CHECK(column >= 40);
    CHECK(column <= 42);
    for (int width = 1; width < 6; ++width)
        for (int height = 1; height < 6; ++height)
            CHECK(terminal_text(content, {width, height}, TerminalColours::none).lines > 0);
}

TEST_CASE("the window divides its room between both")
{
    Compared with;
    with.shows("0000.png", with.at(0));
    Viewer viewer = with.viewer();
    PreviewScreen screen;
    RecordingPainter painter{{900, 600}};
    screen.draw(painter, viewer, Viewer::Seconds{0});
    REQUIRE(painter.pictures.size() == 2);
    const Rect& here = painter.pictures[0];
    const Rect& there = painter.pictures[1];
    CHECK(right_of(here) <= 450);
    CHECK(there.x >= 450);
    CHECK(here.width == there.width);
    CHECK(here.y == there.y);
    const auto* const caption = painter.find("board: the same picture");
    REQUIRE(caption != nullptr);
    CHECK(caption->place.x >= 450);
    CHECK(painter.find("this computer") != nullptr);
}

}
