#include "host/preview/board/board_changes.hpp"

#include "core/player.hpp"
#include "host/fit/speed.hpp"
#include "host/preview/board/previewed_board.hpp"
#include "tests/host/preview/named_scene.hpp"
#include "tests/host/preview/playback_fixtures.hpp"

#include <algorithm>
#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// The frames that a board shows which takes so long for each, from 0 s to 1 s, at 10 frames a second.
std::vector<int> frames_shown(double seconds_for_each)
{
    PreviewPlayback state = playback(Loop::repeat);
    state.pace_by([=](Time) { return seconds_for_each; }, start);
    std::vector<int> frames;
    for (int hundredths = 0; hundredths < 100; ++hundredths) {
        state.advance_to(after(hundredths / 100.0));
        if (frames.empty() || frames.back() != state.frame())
            frames.push_back(state.frame());
    }
    return frames;
}

}

TEST_CASE("a board that is fast enough shows all frames, a slow one leaves out those that are over")
{
    CHECK(frames_shown(0.02) == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
    CHECK(frames_shown(0.13) == std::vector<int>{0, 1, 2, 3, 5, 6, 7, 9});
    CHECK(frames_shown(0.26) == std::vector<int>{0, 2, 5, 7});
}

TEST_CASE("what a board shows stands still between its frames, and goes on as ever without it")
{
    PreviewPlayback state = playback(Loop::repeat);
    state.pace_by([](Time) { return 0.25; }, start);
    state.advance_to(after(0.24));
    CHECK(state.time() == Time{0});
    CHECK((state.next_frame_at() - start).count() == doctest::Approx(0.25));
    CHECK_FALSE(state.board_rate().has_value());
    state.advance_to(after(1));
    REQUIRE(state.board_rate().has_value());
    CHECK(*state.board_rate() == doctest::Approx(4));
    state.pace_by({}, after(1));
    const Time here = state.time();
    state.advance_to(after(1.05));
    CHECK(state.time() == here + Time{512});
}

TEST_CASE("events of frames that a board leaves out are passed all the same, and a pause begins anew")
{
    RecordedPlayback run;
    run.state.pace_by([](Time) { return 0.9; }, start);
    run.state.advance_to(after(0.95));
    CHECK(run.passed().find("step") != std::string::npos);
    run.state.press(PreviewKey::play_pause, after(1));
    run.state.advance_to(after(50));
    const Time paused = run.state.time();
    run.state.press(PreviewKey::play_pause, after(50));
    run.state.advance_to(after(50.5));
    CHECK(run.state.time() == paused);
}

TEST_CASE("after a break a board goes on where it stood, and does not draw what it has missed")
{
    PreviewPlayback state = playback(Loop::repeat);
    int pictures = 0;
    state.pace_by([&](Time) { return ++pictures, 0.05; }, start);
    state.advance_to(after(0.35));
    CHECK(pictures == 4);
    state.advance_to(after(3600));
    CHECK(pictures == 5);
    CHECK(state.frame() == 3);
    state.advance_to(after(3600.15));
    CHECK(state.frame() == 4);
}

TEST_CASE("a picture takes as long as the fit report says")
{
    const NamedScene scene{"kfast 1\ncanvas 240 240 frames=20\n"
                           "object ball fill=red { key 0 x=0; key 20 x=80; circle 60 60 r=40 }\n"};
    const fit::Target board = previewed_board({.size = {240, 240}});
    const fit::Speed speed =
        fit::measured_speed(scene.view(), board, Fit::contain, std::stop_token{}, ignore_progress);
    BoardPace pace{scene.view(), board, Fit::contain};
    CHECK(pace.seconds_for(Time{0}) == doctest::Approx(speed.first.seconds()));
    for (int frame = 1; frame < 20; ++frame) {
        const double seconds = pace.seconds_for(Time::frame(frame));
        const auto same = std::ranges::find(speed.frames, Time::frame(frame), &fit::FrameCost::moment);
        REQUIRE(same != speed.frames.end());
        CHECK(seconds == doctest::Approx(same->seconds()));
    }
}

}
