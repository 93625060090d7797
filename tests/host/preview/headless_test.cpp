#include "host/preview/headless.hpp"

#include "tests/host/picture/painted_source.hpp"

#include <doctest/doctest.h>

#include <sstream>

namespace kfast::test {
namespace {

const std::vector<Time> keys{Time::frame(0), Time::frame(4)};

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
        play_headless(source, {rate, Time::frame(5), Loop::once}, keys, out);
        CHECK(shown == std::vector{0, 1, 2, 3, 4, 5});
        CHECK(out.str() == "6 frames, hash a2b3bb90\n");
    }
}

TEST_CASE("a script shows what each key leads to and stops at a quit")
{
    std::vector<int> shown;
    PaintedSource source = numbered(shown);
    std::ostringstream out;
    const std::vector script{PreviewKey::next_key, PreviewKey::next_frame, PreviewKey::play_pause,
                             PreviewKey::help,     PreviewKey::quit,       PreviewKey::next_key};
    play_script(source, {30000, Time::frame(10), Loop::repeat}, keys, script, out);
    CHECK(shown == std::vector{4, 5, 5, 6});
    CHECK(out.str().starts_with("frame 4  0.133 s  paused  "));
    CHECK(out.str().find("frame 6  0.200 s  playing  ") != std::string::npos);
    CHECK(out.str().find("\n4 frames, hash ") != std::string::npos);
}

}
