#include "host/preview/playback/preview_playback.hpp"

#include "tests/host/preview/playback_fixtures.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("a preview starts playing at the beginning, and its help is closed")
{
    const PreviewPlayback state = playback(Loop::repeat);
    CHECK(state.time() == Time{0});
    CHECK(state.playing());
    CHECK_FALSE(state.help_open());
    CHECK(state.status() == "frame 0  0.000 s  playing");
}

TEST_CASE("playing follows the clock")
{
    PreviewPlayback state = playback(Loop::repeat);
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
    PreviewPlayback state = playback(Loop::repeat);
    state.advance_to(after(86400.3));
    CHECK(state.time() == Time::frame(3));
}

TEST_CASE("space pauses and goes on from there")
{
    PreviewPlayback state = playback(Loop::repeat);
    state.press(PreviewKey::play_pause, after(0.2));
    state.advance_to(after(5));
    CHECK(state.status() == "frame 2  0.200 s  paused");
    state.press(PreviewKey::play_pause, after(7));
    state.advance_to(after(7.3));
    CHECK(state.status() == "frame 5  0.500 s  playing");
}

TEST_CASE("n and p go from key to key and around, and pause")
{
    CHECK(pressed(playback(Loop::repeat), PreviewKey::next_key, 4) == std::vector<double>{3, 6.5, 0, 3});
    CHECK(pressed(playback(Loop::repeat), PreviewKey::previous_key, 4) ==
          std::vector<double>{6.5, 3, 0, 6.5});
    CHECK(pressed(playback(Loop::once), PreviewKey::next_key, 4) == std::vector<double>{3, 6.5, 10, 0});
    PreviewPlayback state = playback(Loop::repeat);
    state.press(PreviewKey::next_key, after(0.4));
    CHECK(state.time().ticks == 6 * 1024 + 512);
    CHECK_FALSE(state.playing());
    state.press(PreviewKey::previous_key, after(9));
    CHECK(state.time() == Time::frame(3));
}

TEST_CASE("without keys n and p go to the beginning")
{
    PlaybackSetup keyless = silent(Loop::repeat);
    keyless.keys.clear();
    PreviewPlayback state{keyless, Pace::smooth, start};
    state.press(PreviewKey::next_key, after(0.4));
    CHECK(state.time() == Time{0});
}

TEST_CASE("arrows go by whole frames and around")
{
    PreviewPlayback state = playback(Loop::repeat);
    state.press(PreviewKey::next_frame, after(0.25));
    CHECK(state.time() == Time::frame(3));
    CHECK(pressed(state, PreviewKey::next_frame, 8) == std::vector<double>{4, 5, 6, 7, 8, 9, 0, 1});
    CHECK(pressed(state, PreviewKey::previous_frame, 5) == std::vector<double>{2, 1, 0, 9, 8});
    CHECK(pressed(playback(Loop::once), PreviewKey::previous_frame, 2) == std::vector<double>{10, 9});
}

TEST_CASE("an arrow between frames goes to the neighbour on that side")
{
    PreviewPlayback state = playback(Loop::repeat);
    state.press(PreviewKey::previous_frame, after(0.25));
    CHECK(state.time() == Time::frame(2));
}

TEST_CASE("h opens and closes the help, any other key closes it, q quits")
{
    PreviewPlayback state = playback(Loop::repeat);
    state.press(PreviewKey::help, start);
    CHECK(state.help_open());
    state.press(PreviewKey::help, start);
    CHECK_FALSE(state.help_open());
    state.press(PreviewKey::help, start);
    state.press(PreviewKey::next_frame, start);
    CHECK_FALSE(state.help_open());
    CHECK_FALSE(state.wants_to_quit());
    state.press(PreviewKey::quit, start);
    CHECK(state.wants_to_quit());
}

TEST_CASE("escape closes the help, and quits where it is closed")
{
    PreviewPlayback state = playback(Loop::repeat);
    state.press(PreviewKey::help, start);
    state.press(PreviewKey::leave, start);
    CHECK_FALSE(state.help_open());
    CHECK_FALSE(state.wants_to_quit());
    state.press(PreviewKey::leave, start);
    CHECK(state.wants_to_quit());
}

TEST_CASE("speed goes by doubles, within 1/16 and 16, and backwards; what is shown does not jump")
{
    PreviewPlayback state = playback(Loop::repeat);
    state.press(PreviewKey::slower, after(0.4));
    CHECK(state.time() == Time::frame(4));
    state.advance_to(after(0.8));
    CHECK(state.status() == "frame 6  0.600 s  playing  speed 0.5");
    state.press(PreviewKey::reverse, after(0.8));
    state.advance_to(after(1.2));
    CHECK(state.status() == "frame 4  0.400 s  playing  speed -0.5");
    for (int i = 0; i < 9; ++i)
        state.press(PreviewKey::faster, after(1.2));
    CHECK(state.status() == "frame 4  0.400 s  playing  speed -16");
    state.press(PreviewKey::reverse, after(1.2));
    for (int i = 0; i < 9; ++i)
        state.press(PreviewKey::slower, after(1.2));
    CHECK(state.status() == "frame 4  0.400 s  playing  speed 0.0625");
}

TEST_CASE("backwards begins at the end; once ends at its beginning and starts anew at its end")
{
    PlaybackSetup backwards = silent(Loop::once);
    backwards.speed = -Playhead::as_authored;
    PreviewPlayback state{backwards, Pace::smooth, start, 1};
    CHECK(state.time() == Time::frame(10));
    state.advance_to(after(0.9));
    CHECK(state.time() == Time::frame(1));
    CHECK_FALSE(state.wants_to_quit());
    state.advance_to(after(1));
    CHECK(state.time() == Time::frame(0));
    CHECK(state.wants_to_quit());
    PreviewPlayback endless{backwards, Pace::smooth, start};
    endless.advance_to(after(2));
    endless.press(PreviewKey::play_pause, after(5));
    endless.advance_to(after(5.1));
    CHECK(endless.time() == Time::frame(9));
}

TEST_CASE("in a clip, keys and arrows stay within it")
{
    PreviewPlayback state = playback(Loop::repeat);
    state.press(PreviewKey::next_clip, start);
    CHECK(pressed(state, PreviewKey::next_key, 2) == std::vector<double>{6.5, 6.5});
    CHECK(pressed(state, PreviewKey::next_frame, 4) == std::vector<double>{5, 6, 7, 4});
    CHECK(pressed(state, PreviewKey::previous_frame, 2) == std::vector<double>{7, 6});
    state.press(PreviewKey::next_clip, start);
    CHECK(pressed(state, PreviewKey::next_frame, 3) == std::vector<double>{3.5, 4, 2.5});
    CHECK(pressed(state, PreviewKey::previous_frame, 3) == std::vector<double>{4, 3.5, 2.5});
}

TEST_CASE("events are passed in order, none left out, and the status names the latest")
{
    RecordedPlayback recorded;
    PreviewPlayback& state = recorded.state;
    CHECK(recorded.passed() == "");
    state.advance_to(after(0));
    CHECK(recorded.passed() == "begin ");
    CHECK(state.status() == "frame 0  0.000 s  playing  event begin");
    state.advance_to(after(0.51));
    CHECK(recorded.passed() == "step ");
    state.advance_to(after(2.9));
    CHECK(recorded.passed() == "echo\x1b begin step echo\x1b begin step echo\x1b ");
    CHECK(state.status() == "frame 9  0.900 s  playing  event echo<U+001B>");
    CHECK(recorded.passed() == "");
}

TEST_CASE("stepping passes nothing and forgets the latest event; playing on begins with what is there")
{
    RecordedPlayback recorded;
    PreviewPlayback& state = recorded.state;
    state.advance_to(after(0.45));
    recorded.passed();
    state.press(PreviewKey::next_frame, after(0.45));
    CHECK(state.status() == "frame 5  0.500 s  paused");
    CHECK(recorded.passed() == "");
    state.press(PreviewKey::play_pause, after(1));
    state.advance_to(after(1.01));
    CHECK(recorded.passed() == "step ");
}

TEST_CASE("a board changes its picture at the frames alone")
{
    PlaybackSetup slow = silent(Loop::repeat);
    slow.speed = Playhead::as_authored / 2;
    PreviewPlayback state{slow, Pace::by_frames, start};
    state.advance_to(after(0.39));
    CHECK(state.time().ticks == 1536);
    CHECK((state.next_frame_at() - start).count() == doctest::Approx(0.4));
    state.advance_to(after(0.4));
    CHECK(state.time() == Time::frame(2));
}

TEST_CASE("a playback that goes on for another keeps its way back and its latest event")
{
    PreviewPlayback before = playback(Loop::ping_pong);
    before.advance_to(after(1.4));
    PreviewPlayback state = playback(Loop::ping_pong);
    state.continue_from(before, after(1.4));
    CHECK(state.time() == Time::frame(6));
    state.advance_to(after(1.6));
    CHECK(state.time() == Time::frame(4));
    state.advance_to(after(2.3));
    CHECK(state.time() == Time::frame(3)); // forwards again

    RecordedPlayback recorded;
    recorded.state.advance_to(after(0.6));
    PreviewPlayback next{playback_setup(Loop::repeat), Pace::smooth, start};
    next.continue_from(recorded.state, after(0.6));
    CHECK(next.status() == recorded.state.status());
    CHECK(next.status().find("event echo") != std::string::npos);
}

}
