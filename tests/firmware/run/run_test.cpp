#include "firmware/run/run.hpp"

#include "tests/bytes.hpp"
#include "tests/compiled.hpp"
#include "tests/event_bytes.hpp"
#include "tests/firmware/run/numbered_rows.hpp"
#include "tests/firmware/run/slow_board.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

/// Plays what it is told to.
class ChosenBoard : public SlowBoard {
public:
    using SlowBoard::SlowBoard;

    Playhead playhead(const SceneView& view) const
    {
        Playhead there_and_back{{Time::frame(2), Time::frame(4), Loop::ping_pong}, view.events()};
        there_and_back.set_speed(2 * Playhead::as_authored);
        return there_and_back;
    }
    std::span<std::byte> block() { return std::as_writable_bytes(std::span{block_}); }

private:
    std::array<std::uint32_t, 4096> block_{};
};

static_assert(ChoosingBoard<ChosenBoard>);

/// Plays what needs no features.
class PlainBoard : public ChosenBoard {
public:
    using ChosenBoard::ChosenBoard;

    const Features& features() const { return none; }

private:
    static constexpr Features none{};
};

static_assert(FeatureBoard<PlainBoard>);

/// Whose display loses its memory before some of the frames.
class ForgetfulBoard : public SlowBoard {
public:
    using SlowBoard::SlowBoard;

    bool wants_redraw() { return std::ranges::count(lost_before, static_cast<int>(asked++)) != 0; }

    std::vector<int> lost_before;
    int asked = 0;
};

static_assert(RedrawingBoard<ForgetfulBoard>);

Playhead hundred_frames()
{
    static const std::vector<std::byte> events = event_bytes(
        {{"a", Time{0}}, {"b", {1500}}, {"c", Time::frame(3)}, {"d", Time::frame(5)}, {"e", Time::frame(6)}});
    return {{Time{0}, Time::frame(100), Loop::repeat}, EventCursor{ByteReader{events}}};
}

}

TEST_CASE("a frame in which nothing changes sends nothing and is shown all the same")
{
    SlowBoard board{12};
    NumberedRows player;
    board.durations = {0, 0, 0, 0};
    play(board, player, hundred_frames(), {50'000, board.now()});
    CHECK(board.panel().areas.size() == 3);
    CHECK(board.reports.size() == 4);
    CHECK_FALSE(board.reports.back().is_coarse);
    CHECK(board.reports.back().time == Time::frame(3));
}

TEST_CASE("a board is told that a frame was drawn coarser, for want of room")
{
    SlowBoard board{12};
    NumberedRows player;
    player.are_coarse = true;
    board.durations = {0, 0};
    play(board, player, hundred_frames(), {50'000, board.now()});
    CHECK(std::ranges::all_of(board.reports, &FrameReport::is_coarse));
}

TEST_CASE("a board may have a frame sent whole")
{
    ForgetfulBoard board{12};
    NumberedRows player;
    board.durations = {0, 0, 0, 0};
    board.lost_before = {2};
    play(board, player, hundred_frames(), {50'000, board.now()});
    CHECK(board.asked == 4);
    CHECK(player.redraws == 1);
    CHECK(board.panel().areas.size() == 6);
}

TEST_CASE("frames are shown when they are due; those that come too late are left out and counted")
{
    SlowBoard board{12};
    NumberedRows player;
    const Microseconds start = board.now();
    board.durations = {0, 5'000, 20'000, 25'000, 61'000, 1'000, 1'000};
    play(board, player, hundred_frames(), {50'000, start});

    // A frame has 20 ms. Number 2 takes all of its time, 3 a little more, 4 runs over three periods.
    CHECK(player.shown == std::vector{0, 1, 2, 3, 4, 7, 8});
    std::vector<std::uint32_t> moments;
    std::ranges::transform(board.shown_at, std::back_inserter(moments),
                           [&](std::uint32_t moment) { return moment - start.count; });
    CHECK(moments == std::vector<std::uint32_t>{0, 20'000, 40'000, 60'000, 85'000, 146'000, 160'000});
    CHECK(board.reports.back().skipped == 2);
    CHECK(board.reports[4].skipped == 0);
}

TEST_CASE("frames do not drift in an hour, nor when the clock wraps")
{
    constexpr std::uint32_t rate = 29'970; // in 1000 s
    constexpr std::uint32_t minutes = 100; // the clock wraps every 71.6
    SlowBoard board{12};
    NumberedRows player;
    board.durations.assign(minutes * 60 * rate / 1000, 30'000);
    const Microseconds start = board.now();
    play(board, player, hundred_frames(), {rate, start});

    for (std::uint64_t frame = 0; frame < board.shown_at.size(); ++frame)
        REQUIRE(board.shown_at[frame] - start.count ==
                static_cast<std::uint32_t>(frame * 1'000'000'000 / rate));
    CHECK(board.reports.back().skipped == 0);
}

TEST_CASE("frames that always come too late are left out, as many as the time asks for")
{
    SlowBoard board{12};
    NumberedRows player;
    board.durations.assign(100'000, 50'000); // for an hour and 23 minutes, half as long again as a frame has
    const Microseconds start = board.now();
    play(board, player, hundred_frames(), {30'000, start});

    // Frame 0, then 1, behind it 3, 4, 6, 7, 9 …: each is the last one that is due.
    for (std::uint64_t frame = 0; frame < board.shown_at.size(); ++frame) {
        REQUIRE(board.shown_at[frame] - start.count == static_cast<std::uint32_t>(frame * 50'000));
        REQUIRE(player.shown[frame] == static_cast<int>((frame * 3 / 2) % 100));
        REQUIRE(board.reports[frame].skipped + frame == frame * 3 / 2);
    }
}

TEST_CASE("events are told before their frame, those of frames left out as well")
{
    SlowBoard board{12};
    NumberedRows player;
    board.durations = {0, 5'000, 20'000, 25'000, 61'000, 1'000, 1'000};
    play(board, player, hundred_frames(), {50'000, board.now()});
    CHECK(board.story == "a 0 1 b 2 c 3 4 d e 7 8 ");
}

TEST_CASE("a board may choose what is played")
{
    ChosenBoard board{12};
    board.scene = compiled("kfast 1\ncanvas 6 10 frames=5\nobject a fill=white { rect 0 0 6 10 }\n"
                           "event 0 no\nevent 2 begin\nevent 3 step\nevent 4 end");
    board.durations = {0, 0, 0, 0};
    run(board);
    CHECK_FALSE(board.reported.has_value());
    CHECK(board.story == "begin 2 step end 4 step begin 2 step end 4 ");
}

TEST_CASE("a board plays what its features are enough for, and reports the one that it lacks")
{
    for (const bool has_stroke : {false, true}) {
        PlainBoard board{12};
        board.scene = compiled(std::string{"kfast 1\ncanvas 6 10\nobject a fill=white"} +
                               (has_stroke ? " stroke=red" : "") + " { rect 0 0 6 10 }");
        board.durations = {0};
        run(board);
        CHECK(board.reported.has_value() == has_stroke);
        if (has_stroke)
            CHECK(*board.reported == Error::needs_strokes);
        else
            CHECK(board.reports.size() == 1);
    }
}

TEST_CASE("bands that do not hold a row are reported, not waited for")
{
    SlowBoard board{5};
    board.scene = compiled("kfast 1\ncanvas 6 10\nobject a fill=white { rect 0 0 6 10 }");
    board.durations = {0};
    run(board);
    CHECK(board.reported == Error::block_too_small);
    CHECK(board.reports.empty());
    CHECK(board.panel().areas.empty());
}

TEST_CASE("bytes that are no scene are reported, and the panel is drawn once")
{
    SlowBoard board{12};
    board.scene = bytes({'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.',
                         'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.',
                         'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.'});
    board.durations = {0};
    run(board);
    CHECK(board.reported == Error::bad_magic);
    CHECK(board.reports.empty());
    CHECK(board.panel().areas == std::vector<Rect>{{0, 0, 6, 4}, {0, 4, 6, 4}, {0, 8, 6, 2}});
}

}
