#include "host/commands/render/preview_opener.hpp"

#include "host/preview/viewer/opened_scene.hpp"
#include "host/program/failure.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <fstream>

namespace kfast::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* plotting = R"(kfast 1
canvas 64 32 frames=10
clip blink from=2 to=4
input gaze
input plot kind=drawing points=4
object trace stroke=lime width=2 live=plot { track x input=gaze { at 0 0; at 1 9 } }
)";

constexpr const char* plain = "kfast 1\ncanvas 64 32 frames=10\nobject o fill=red { rect 0 0 9 9 }\n";

constexpr const char* my_board = R"(board mine {
    core cortex-m0+ clock=(MHz)48
    memory flash=(KiB)256 ram=(KiB)32
    bus spi clock=(MHz)10
    panel ssd1306 128 64
}
)";

struct Folder {
    Folder()
    {
        write("plot.kfast", plotting);
        write("plain.kfast", plain);
        write("points.txt", "1,1 30,30");
    }

    void write(const char* name, const std::string& text) { std::ofstream{folder / name} << text; }
    std::string path(const char* name) { return (folder / name).string(); }
    PreviewChoice all_named()
    {
        PreviewChoice choice;
        choice.play.clip = "blink";
        choice.picture.inputs.texts = {"gaze=0.5"};
        choice.picture.drawings.texts = {"plot=" + path("points.txt")};
        return choice;
    }

    TemporaryFolder folder;
};

bool has_changed(FileWatch watch)
{
    bool changed = false;
    for (double now = 0; now < 3; now += 0.1)
        changed = watch.has_changed(FileWatch::Seconds{now}) || changed;
    return changed;
}

std::size_t lit(const Frame& frame)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(frame.pixels, [](std::byte value) { return value != std::byte{}; }));
}

std::unique_ptr<OpenedScene> opened(Folder& folder, const PreviewChoice& choice)
{
    return PreviewOpener{choice}.open_first(folder.path("plain.kfast"));
}

}

TEST_CASE("a mistake in a drawing is a mistake, whatever is known, and no reason to leave options out")
{
    Folder folder;
    PreviewOpener opener{folder.all_named()};
    opener.open_first(folder.path("plot.kfast"));
    folder.write("points.txt", "1,x");
    try {
        opener.open_next(folder.path("plot.kfast"));
        FAIL("opened");
    } catch (const Failure& failure) {
        CHECK(std::string{failure.what()}.find("is no point") != std::string::npos);
    }
    folder.write("points.txt", "1,1 2,2 3,3 4,4 5,5");
    CHECK_THROWS_AS(opener.open_next(folder.path("plot.kfast")), Failure);
    folder.write("points.txt", "1,1 9,9");
    CHECK(opener.open_next(folder.path("plot.kfast"))->warnings.empty());
}

TEST_CASE("what was not opened for a mistake in a drawing may be once the drawing has changed")
{
    Folder folder;
    folder.write("points.txt", "1,x");
    PreviewOpener opener{folder.all_named()};
    try {
        opener.open_next(folder.path("plot.kfast"));
        FAIL("opened");
    } catch (const OpeningFailed& failure) {
        CHECK_FALSE(has_changed(failure.read()));
        folder.write("points.txt", "1,1 9,9");
        CHECK(has_changed(failure.read()));
    }
}

TEST_CASE("for somebody who watches, a first text with mistakes is an empty scene that tells them")
{
    Folder folder;
    folder.write("plot.kfast", "kfast 1\ncanvas 64 32\nobjekt o\n");
    PreviewOpener opener{folder.all_named()};
    const auto somebody = [] { return true; };
    const auto empty = opener.open_first(folder.path("plot.kfast"), somebody);
    CHECK(empty->mistakes.find("plot.kfast:3:") != std::string::npos);
    CHECK(empty->mistakes.ends_with("plot.kfast: 1 error"));
    CHECK(empty->file == folder.path("plot.kfast"));
    CHECK(empty->panel == Size{240, 240});
    CHECK(lit(empty->source->show(Time{0})) == 0);
    folder.write("plot.kfast", plotting);
    CHECK(has_changed(empty->read));
    const auto mended = opener.open_next(folder.path("plot.kfast"));
    CHECK(mended->mistakes.empty());
    CHECK(mended->playback_setup.first == 1); // that --clip names
}

TEST_CASE("a first text with mistakes is refused where nobody watches, and what is no text always")
{
    Folder folder;
    folder.write("bad.kfast", "kfast 1\ncanvas 64 32\nobjekt o\n");
    folder.write("rubbish.kfb", "KFB rubbish");
    PreviewOpener opener{{}};
    CHECK_THROWS_AS(opener.open_first(folder.path("bad.kfast")), Failure);
    const auto somebody = [] { return true; };
    CHECK_THROWS_AS(opener.open_first(folder.path("rubbish.kfb"), somebody), Failure);
    CHECK_THROWS_AS(opener.open_first(folder.path("nowhere.kfast"), somebody), Failure);
    PreviewChoice wrong;
    wrong.board = "nothing";
    CHECK_THROWS_AS(PreviewOpener{wrong}.open_first(folder.path("bad.kfast"), somebody), Failure);
}

TEST_CASE("only the names that a scene has not are left out")
{
    Folder folder;
    PreviewOpener opener{folder.all_named()};
    folder.write("part.kfast", "kfast 1\ncanvas 64 32 frames=10\ninput gaze\n"
                               "object o fill=red { rect 0 0 9 9; track x input=gaze { at 0 0; at 1 9 } }\n");
    const auto part = opener.open_next(folder.path("part.kfast"));
    CHECK(part->playback_setup.inputs.front().value == 500);
    CHECK(part->playback_setup.first == 0);
    CHECK(part->warnings.find("there is no clip 'blink'") != std::string::npos);
    CHECK(part->warnings.find("there is no drawing 'plot'") != std::string::npos);
    CHECK(part->warnings.find("gaze") == std::string::npos);
    CHECK(opener.open_next(folder.path("plot.kfast"))->playback_setup.first == 1);
}

TEST_CASE("a drawing is read once, for the picture and for all that is laid over it")
{
    Folder folder;
    PreviewOpener opener{folder.all_named()};
    const auto scene = opener.open_first(folder.path("plot.kfast"));
    fs::remove(folder.folder / "points.txt");
    SceneLayers layers{*scene};
    CHECK(lit(scene->source->show(Time{0})) > 40);
    const PreviewPlayback playback{scene->playback_setup, Pace::smooth, PreviewPlayback::Seconds{0}};
    CHECK(layers.item_at(playback, {19.5, 15.5}).has_value()); // moved by the input
}

TEST_CASE("the display of the report and of the changed areas is the one that is shown")
{
    Folder folder;
    folder.write("mine.kdl", my_board);

    PreviewChoice choice;
    CHECK(opened(folder, choice)->board->display.name == "st7789");
    CHECK(opened(folder, choice)->board->display.size == Size{64, 32});

    choice.picture.size = Size{100, 50};
    choice.picture.format = PixelFormat::mono1;
    const auto mono = opened(folder, choice);
    CHECK(mono->board->display.name == "ssd1306");
    CHECK(mono->board->display.format == PixelFormat::mono1);
    CHECK(mono->board->display.size == Size{100, 50});
    CHECK(mono->board->name == "pico");

    choice = {};
    choice.board = folder.path("mine.kdl");
    const auto own = opened(folder, choice);
    CHECK(own->board->name == "mine");
    CHECK(own->panel == Size{128, 64});
    CHECK(own->source->show(Time{0}).format == own->board->display.format);
    CHECK(own->panel_name == "ssd1306");

    choice.picture.panel = &*std::ranges::find(panel_choices(), "gc9a01", &PanelChoice::name);
    const auto round = opened(folder, choice);
    CHECK(round->board->name == "mine");
    CHECK(round->board->display.name == "gc9a01");
    CHECK(round->board->display.size == round->panel);
    CHECK(round->is_round);
    CHECK_FALSE(own->is_round);

    choice = {};
    choice.board = folder.path("mine.kdl");
    choice.picture.size = Size{40, 40};
    CHECK(opened(folder, choice)->board->display.size == Size{40, 40});
    CHECK(opened(folder, choice)->board->display.format == PixelFormat::mono1);
}

TEST_CASE("changed areas are those that the board sends")
{
    Folder folder;
    folder.write("mine.kdl", my_board);
    PreviewChoice choice;
    choice.board = folder.path("mine.kdl");
    const auto scene = opened(folder, choice);
    SceneLayers layers{*scene};
    const PreviewPlayback playback{scene->playback_setup, Pace::smooth, PreviewPlayback::Seconds{0}};
    const std::string facts = layers.overlay(playback, {.changed_areas = true}, 1).facts;
    CHECK(facts.find("1 area, 1030 bytes, 100 %") == 0); // 1024 of pixels, a bit for each
}

TEST_CASE("a beam that is shown is judged, and only by a board that has one")
{
    Folder folder;
    PreviewChoice choice;
    choice.picture.screen.beam = chosen_beam("galvo");
    CHECK(opened(folder, choice)->board->beam == galvo_profile);
    choice.board = "pico";
    CHECK_THROWS_WITH_AS(
        opened(folder, choice),
        "--beam: the board pico has a panel, not a beam: leave out --beam, or choose a board "
        "with one, like pico-xy",
        Failure);
    choice.board = "pico-xy";
    CHECK(opened(folder, choice)->board->beam == galvo_profile);
    choice.picture.screen.beam.reset();
    CHECK(opened(folder, choice)->is_beam);
    CHECK(opened(folder, choice)->board->beam == scope_profile);
    choice.picture.panel = &panel_choices().front();
    CHECK_THROWS_AS(opened(folder, choice), Failure);
}

TEST_CASE("all files are watched that what is shown depends on")
{
    Folder folder;
    folder.write("mine.kdl", my_board);
    folder.write("beam.kdl", "beam scope rate=(kHz)90\n");
    PreviewChoice choice = folder.all_named();
    choice.board = folder.path("mine.kdl");
    PreviewOpener opener{choice};
    for (const char* const name : {"plot.kfast", "mine.kdl", "points.txt"}) {
        const auto scene = opener.open_next(folder.path("plot.kfast"));
        CHECK_FALSE(has_changed(scene->read));
        fs::last_write_time(folder.folder / name, fs::file_time_type::clock::now() + std::chrono::hours{1});
        CHECK(has_changed(scene->read));
    }
    fs::copy_file("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", folder.folder / "Sans.ttf");
    folder.write("text.kfast", "kfast 1\ncanvas 64 32\n"
                               "object o fill=red { text \"I\" at=\"9,20\" size=9 font=\"Sans.ttf\" }\n"
                               "object p fill=red { text \"I\" at=\"9,20\" size=9 font=hershey-sans }\n");
    const auto text = PreviewOpener{{}}.open_first(folder.path("text.kfast"));
    CHECK(text->scene.fonts == std::vector{folder.folder / "Sans.ttf"});
    fs::last_write_time(folder.folder / "Sans.ttf", fs::file_time_type::clock::now() + std::chrono::hours{1});
    CHECK(has_changed(text->read));

    PreviewChoice beam;
    beam.picture.screen.beam = chosen_beam(folder.path("beam.kdl"));
    PreviewOpener of_beam{beam};
    const auto scene = of_beam.open_first(folder.path("plain.kfast"));
    folder.write("beam.kdl", "beam scope rate=(kHz)80  // less\n");
    CHECK(has_changed(scene->read));
    CHECK(of_beam.open_next(folder.path("plain.kfast"))->board->beam->rate == 80'000);
}

TEST_CASE("a mistake in the description of a board is told with its place")
{
    Folder folder;
    folder.write("mine.kdl", my_board);
    PreviewChoice choice;
    choice.board = folder.path("mine.kdl");
    PreviewOpener opener{choice};
    folder.write("mine.kdl", "board mine { bus }\n");
    try {
        opener.open_next(folder.path("plain.kfast"));
        FAIL("opened");
    } catch (const Failure& failure) {
        CHECK(std::string{failure.what()}.find("mine.kdl:1:") != std::string::npos);
    }
}

}
