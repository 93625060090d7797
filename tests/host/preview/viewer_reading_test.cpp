#include "host/preview/viewer/viewer.hpp"

#include "tests/host/preview/watched_preview.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("a saved file goes on at the same moment, clip and speed, with what was turned and selected")
{
    Preview preview;
    preview.press({PreviewKey::next_clip, PreviewKey::faster, PreviewKey::more_input, PreviewKey::next_frame,
                   PreviewKey::next_item, PreviewKey::bones, PreviewKey::loop});
    const std::string before = preview.viewer.status();
    CHECK(before.find("frame 5  0.500 s  paused  speed 2  loop always  clip blink  gaze 0.1") == 0);
    const std::string selected{preview.viewer.selected_name()};
    CHECK(!selected.empty());

    preview.replace(replaced(moving, "object lamp",
                             "object first fill=\"#0000ff\" { key 0 { rect 0 0 1 1 } }\nobject lamp"));
    preview.wait();
    CHECK(preview.viewer.errors().empty());
    CHECK(preview.viewer.time_table().rows.size() == 3);
    CHECK(preview.viewer.status() == before);
    CHECK(preview.viewer.selected_name() == selected);
    CHECK(preview.viewer.notice() == "lamp.kfast is read again");
}

TEST_CASE("of several items with one name, the same one stays selected")
{
    const std::string twins = "kfast 1\ncanvas 16 16\nsymbol lamp { object bulb fill=red { rect 0 0 4 4 } }\n"
                              "use lamp { key 0 x=0 }\nuse lamp { key 0 x=8 }\n";
    Preview preview{twins};
    preview.viewer.open(preview.folder / "lamp.kfast", preview.now);
    const auto rows = preview.viewer.time_table().rows;
    REQUIRE(std::ranges::count(rows, rows.front().name, &TimeRow::name) == 2);
    int side = 5;
    for (const TimeRow& row : rows) {
        preview.viewer.select(row.item);
        preview.replace(replaced(twins, "rect 0 0 4 4", "rect 0 0 4 " + std::to_string(side++)));
        preview.wait();
        CHECK(preview.viewer.notice() == "lamp.kfast is read again");
        CHECK(preview.viewer.view().selected == row.item);
    }
    const auto second = std::ranges::find(rows.rbegin(), rows.rend(), rows.front().name, &TimeRow::name);
    preview.viewer.select(second->item);
    preview.replace(replaced(twins, "use lamp { key 0 x=8 }\n", ""));
    preview.wait();
    CHECK_FALSE(preview.viewer.view().selected.has_value()); // there is no second one any more
}

TEST_CASE("what is saved while the scene is read for the first time is read again")
{
    TemporaryFolder folder;
    const fs::path file = folder / "lamp.kfast";
    write(file, moving);
    auto scene = open_scene(file);
    write(file, replaced(moving, "frames=10", "frames=20"));
    Viewer viewer{open_scene, std::move(scene), Seconds{0}};
    for (double now = 0; now < 1; now += 0.1)
        viewer.attend(Seconds{now});
    CHECK(viewer.playback().stretch().end == Time::frame(20));
}

TEST_CASE("a scene of which the layers cannot be made leaves what is open whole")
{
    bool fails = false;
    const Opener opener = [&fails](const fs::path& file) {
        auto scene = open_scene(file);
        if (fails)
            scene->apply_drawings = [](InputReceiver&) { throw Failure("too many points"); };
        return scene;
    };
    Preview preview;
    Viewer viewer{opener, opener(preview.folder / "lamp.kfast"), preview.now};
    viewer.select(1);
    viewer.press(PreviewKey::next_frame, preview.now);
    const std::string before = viewer.status();
    const Frame good = viewer.frame();
    fails = true;
    viewer.open(preview.folder / "lamp.kfast", preview.now);
    CHECK(viewer.errors() == std::vector<std::string>{"too many points"});
    CHECK(viewer.status() == before);
    CHECK(viewer.frame().pixels == good.pixels);
    CHECK(viewer.item_at({11.5, 1.5}).has_value());
    CHECK(viewer.time_table().rows.size() == 2);
}

TEST_CASE("a file that was not opened for a mistake elsewhere is opened once that is mended")
{
    Preview preview;
    const fs::path points = preview.folder / "points.txt";
    write(points, "bad");
    const Opener opener = [&](const fs::path& file) {
        const FileWatch read{{file, points}};
        if (fs::file_size(points) == 3)
            throw OpeningFailed("there is no point", read);
        return open_scene(file);
    };
    write(preview.folder / "other.kfast", replaced(moving, "frames=10", "frames=20"));
    Viewer viewer{opener, open_scene(preview.folder / "lamp.kfast"), preview.now};
    viewer.open(preview.folder / "other.kfast", preview.now);
    CHECK(viewer.errors() == std::vector<std::string>{"there is no point"});
    write(points, "1,1 2,2");
    for (double passed = 0; passed < 1; passed += 0.1)
        viewer.attend(preview.now + Seconds{passed});
    CHECK(viewer.errors().empty());
    CHECK(viewer.playback().stretch().end == Time::frame(20));
}

TEST_CASE("a mistake is shown with its place while the last good scene goes on, until it is mended")
{
    Preview preview;
    preview.press({PreviewKey::next_frame});
    const Frame good = preview.viewer.frame();
    preview.replace(replaced(moving, "rect 12", "recct 12"));
    preview.wait();
    CHECK(says(preview.viewer.errors(), "lamp.kfast:7:"));
    CHECK(says(preview.viewer.errors(), "did you mean"));
    CHECK(preview.viewer.frame().pixels == good.pixels);

    preview.replace(replaced(moving, "#ff0000", "#0000ff"));
    preview.wait();
    CHECK(preview.viewer.errors().empty());
    CHECK(preview.viewer.frame().pixels != good.pixels);
    CHECK(preview.viewer.playback().frame() == 1);
}

TEST_CASE("a clip or an object that is gone is left, and an input stays within its new range")
{
    Preview preview;
    preview.press({PreviewKey::next_clip, PreviewKey::more_input, PreviewKey::next_frame});
    preview.viewer.select(0);
    preview.replace("kfast 1\ncanvas 16 16 fps=10 frames=2\ninput gaze min=-1 max=0.05\n"
                    "object other fill=\"#ff0000\" { key 0 { rect 0 0 4 4 }\n"
                    "track x input=gaze { at -1 0; at 0.05 4 } }\n");
    preview.wait();
    REQUIRE(preview.viewer.errors().empty());
    CHECK(preview.viewer.status() == "frame 2  0.200 s  paused  gaze 0.05");
}

TEST_CASE("an input that nobody turned follows the file")
{
    Preview preview;
    preview.press({PreviewKey::next_input, PreviewKey::next_frame});
    preview.replace(replaced(moving, "max=1", "max=1 default=0.5"));
    preview.wait();
    REQUIRE(preview.viewer.errors().empty());
    CHECK(preview.viewer.status() == "frame 1  0.100 s  paused  gaze 0.5");
}

TEST_CASE("a file that is empty or gone for a moment is no error, and one that stays so is")
{
    Preview preview;
    write(preview.folder / "lamp.kfast", "");
    preview.wait(1);
    CHECK(preview.viewer.errors().empty());
    preview.wait(1.5);
    CHECK(says(preview.viewer.errors(), "empty"));
    fs::remove(preview.folder / "lamp.kfast");
    preview.wait(2.5);
    CHECK(says(preview.viewer.errors(), "no such file"));
    preview.replace(moving);
    preview.wait();
    CHECK(preview.viewer.errors().empty());
}

TEST_CASE("reading a file begins afresh")
{
    Preview preview;
    preview.press({PreviewKey::next_frame, PreviewKey::next_item, PreviewKey::faster, PreviewKey::read_file});
    CHECK(preview.viewer.status() == "frame 0  0.000 s  playing");
    CHECK(!preview.viewer.playback().help_open());
}

TEST_CASE("a file that cannot be opened leaves what is open, and is opened once it is mended")
{
    Preview preview;
    const fs::path other = preview.folder / "other.kfast";
    write(other, "kfast 1\n");
    preview.press({PreviewKey::next_frame});
    preview.viewer.open(other, preview.now);
    CHECK(says(preview.viewer.errors(), "other.kfast"));
    CHECK(preview.viewer.scene().file.filename() == "lamp.kfast");
    CHECK(preview.viewer.playback().frame() == 1);
    write(other, "kfast 1\ncanvas 8 8\n");
    preview.wait();
    CHECK(preview.viewer.errors().empty());
    CHECK(preview.viewer.scene().file == other);
    CHECK(preview.viewer.frame().size == Size{8, 8});
}

TEST_CASE("mistakes in the first text are shown until they are mended, and then it begins")
{
    Preview preview;
    const fs::path file = preview.folder / "bad.kfast";
    write(file, "kfast 1\ncanvas 240 240\n");
    auto empty = open_scene(file);
    empty->mistakes = "bad.kfast:3:1: error: what?\nbad.kfast: 1 error";
    Viewer viewer{open_scene, std::move(empty), preview.now};
    const auto wait = [&] {
        const Seconds end = preview.now + Seconds{1};
        for (; preview.now < end; preview.now += Seconds{0.1})
            viewer.attend(preview.now);
    };
    wait();
    CHECK(viewer.errors().size() == 2);
    CHECK(viewer.notice().empty());
    write(file, "kfast 1\nnonsense\n");
    wait();
    CHECK(says(viewer.errors(), "nonsense"));
    CHECK(viewer.frame().size == Size{240, 240});
    write(file, moving);
    wait();
    CHECK(viewer.errors().empty());
    CHECK(viewer.scene().file == file);
    CHECK(viewer.frame().size == Size{16, 16});
    CHECK(viewer.playback().playing());
    viewer.press(PreviewKey::next_frame, preview.now);
    write(file, replaced(moving, "rect 12", "rect 11"));
    wait();
    CHECK(viewer.notice() == "bad.kfast is read again");
    CHECK_FALSE(viewer.playback().playing());
}

TEST_CASE("folders and rubbish are refused")
{
    Preview preview;
    write(preview.folder / "rubbish.kfb", std::string{"KFB\x01rubbish\0\xff", 13});
    for (const char* const name : {"", "rubbish.kfb"}) {
        preview.viewer.open(preview.folder / name, preview.now);
        CHECK(preview.viewer.errors().size() == 1);
        CHECK(preview.viewer.scene().file.filename() == "lamp.kfast");
    }
}

TEST_CASE("a dialogue's answer is opened when it comes")
{
    struct Chooser : FileChooser {
        explicit Chooser(fs::path file) : file_{std::move(file)} {}
        void ask(const fs::path&) override { asks_ = true; }
        bool is_asking() const override { return asks_; }
        std::optional<fs::path> take_answer() override
        {
            if (++waited_ < 3)
                return std::nullopt;
            asks_ = false;
            return file_;
        }
        fs::path file_;
        bool asks_ = false;
        int waited_ = 0;
    };
    Preview preview;
    write(preview.folder / "other.kfast", "kfast 1\ncanvas 8 8\n");
    preview.viewer.let_choose(std::make_unique<Chooser>(preview.folder / "other.kfast"));
    preview.press({PreviewKey::read_file});
    CHECK(preview.viewer.notice() == "choose a file in the dialogue");
    preview.wait(0.2);
    CHECK(preview.viewer.scene().file.filename() == "lamp.kfast");
    preview.wait(0.2);
    CHECK(preview.viewer.scene().file.filename() == "other.kfast");
}

TEST_CASE("where nobody can be asked the notice says what helps")
{
    struct Nobody : FileChooser {
        void ask(const fs::path&) override { throw Failure("install one"); }
        bool is_asking() const override { return false; }
        std::optional<fs::path> take_answer() override { return std::nullopt; }
    };
    Preview preview;
    preview.viewer.let_choose(std::make_unique<Nobody>());
    preview.press({PreviewKey::read_file});
    CHECK(preview.viewer.notice() == "install one");
}

TEST_CASE("a dialogue that fails is told in the notice")
{
    struct Broken : FileChooser {
        void ask(const fs::path&) override { asks_ = true; }
        bool is_asking() const override { return asks_; }
        std::optional<fs::path> take_answer() override
        {
            asks_ = false;
            throw Failure("it failed: drop the file here");
        }
        bool asks_ = false;
    };
    Preview preview;
    preview.viewer.let_choose(std::make_unique<Broken>());
    preview.press({PreviewKey::read_file});
    CHECK(preview.viewer.attend(preview.now));
    CHECK(preview.viewer.notice() == "it failed: drop the file here");
    CHECK(preview.viewer.scene().file.filename() == "lamp.kfast");
}

}
