#include "host/preview/headless.hpp"

#include "tests/event_bytes.hpp"
#include "tests/host/picture/painted_source.hpp"

#include <doctest/doctest.h>

#include <sstream>

namespace kfast::test {
namespace {

Programme programme(std::uint32_t rate, const Stretch& stretch)
{
    static const std::vector<std::byte> events =
        event_bytes({{"begin", Time{0}}, {"late\n", {9 * 1024 + 512}}});
    return {.frame_rate = rate,
            .parts = {{"", stretch}},
            .keys = {Time::frame(0), Time::frame(4)},
            .events = EventCursor{ByteReader{events}}};
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
        play_headless(source, programme(rate, {{}, Time::frame(5), Loop::once}), out);
        CHECK(shown == std::vector{0, 1, 2, 3, 4, 5});
        CHECK(out.str() == "event 0 begin\n6 frames, hash a2b3bb90\n");
    }
}

TEST_CASE("a script shows what each key leads to and stops at a quit")
{
    std::vector<int> shown;
    PaintedSource source = numbered(shown);
    std::ostringstream out;
    const std::vector script{PreviewKey::next_key, PreviewKey::next_frame, PreviewKey::play_pause,
                             PreviewKey::help,     PreviewKey::quit,       PreviewKey::next_key};
    play_script(source, programme(30000, {{}, Time::frame(10), Loop::repeat}), script, out);
    CHECK(shown == std::vector{4, 5, 5, 6});
    CHECK(out.str().starts_with("event 0 begin\nframe 4  0.133 s  paused  "));
    CHECK(out.str().find("frame 6  0.200 s  playing  ") != std::string::npos);
    CHECK(out.str().find("\n4 frames, hash ") != std::string::npos);
}

TEST_CASE("travel is revealed by a key, with the facts of the picture, and hidden by it again")
{
    class TravelSource : public PaintedSource {
    public:
        using PaintedSource::PaintedSource;
        void reveal(bool hidden) override { revealed.push_back(hidden); }
        std::string facts() const override { return "7 points"; }
        std::vector<bool> revealed;
    };
    TravelSource source{{1, 1}, [](int, int, int) { return 0; }};
    std::ostringstream out;
    const std::vector script{PreviewKey::play_pause, PreviewKey::travel, PreviewKey::next_frame,
                             PreviewKey::travel};
    play_script(source, programme(30000, {{}, Time::frame(10), Loop::repeat}), script, out);
    CHECK(source.revealed == std::vector{false, true, true, false});
    const std::string text = out.str();
    CHECK(text.find("paused  event begin  7 points  ") != std::string::npos);
    CHECK(text.find("7 points") > text.find("paused"));
    CHECK(text.rfind("7 points") < text.rfind("paused"));
}

TEST_CASE("events behind the last frame are passed as well, and written so that they cannot disturb")
{
    std::vector<int> shown;
    PaintedSource source = numbered(shown);
    std::ostringstream out;
    play_headless(source, programme(30000, {{}, Time::frame(10), Loop::repeat}), out);
    CHECK(out.str().starts_with("event 0 begin\nevent 9.5 late<U+000A>\n10 frames, "));
}

TEST_CASE("a speed changes how many frames there are")
{
    std::vector<int> shown;
    PaintedSource source = numbered(shown);
    std::ostringstream out;
    Programme fast = programme(30000, {{}, Time::frame(5), Loop::once});
    fast.speed = -2 * Playhead::as_authored;
    play_headless(source, fast, out);
    CHECK(shown == std::vector{5, 3, 1, 0});
}

}
