#include "host/preview/preview_playback.hpp"

#include "tests/event_bytes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

using Seconds = PreviewPlayback::Seconds;

constexpr Seconds start{1000};

/// 10 fps and 10 frames; keys at 0, 3, 6.5 and at the end; a clip "slow", frames 4 to 8, repeated, and one
/// that plays once, frames 2.5 to 4. Events stand at 0, 5 and 5.25 frames.
Programme programme(Loop loop)
{
    static const std::vector<std::byte> events =
        event_bytes({{"begin", Time{0}}, {"step", Time::frame(5)}, {"echo\x1b", {5 * 1024 + 256}}});
    return {.frame_rate = 10000,
            .parts = {{"", {Time{0}, Time::frame(10), loop}},
                      {"slow", {Time::frame(4), Time::frame(8), Loop::repeat}},
                      {"short", {{2 * 1024 + 512}, Time::frame(4), Loop::once}}},
            .keys = {Time::frame(0), Time::frame(3), {6 * 1024 + 512}, Time::frame(10)},
            .events = EventCursor{ByteReader{events}}};
}

/// The same without events.
Programme silent(Loop loop)
{
    Programme silent = programme(loop);
    silent.events = EventCursor{ByteReader{}};
    return silent;
}

PreviewPlayback playback(Loop loop, std::optional<int> loops = std::nullopt)
{
    return {silent(loop), Pace::smooth, start, loops};
}

/// A playback with events, and the names of those that were passed.
struct Told {
    explicit Told(std::optional<int> loops = std::nullopt)
        : state{programme(Loop::repeat), Pace::smooth, start, loops}
    {
        state.tell_events_to([this](const EventView& event) { names.append(event.name).append(" "); });
    }
    Told(const Told&) = delete;

    std::string passed() { return std::exchange(names, {}); }

    PreviewPlayback state;
    std::string names;
};

Seconds after(double seconds) { return start + Seconds{seconds}; }

/// The moments, in frames, after pressing `key` so often.
std::vector<double> pressed(PreviewPlayback state, PreviewKey key, int times)
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
    const PreviewPlayback state = playback(Loop::repeat);
    CHECK(state.time() == Time{0});
    CHECK(state.playing());
    CHECK(state.help_open());
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
    Programme keyless = silent(Loop::repeat);
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
    CHECK_FALSE(state.help_open());
    state.press(PreviewKey::help, start);
    CHECK(state.help_open());
    state.press(PreviewKey::next_frame, start);
    CHECK_FALSE(state.help_open());
    CHECK_FALSE(state.wants_to_quit());
    state.press(PreviewKey::quit, start);
    CHECK(state.wants_to_quit());
}

TEST_CASE("escape closes the help, and quits where it is closed")
{
    PreviewPlayback state = playback(Loop::repeat);
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
    Programme backwards = silent(Loop::once);
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

TEST_CASE("loops last as long as the speed asks for")
{
    Programme fast = silent(Loop::repeat);
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
    Told told;
    PreviewPlayback& state = told.state;
    CHECK(told.passed() == "");
    state.advance_to(after(0));
    CHECK(told.passed() == "begin ");
    CHECK(state.status() == "frame 0  0.000 s  playing  event begin");
    state.advance_to(after(0.51));
    CHECK(told.passed() == "step ");
    state.advance_to(after(2.9));
    CHECK(told.passed() == "echo\x1b begin step echo\x1b begin step echo\x1b ");
    CHECK(state.status() == "frame 9  0.900 s  playing  event echo<U+001B>");
    CHECK(told.passed() == "");
}

TEST_CASE("stepping passes nothing and forgets the latest event; playing on begins with what is there")
{
    Told told;
    PreviewPlayback& state = told.state;
    state.advance_to(after(0.45));
    told.passed();
    state.press(PreviewKey::next_frame, after(0.45));
    CHECK(state.status() == "frame 5  0.500 s  paused");
    CHECK(told.passed() == "");
    state.press(PreviewKey::play_pause, after(1));
    state.advance_to(after(1.01));
    CHECK(told.passed() == "step ");
}

TEST_CASE("the last loop passes its last events, though it shows no more")
{
    Told told{1};
    PreviewPlayback& state = told.state;
    state.advance_to(after(0.4));
    state.advance_to(after(7));
    CHECK(state.wants_to_quit());
    CHECK(state.frame() == 4);
    CHECK(told.passed() == "begin step echo\x1b ");
}

TEST_CASE("a board changes its picture at the frames alone")
{
    Programme slow = silent(Loop::repeat);
    slow.speed = Playhead::as_authored / 2;
    PreviewPlayback state{slow, Pace::by_frames, start};
    state.advance_to(after(0.39));
    CHECK(state.time().ticks == 1536);
    CHECK((state.next_frame_at() - start).count() == doctest::Approx(0.4));
    state.advance_to(after(0.4));
    CHECK(state.time() == Time::frame(2));
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

    Told told;
    told.state.advance_to(after(0.6));
    PreviewPlayback next{programme(Loop::repeat), Pace::smooth, start};
    next.continue_from(told.state, after(0.6));
    CHECK(next.status() == told.state.status());
    CHECK(next.status().find("event echo") != std::string::npos);
}

TEST_CASE("the number of loops goes on with a playback for another, whose scene may last longer")
{
    for (const int frames : {10, 15, 5}) {
        CAPTURE(frames);
        PreviewPlayback before = playback(Loop::repeat, 3);
        before.advance_to(after(1.4));
        Programme longer = silent(Loop::repeat);
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
    Programme longer = silent(Loop::ping_pong);
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
