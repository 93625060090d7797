#include "host/preview/playback/preview_playback.hpp"

#include "tests/host/preview/playback_fixtures.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("once stops at its end; space then plays it anew")
{
    PreviewPlayback state = playback(Loop::once);
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
    PreviewPlayback state = playback(Loop::ping_pong);
    state.advance_to(after(1));
    CHECK(state.time() == Time::frame(10));
    state.advance_to(after(1.3));
    CHECK(state.time() == Time::frame(7));
}

TEST_CASE("a number of loops ends with the last picture of the last one")
{
    PreviewPlayback state = playback(Loop::repeat, 2);
    state.advance_to(after(1.9));
    CHECK_FALSE(state.wants_to_quit());
    state.advance_to(after(2));
    CHECK(state.wants_to_quit());
    CHECK(state.frame() == 9);
}

TEST_CASE("a loop of ping-pong is there and back")
{
    PreviewPlayback state = playback(Loop::ping_pong, 1);
    state.advance_to(after(1.9));
    CHECK_FALSE(state.wants_to_quit());
    state.advance_to(after(2));
    CHECK(state.wants_to_quit());
    CHECK(state.frame() == 1);
}

TEST_CASE("once has one loop, however many are wanted, and ends on its last picture")
{
    PreviewPlayback state = playback(Loop::once, 5);
    state.advance_to(after(0.9));
    CHECK_FALSE(state.wants_to_quit());
    state.advance_to(after(1.1));
    CHECK(state.wants_to_quit());
    CHECK(state.time() == Time::frame(10));
}

TEST_CASE("a clip that plays once is not cut short by the loop before it")
{
    PreviewPlayback state = playback(Loop::repeat, 1);
    state.press(PreviewKey::previous_clip, after(0.9));
    CHECK(state.time().ticks == 2 * 1024 + 512);
    state.advance_to(after(1.04));
    CHECK_FALSE(state.wants_to_quit());
    state.advance_to(after(1.05));
    CHECK(state.time() == Time::frame(4));
    CHECK(state.wants_to_quit());
}

TEST_CASE("a pause or a step does not end a preview, whatever the number of loops")
{
    PreviewPlayback state = playback(Loop::once, 1);
    state.press(PreviewKey::play_pause, after(0.5));
    state.advance_to(after(9));
    CHECK_FALSE(state.wants_to_quit());
    state.press(PreviewKey::previous_key, after(9));
    state.press(PreviewKey::previous_key, after(9));
    state.press(PreviewKey::previous_key, after(9));
    CHECK(state.time() == Time::frame(10));
    CHECK_FALSE(state.wants_to_quit());
}

TEST_CASE("loops last as long as the speed asks for")
{
    PlaybackSetup fast = silent(Loop::repeat);
    fast.speed = 2 * Playhead::as_authored;
    PreviewPlayback state{fast, Pace::smooth, start, 2};
    state.advance_to(after(0.9));
    CHECK(state.time() == Time::frame(8));
    state.advance_to(after(0.99));
    CHECK_FALSE(state.wants_to_quit());
    state.advance_to(after(1));
    CHECK(state.wants_to_quit());
    CHECK(state.frame() == 9);
}

TEST_CASE("c and b go through the scene and its clips, each with its own loop mode")
{
    PreviewPlayback state = playback(Loop::repeat);
    state.press(PreviewKey::next_clip, after(0.1));
    CHECK(state.status() == "frame 4  0.400 s  playing  clip slow");
    state.advance_to(after(0.55));
    CHECK(state.time().ticks == 4 * 1024 + 512);
    state.press(PreviewKey::next_clip, after(1));
    CHECK(state.time().ticks == 2 * 1024 + 512);
    state.advance_to(after(9));
    CHECK(state.status() == "frame 4  0.400 s  paused  clip short");
    state.press(PreviewKey::next_clip, after(9));
    CHECK(state.status() == "frame 0  0.000 s  playing");
    state.press(PreviewKey::previous_clip, after(9));
    state.press(PreviewKey::previous_clip, after(9));
    CHECK(state.status() == "frame 4  0.400 s  playing  clip slow");
}

TEST_CASE("the last loop passes its last events, though it shows no more")
{
    RecordedPlayback recorded{1};
    PreviewPlayback& state = recorded.state;
    state.advance_to(after(0.4));
    state.advance_to(after(7));
    CHECK(state.wants_to_quit());
    CHECK(state.frame() == 4);
    CHECK(recorded.passed() == "begin step echo\x1b ");
}

TEST_CASE("what plays once can be repeated, what repeats can play once, and either as it was made")
{
    PreviewPlayback state = playback(Loop::once);
    state.press(PreviewKey::loop, start);
    CHECK(state.status() == "frame 0  0.000 s  playing  loop always");
    state.advance_to(after(12.3));
    CHECK(state.playing());
    CHECK(state.frame() == 3);
    state.press(PreviewKey::loop, after(12.3));
    CHECK(state.status() == "frame 3  0.300 s  playing  loop once");
    state.advance_to(after(20));
    CHECK(!state.playing());
    CHECK(state.time() == Time::frame(10));
    state.press(PreviewKey::loop, after(20));
    CHECK(state.loop_choice() == LoopChoice::as_authored);
    CHECK(state.time() == Time::frame(10));
}

TEST_CASE("the number of loops goes on with a playback for another, whose scene may last longer")
{
    for (const int frames : {10, 15, 5}) {
        CAPTURE(frames);
        PreviewPlayback before = playback(Loop::repeat, 3);
        before.advance_to(after(1.4));
        PlaybackSetup longer = silent(Loop::repeat);
        longer.parts.front().stretch.end = Time::frame(frames);
        PreviewPlayback state{longer, Pace::smooth, start, 3};
        state.continue_from(before, after(1.4));
        const double end = 1.4 + (frames - 4) / 10.0 + frames / 10.0; // of this loop, and another one
        state.advance_to(after(end - 0.01));
        CHECK_FALSE(state.wants_to_quit());
        state.advance_to(after(end));
        CHECK(state.wants_to_quit());
    }
    PreviewPlayback before = playback(Loop::ping_pong, 1);
    before.advance_to(after(1.4));
    PlaybackSetup longer = silent(Loop::ping_pong);
    longer.parts.front().stretch.end = Time::frame(15);
    PreviewPlayback state{longer, Pace::smooth, start, 1};
    state.continue_from(before, after(1.4));
    state.advance_to(after(1.99));
    CHECK_FALSE(state.wants_to_quit());
    state.advance_to(after(2));
    CHECK(state.wants_to_quit());
}

TEST_CASE("ping-pong stays what it is while it is repeated")
{
    PreviewPlayback state = playback(Loop::ping_pong);
    state.press(PreviewKey::loop, start);
    CHECK(state.stretch().loop == Loop::ping_pong);
}

}
