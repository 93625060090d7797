#include "host/preview/headless.hpp"

#include "host/program/failure.hpp"
#include "tests/compiled.hpp"
#include "tests/event_bytes.hpp"
#include "tests/host/picture/painted_source.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <sstream>
#include <string>
#include <utility>

namespace kfast::test {
namespace {

PlaybackSetup playback_setup(std::uint32_t rate, const PlayRange& stretch)
{
    static const std::vector<std::byte> events =
        event_bytes({{"begin", Time{0}}, {"late\n", {9 * 1024 + 512}}});
    return {.frame_rate = rate,
            .parts = {{"", stretch}},
            .keys = {Time::frame(0), Time::frame(4)},
            .events = EventCursor{ByteReader{events}}};
}

/// A scene of which only this is seen.
std::unique_ptr<OpenedScene> opened(std::unique_ptr<FrameSource> source, PlaybackSetup playback_setup)
{
    std::vector<std::byte> bytes = compiled("kfast 1\ncanvas 1 1\n");
    const SceneView view = *SceneView::parse(bytes);
    return std::make_unique<OpenedScene>(OpenedScene{.file = "none.kfast",
                                                     .scene = {std::move(bytes), view},
                                                     .source = std::move(source),
                                                     .playback_setup = std::move(playback_setup),
                                                     .panel = {1, 1}});
}

std::unique_ptr<OpenedScene> open_nothing(const std::filesystem::path&) { throw Failure("not\nhere"); }

/// What a script writes.
std::string played(std::unique_ptr<FrameSource> source, const std::string& script)
{
    std::vector<ScriptStep> steps;
    std::istringstream words{script};
    for (std::string word; words >> word;)
        steps.push_back(script_step(word).value());
    Viewer viewer{open_nothing,
                  opened(std::move(source), playback_setup(30000, {{}, Time::frame(10), Loop::repeat})),
                  Viewer::Seconds{0}};
    std::ostringstream out;
    play_script(viewer, steps, out);
    return out.str();
}

PaintedSource numbered(std::vector<int>& shown)
{
    return {{1, 1}, [&shown](int frame, int, int) { return shown.emplace_back(frame); }};
}

}

TEST_CASE("without keys every frame is shown once, at any frame rate")
{
    for (const std::uint32_t rate : {30000U, 23976U, 7U, 1000000U}) {
        std::vector<int> shown;
        PaintedSource source = numbered(shown);
        std::ostringstream out;
        play_headless(source, playback_setup(rate, {{}, Time::frame(5), Loop::once}), out);
        CHECK(shown == std::vector{0, 1, 2, 3, 4, 5});
        CHECK(out.str() == "event 0 begin\n6 frames, hash a2b3bb90\n");
    }
}

TEST_CASE("a script shows what each key leads to and stops at a quit")
{
    std::vector<int> shown;
    const std::string text = played(std::make_unique<PaintedSource>(numbered(shown)), "n right space h q n");
    CHECK(shown == std::vector{4, 5, 5, 6});
    CHECK(text.starts_with("event 0 begin\nframe 4  0.133 s  paused  "));
    CHECK(text.find("frame 6  0.200 s  playing  ") != std::string::npos);
    CHECK(text.find("\n4 frames, hash ") != std::string::npos);
}

TEST_CASE("a script touches the time line, waits and finishes long work")
{
    std::vector<int> shown;
    const std::string text =
        played(std::make_unique<PaintedSource>(numbered(shown)), "frame=7.5 space wait=0.2 a space");
    CHECK(text.find("frame 7  0.250 s  paused  ") != std::string::npos);
    CHECK(text.find("frame 3  0.117 s  playing  ") != std::string::npos);
    CHECK(text.find("notice: 10 frames: space steps, 'a' ends that\n") != std::string::npos);
    CHECK(text.find("paused  all frames  ") != std::string::npos);
}

TEST_CASE("a script tells why a file is not opened")
{
    std::vector<int> shown;
    const std::string text = played(std::make_unique<PaintedSource>(numbered(shown)), "open=other");
    CHECK(text.find("error: not\nerror: here\nframe 0  ") != std::string::npos);
}

TEST_CASE("a script that selects what is not there fails")
{
    std::vector<int> shown;
    CHECK_THROWS_AS(played(std::make_unique<PaintedSource>(numbered(shown)), "select=lamp"), Failure);
}

TEST_CASE("steps of a script are keys, or have a value")
{
    CHECK(script_step("shift-tab")->key == PreviewKey::previous_item);
    CHECK(script_step("frame=12.5")->number == 12.5);
    CHECK(script_step("open=a=b")->text == "a=b");
    CHECK(script_step("select=")->text.empty());
    for (const char* const wrong :
         {"", "7", "frame", "frame=", "frame=x", "frame=-1", "wait=1e3", "wait=inf"})
        CHECK(!script_step(wrong));
}

TEST_CASE("travel is revealed by a key, with the facts of the picture, and hidden by it again")
{
    std::vector<bool> revealed;
    class TravelSource : public PaintedSource {
    public:
        explicit TravelSource(std::vector<bool>& revealed)
            : PaintedSource{{1, 1}, [](int, int, int) { return 0; }}, revealed_{revealed}
        {
        }
        void reveal(bool hidden) override { revealed_.push_back(hidden); }
        std::string facts() const override { return "7 points"; }

    private:
        std::vector<bool>& revealed_;
    };
    const std::string text = played(std::make_unique<TravelSource>(revealed), "space t right t");
    CHECK(revealed == std::vector{false, true, true, false});
    CHECK(text.find("paused  event begin  7 points  ") != std::string::npos);
    CHECK(text.find("7 points") > text.find("paused"));
    CHECK(text.rfind("7 points") < text.rfind("paused"));
}

TEST_CASE("events behind the last frame are passed as well, and written so that they cannot disturb")
{
    std::vector<int> shown;
    PaintedSource source = numbered(shown);
    std::ostringstream out;
    play_headless(source, playback_setup(30000, {{}, Time::frame(10), Loop::repeat}), out);
    CHECK(out.str().starts_with("event 0 begin\nevent 9.5 late<U+000A>\n10 frames, "));
}

TEST_CASE("a speed changes how many frames there are")
{
    std::vector<int> shown;
    PaintedSource source = numbered(shown);
    std::ostringstream out;
    PlaybackSetup fast = playback_setup(30000, {{}, Time::frame(5), Loop::once});
    fast.speed = -2 * Playhead::as_authored;
    play_headless(source, fast, out);
    CHECK(shown == std::vector{5, 3, 1, 0});
}

}
