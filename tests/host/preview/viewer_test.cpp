#include "host/preview/viewer.hpp"

#include "tests/host/preview/opened_scenes.hpp"
#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <fstream>

namespace kfast::test {
namespace {

namespace fs = std::filesystem;

using Seconds = Viewer::Seconds;

/// 10 frames a second and 10 frames; a clip, an input and two objects.
constexpr const char* moving = R"(kfast 1
canvas 16 16 fps=10 frames=10
input gaze min=-1 max=1
clip blink from=4 to=8
object lamp fill="#ff0000" {
    key 0 { rect 0 0 4 4 }
    key 5 { rect 12 12 4 4 }
}
object shade fill="#00ff00" {
    key 0 { rect 8 0 4 4 }
    track x input=gaze { at -1 0; at 1 4 }
}
)";

void write(const fs::path& file, const std::string& text) { std::ofstream{file} << text; }

std::string replaced(std::string text, const std::string& what, const std::string& with)
{
    return text.replace(text.find(what), what.size(), with);
}

/// A viewer of a file in a folder of its own, and its clock.
struct Preview {
    explicit Preview(const std::string& text = moving) { write(folder / "lamp.kfast", text); }

    void press(std::initializer_list<PreviewKey> keys)
    {
        for (const PreviewKey key : keys)
            viewer.press(key, now);
    }
    void finish_work()
    {
        while (viewer.is_working())
            viewer.attend(now);
    }
    /// Long enough for what was written to be noticed.
    void wait(double seconds = 1)
    {
        for (double passed = 0; passed < seconds; passed += 0.1) {
            now += Seconds{0.1};
            viewer.attend(now);
        }
    }
    /// As editors do.
    void replace(const std::string& text)
    {
        write(folder / "lamp.kfast~", text);
        fs::rename(folder / "lamp.kfast~", folder / "lamp.kfast");
    }

    TemporaryFolder folder;
    bool is_written = (write(folder / "lamp.kfast", moving), true);
    Seconds now{1000};
    Viewer viewer{open_scene, open_scene(folder / "lamp.kfast"), now};
};

bool says(const std::vector<std::string>& lines, const std::string& word)
{
    return std::ranges::any_of(lines, [&](const std::string& line) { return line.find(word) != line.npos; });
}

}

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

TEST_CASE("the same notice again is another one")
{
    Preview preview;
    preview.replace(replaced(moving, "rect 12", "rect 11"));
    preview.wait();
    const auto first = preview.viewer.notice_number();
    CHECK(preview.viewer.notice() == "lamp.kfast is read again");
    preview.replace(replaced(moving, "rect 12", "rect 10"));
    preview.wait();
    CHECK(preview.viewer.notice() == "lamp.kfast is read again");
    CHECK(preview.viewer.notice_number() != first);
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

TEST_CASE("zooming closes the help and clears the notice, as keys do")
{
    Preview preview;
    preview.viewer.open(preview.folder / "none.kfast", preview.now);
    preview.press({PreviewKey::screenshot, PreviewKey::all_frames});
    preview.finish_work();
    CHECK(!preview.viewer.notice().empty());
    preview.viewer.set_zoom(2);
    CHECK(preview.viewer.notice().empty());
    preview.press({PreviewKey::help});
    REQUIRE(preview.viewer.playback().help_open());
    preview.viewer.set_zoom(3);
    CHECK_FALSE(preview.viewer.playback().help_open());
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
            scene->tell_drawings = [](ToldInputs&) { throw Failure("too many points"); };
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

TEST_CASE("what is told about a picture belongs to the one that is shown, kept or new, and sound goes along")
{
    /// Tells which picture it shows, and what it accompanies.
    struct Telling : FrameSource {
        explicit Telling(std::vector<int>& heard) : heard_{heard} {}
        const Frame& show(Time moment) override
        {
            shown_ = moment.ticks / Time::ticks_per_frame;
            return frame_;
        }
        void accompany(Time moment) override { heard_.push_back(moment.ticks / Time::ticks_per_frame); }
        std::string facts() const override { return "fact " + std::to_string(shown_); }
        void set_input(std::uint32_t, Time) override {}
        bool set_drawing(std::uint32_t, std::span<const LiveStroke>) override { return true; }
        void set_text(std::uint32_t, std::string_view) override {}

        std::vector<int>& heard_;
        int shown_ = 0;
        Frame frame_{PixelFormat::rgb565, {16, 16}, std::vector<std::byte>(512)};
    };
    Preview preview;
    std::vector<int> heard;
    auto scene = open_scene(preview.folder / "lamp.kfast");
    scene->source = std::make_unique<Telling>(heard);
    Viewer viewer{open_scene, std::move(scene), preview.now};
    for (const PreviewKey key : {PreviewKey::travel, PreviewKey::next_frame, PreviewKey::all_frames})
        viewer.press(key, preview.now);
    while (viewer.is_working())
        viewer.attend(preview.now);
    viewer.press(PreviewKey::play_pause, preview.now);
    viewer.frame();
    CHECK(viewer.status() == "frame 2  0.200 s  paused  fact 2  all frames");
    CHECK(heard == std::vector<int>{2});
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

TEST_CASE("after all frames are generated, space steps through them, until another clip is wanted")
{
    Preview preview;
    preview.press({PreviewKey::all_frames});
    REQUIRE(preview.viewer.is_working());
    preview.viewer.attend(preview.now);
    CHECK(preview.viewer.notice() == "frame 1 of 10: any key stops that");
    preview.finish_work();
    CHECK(preview.viewer.status() == "frame 0  0.000 s  paused  all frames");
    const Frame first = preview.viewer.frame();
    preview.press({PreviewKey::play_pause, PreviewKey::play_pause});
    CHECK(preview.viewer.status() == "frame 2  0.200 s  paused  all frames");
    CHECK(preview.viewer.frame().pixels != first.pixels);
    preview.press({PreviewKey::next_clip});
    CHECK(preview.viewer.status() == "frame 4  0.400 s  playing  clip blink");
}

TEST_CASE("frames that were generated are those that playing shows")
{
    Preview generated;
    Preview played;
    generated.press({PreviewKey::all_frames});
    generated.finish_work();
    for (int frame = 0; frame < 10; ++frame) {
        CHECK(generated.viewer.frame().pixels == played.viewer.frame().pixels);
        generated.press({PreviewKey::play_pause});
        played.press({PreviewKey::next_frame});
    }
}

TEST_CASE("any key stops long work and does nothing else")
{
    for (const PreviewKey work : {PreviewKey::all_frames, PreviewKey::gif}) {
        Preview preview;
        preview.press({work});
        preview.viewer.attend(preview.now);
        preview.press({PreviewKey::quit});
        CHECK(!preview.viewer.is_working());
        CHECK(!preview.viewer.wants_to_quit());
        CHECK(preview.viewer.notice().starts_with("stopped"));
        CHECK(preview.folder.entries() == 1);
        preview.press({PreviewKey::play_pause});
        CHECK(preview.viewer.status().find("all frames") == std::string::npos);
    }
}

TEST_CASE("more frames than memory should hold are refused")
{
    Preview preview{replaced(replaced(moving, "16 16", "1024 1024"), "frames=10", "frames=600")};
    preview.viewer.open(preview.folder / "lamp.kfast", preview.now);
    preview.press({PreviewKey::all_frames});
    CHECK(!preview.viewer.is_working());
    CHECK(preview.viewer.notice().find("600 frames would need 1200 MB") == 0);
}

TEST_CASE("pictures are written beside the scene and never over another file")
{
    Preview preview;
    preview.press({PreviewKey::next_frame, PreviewKey::screenshot});
    CHECK(preview.viewer.notice().ends_with("lamp-0001.png is written"));
    const std::string first = content(preview.folder / "lamp-0001.png");
    CHECK(first.starts_with("\x89PNG"));
    preview.press({PreviewKey::onion_skin, PreviewKey::screenshot});
    CHECK(preview.viewer.notice().ends_with("lamp-0001-2.png is written"));
    CHECK(content(preview.folder / "lamp-0001-2.png") == first);
    preview.press({PreviewKey::next_clip, PreviewKey::gif});
    preview.finish_work();
    CHECK(preview.viewer.notice().ends_with("lamp-blink.gif is written"));
    CHECK(content(preview.folder / "lamp-blink.gif").starts_with("GIF89a"));
    CHECK(preview.folder.entries() == 4);
}

TEST_CASE("objects are selected one after another, and none behind the last")
{
    Preview preview;
    std::vector<std::string> names;
    for (int i = 0; i < 3; ++i) {
        preview.press({PreviewKey::next_item});
        names.emplace_back(preview.viewer.selected_name());
    }
    CHECK(names == std::vector<std::string>{"shade", "lamp", ""});
    preview.press({PreviewKey::previous_item});
    CHECK(preview.viewer.status().find("  selected lamp") != std::string::npos);
}

TEST_CASE("touching the time line pauses there, and outside of a clip leaves it")
{
    Preview preview;
    preview.press({PreviewKey::next_clip});
    preview.viewer.scrub(Time::frame(6));
    CHECK(preview.viewer.status() == "frame 6  0.600 s  paused  clip blink");
    preview.viewer.scrub(Time::frame(9));
    CHECK(preview.viewer.status() == "frame 9  0.900 s  paused");
    preview.viewer.scrub(Time::frame(100));
    CHECK(preview.viewer.playback().time() == Time::frame(10));
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

TEST_CASE("closing the window ends it, work or not")
{
    Preview preview;
    preview.press({PreviewKey::gif});
    preview.viewer.close();
    CHECK(preview.viewer.wants_to_quit());
    CHECK(preview.folder.entries() == 1);
}

}
