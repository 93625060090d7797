#include "host/preview/viewer/viewer.hpp"

#include "tests/host/preview/watched_preview.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

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

TEST_CASE("what is told about a picture belongs to the one that is shown, kept or new, and sound goes along")
{
    /// Tells which picture it shows, and what it accompanies.
    struct RecordingSource : FrameSource {
        explicit RecordingSource(std::vector<int>& heard) : heard_{heard} {}
        const Frame& show(Time moment) override
        {
            shown_ = moment.ticks / Time::ticks_per_frame;
            return frame_;
        }
        void accompany(Time moment) override { heard_.push_back(moment.ticks / Time::ticks_per_frame); }
        std::string facts() const override { return "fact " + std::to_string(shown_); }
        bool set(std::uint32_t, const InputContent&) override { return true; }

        std::vector<int>& heard_;
        int shown_ = 0;
        Frame frame_{PixelFormat::rgb565, {16, 16}, std::vector<std::byte>(512)};
    };
    Preview preview;
    std::vector<int> heard;
    auto scene = open_scene(preview.folder / "lamp.kfast");
    scene->source = std::make_unique<RecordingSource>(heard);
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

TEST_CASE("closing the window ends it, work or not")
{
    Preview preview;
    preview.press({PreviewKey::gif});
    preview.viewer.close();
    CHECK(preview.viewer.wants_to_quit());
    CHECK(preview.folder.entries() == 1);
}

}
