#include "host/preview/playback.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

using Seconds = Playback::Seconds;

constexpr Seconds start{1000};

/// 10 fps and 10 frames; keys at 0, 3, 6.5 and at the end.
Playback playback(Loop loop, std::optional<int> loops = std::nullopt)
{
    const std::vector<Time> keys{Time::frame(0), Time::frame(3), {6 * 1024 + 512}, Time::frame(10)};
    return {{10000, Time::frame(10), loop}, keys, start, loops};
}

Seconds after(double seconds) { return start + Seconds{seconds}; }

/// The moments, in frames, after pressing `key` so often.
std::vector<double> pressed(Playback state, PreviewKey key, int times)
{
    std::vector<double> moments;
    for (int i = 0; i < times; ++i) {
        state.press(key, start);
        moments.push_back(state.time().ticks / 1024.0);
    }
    return moments;
}

}

TEST_CASE("a preview starts playing at the beginning, with its help")
{
    const Playback state = playback(Loop::repeat);
    CHECK(state.time() == Time{0});
    CHECK(state.playing());
    CHECK(state.help_open());
    CHECK(state.status() == "frame 0  0.000 s  playing");
}

TEST_CASE("playing follows the clock")
{
    Playback state = playback(Loop::repeat);
    state.advance_to(after(0.45));
    CHECK(state.time().ticks == 4 * 1024 + 512);
    CHECK(state.frame() == 4);
    CHECK((state.next_frame_at() - start).count() == doctest::Approx(0.5));
    state.advance_to(after(12.3));
    CHECK(state.frame() == 3);
    CHECK_FALSE(state.wants_to_quit());
}

TEST_CASE("a day of playing does not drift")
{
    Playback state = playback(Loop::repeat);
    state.advance_to(after(86400.3));
    CHECK(state.time() == Time::frame(3));
}

TEST_CASE("space pauses and goes on from there")
{
    Playback state = playback(Loop::repeat);
    state.press(PreviewKey::play_pause, after(0.2));
    state.advance_to(after(5));
    CHECK(state.status() == "frame 2  0.200 s  paused");
    state.press(PreviewKey::play_pause, after(7));
    state.advance_to(after(7.3));
    CHECK(state.status() == "frame 5  0.500 s  playing");
}

TEST_CASE("once stops at its end; space then plays it anew")
{
    Playback state = playback(Loop::once);
    state.advance_to(after(99));
    CHECK(state.time() == Time::frame(10));
    CHECK_FALSE(state.playing());
    CHECK_FALSE(state.wants_to_quit());
    state.press(PreviewKey::play_pause, after(100));
    state.advance_to(after(100.1));
    CHECK(state.time() == Time::frame(1));
}

TEST_CASE("ping-pong comes back")
{
    Playback state = playback(Loop::ping_pong);
    state.advance_to(after(1));
    CHECK(state.time() == Time::frame(10));
    state.advance_to(after(1.3));
    CHECK(state.time() == Time::frame(7));
}

TEST_CASE("a number of loops ends with the last picture of the last one")
{
    Playback state = playback(Loop::repeat, 2);
    state.advance_to(after(1.9));
    CHECK_FALSE(state.wants_to_quit());
    state.advance_to(after(2));
    CHECK(state.wants_to_quit());
    CHECK(state.frame() == 9);
}

TEST_CASE("a loop of ping-pong is there and back")
{
    Playback state = playback(Loop::ping_pong, 1);
    state.advance_to(after(1.9));
    CHECK_FALSE(state.wants_to_quit());
    state.advance_to(after(2));
    CHECK(state.wants_to_quit());
    CHECK(state.frame() == 1);
}

TEST_CASE("once has one loop, however many are wanted, and ends on its last picture")
{
    Playback state = playback(Loop::once, 5);
    state.advance_to(after(0.9));
    CHECK_FALSE(state.wants_to_quit());
    state.advance_to(after(1.1));
    CHECK(state.wants_to_quit());
    CHECK(state.time() == Time::frame(10));
}

TEST_CASE("a pause or a step does not end a preview, whatever the number of loops")
{
    Playback state = playback(Loop::once, 1);
    state.press(PreviewKey::play_pause, after(0.5));
    state.advance_to(after(9));
    CHECK_FALSE(state.wants_to_quit());
    state.press(PreviewKey::previous_key, after(9));
    state.press(PreviewKey::previous_key, after(9));
    state.press(PreviewKey::previous_key, after(9));
    CHECK(state.time() == Time::frame(10));
    CHECK_FALSE(state.wants_to_quit());
}

TEST_CASE("n and p go from key to key and around, and pause")
{
    CHECK(pressed(playback(Loop::repeat), PreviewKey::next_key, 4) == std::vector<double>{3, 6.5, 0, 3});
    CHECK(pressed(playback(Loop::repeat), PreviewKey::previous_key, 4) ==
          std::vector<double>{6.5, 3, 0, 6.5});
    CHECK(pressed(playback(Loop::once), PreviewKey::next_key, 4) == std::vector<double>{3, 6.5, 10, 0});
    Playback state = playback(Loop::repeat);
    state.press(PreviewKey::next_key, after(0.4));
    CHECK(state.time().ticks == 6 * 1024 + 512);
    CHECK_FALSE(state.playing());
    state.press(PreviewKey::previous_key, after(9));
    CHECK(state.time() == Time::frame(3));
}

TEST_CASE("without keys n and p go to the beginning")
{
    Playback state{{10000, Time::frame(10), Loop::repeat}, {}, start};
    state.press(PreviewKey::next_key, after(0.4));
    CHECK(state.time() == Time{0});
}

TEST_CASE("arrows go by whole frames and around")
{
    Playback state = playback(Loop::repeat);
    state.press(PreviewKey::next_frame, after(0.25));
    CHECK(state.time() == Time::frame(3));
    CHECK(pressed(state, PreviewKey::next_frame, 8) == std::vector<double>{4, 5, 6, 7, 8, 9, 0, 1});
    CHECK(pressed(state, PreviewKey::previous_frame, 5) == std::vector<double>{2, 1, 0, 9, 8});
    CHECK(pressed(playback(Loop::once), PreviewKey::previous_frame, 2) == std::vector<double>{10, 9});
}

TEST_CASE("an arrow between frames goes to the neighbour on that side")
{
    Playback state = playback(Loop::repeat);
    state.press(PreviewKey::previous_frame, after(0.25));
    CHECK(state.time() == Time::frame(2));
}

TEST_CASE("h opens and closes the help, any other key closes it, q quits")
{
    Playback state = playback(Loop::repeat);
    state.press(PreviewKey::help, start);
    CHECK_FALSE(state.help_open());
    state.press(PreviewKey::help, start);
    CHECK(state.help_open());
    state.press(PreviewKey::next_frame, start);
    CHECK_FALSE(state.help_open());
    CHECK_FALSE(state.wants_to_quit());
    state.press(PreviewKey::quit, start);
    CHECK(state.wants_to_quit());
}

TEST_CASE("keys have names")
{
    CHECK(preview_key("space") == PreviewKey::play_pause);
    CHECK(preview_key("escape") == PreviewKey::quit);
    CHECK_FALSE(preview_key("x").has_value());
    CHECK(preview_key_help().front() == "space   play, pause");
}

}
