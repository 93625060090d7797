#include "firmware/run.hpp"

#include "tests/bytes.hpp"
#include "tests/compiled.hpp"
#include "tests/event_bytes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

/// A panel of 6 x 10 greys. It reads pixels only when they must have arrived, like DMA at its slowest.
class SlowPanel {
public:
    static constexpr PixelFormat format = PixelFormat::grey4;
    static constexpr Size granularity{.width = 2, .height = 2};

    Size size() const { return {.width = 6, .height = 10}; }

    template <class Pause>
    void begin(Pause&& pause)
    {
        pause(Microseconds{120'000});
    }

    void start(Rect area, std::span<const std::byte> pixels)
    {
        REQUIRE(polls_left_ == 0);
        REQUIRE(pixels.size() == row_bytes(format, area.width) * static_cast<std::size_t>(area.height));
        areas.push_back(area);
        on_their_way_ = pixels;
        polls_left_ = 3;
    }

    bool busy()
    {
        if (polls_left_ == 0)
            return false;
        if (--polls_left_ == 0)
            shown.insert(shown.end(), on_their_way_.begin(), on_their_way_.end());
        return true;
    }

    std::vector<Rect> areas;
    std::vector<std::byte> shown;

private:
    std::span<const std::byte> on_their_way_;
    int polls_left_ = 0;
};

/// Fills every row with its number; a frame takes as long as the board is told.
class NumberedRows {
public:
    void show_moment(Time moment)
    {
        shown.push_back(moment.ticks / Time::ticks_per_frame);
        row_ = 0;
    }

    template <PixelFormat format>
    void draw_rows(int rows, std::span<std::byte> pixels)
    {
        REQUIRE(pixels.size() == static_cast<std::size_t>(3 * rows));
        for (std::byte& pixel : pixels)
            pixel = static_cast<std::byte>(row_++ / 3);
    }

    std::vector<int> shown;

private:
    int row_ = 0;
};

class TestBoard {
public:
    explicit TestBoard(std::size_t band_bytes) { bands_.fill(std::vector<std::byte>(band_bytes)); }

    SlowPanel& panel() { return panel_; }
    Microseconds now() const { return now_; }
    void sleep_until(Microseconds moment)
    {
        if (!reached(now_, moment))
            now_ = moment;
    }
    std::span<const std::byte> scene_bytes() const { return scene; }
    std::span<std::byte> block() { return {}; }
    std::array<std::span<std::byte>, 2> bands() { return {bands_[0], bands_[1]}; }
    bool running() const { return reports.size() < durations.size(); }
    void scene_started(const SceneView&) {}
    void watch(std::span<const std::byte> pixels)
    {
        watched.insert(watched.end(), pixels.begin(), pixels.end());
    }
    void event_passed(const EventView& event) { story += std::string{event.name} + ' '; }
    void frame_shown(FrameReport report)
    {
        story += std::to_string(report.time.ticks / Time::ticks_per_frame) + ' ';
        shown_at.push_back(now_.count);
        now_ = now_ + Microseconds{durations[reports.size()]};
        reports.push_back(report);
    }
    void fault(Error error) { reported = error; }

    std::vector<std::byte> scene;
    std::vector<std::uint32_t> durations; ///< microseconds that each frame takes
    std::vector<FrameReport> reports;
    std::vector<std::uint32_t> shown_at;
    std::string story; ///< the events and the numbers of the frames, in order
    std::vector<std::byte> watched;
    std::optional<Error> reported;

private:
    SlowPanel panel_;
    std::array<std::vector<std::byte>, 2> bands_;
    Microseconds now_{0xFFFF'FFFF - 49'999}; // wraps within the first frames
};

static_assert(WatchingBoard<TestBoard>);
static_assert(EventBoard<TestBoard>);
static_assert(!ChoosingBoard<TestBoard>);

/// Plays what it is told to.
class ChosenBoard : public TestBoard {
public:
    using TestBoard::TestBoard;

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

Playhead hundred_frames()
{
    static const std::vector<std::byte> events = event_bytes(
        {{"a", Time{0}}, {"b", {1500}}, {"c", Time::frame(3)}, {"d", Time::frame(5)}, {"e", Time::frame(6)}});
    return {{Time{0}, Time::frame(100), Loop::repeat}, EventCursor{ByteReader{events}}};
}

std::vector<std::byte> ten_numbered_rows()
{
    std::vector<std::byte> rows;
    for (int row = 0; row < 10; ++row)
        rows.insert(rows.end(), 3, static_cast<std::byte>(row));
    return rows;
}

}

TEST_CASE("the bands make up the picture although each is sent while the next is drawn")
{
    TestBoard board{12};
    NumberedRows player;
    player.show_moment({});
    draw_frame(board, player);
    CHECK(board.panel().shown == ten_numbered_rows());
    CHECK(board.panel().areas == std::vector<Rect>{{0, 0, 6, 4}, {0, 4, 6, 4}, {0, 8, 6, 2}});
}

TEST_CASE("a band has as many rows as its buffer holds and the panel's granularity allows")
{
    TestBoard board{17};
    NumberedRows player;
    player.show_moment({});
    draw_frame(board, player);
    CHECK(board.panel().areas.front() == Rect{0, 0, 6, 4});
}

TEST_CASE("a watching board sees the bytes of the picture in their order")
{
    TestBoard board{12};
    NumberedRows player;
    player.show_moment({});
    draw_frame(board, player);
    CHECK(board.watched == ten_numbered_rows());
}

TEST_CASE("frames are shown when they are due; those that come too late are left out and counted")
{
    TestBoard board{12};
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

TEST_CASE("events are told before their frame, those of frames left out as well")
{
    TestBoard board{12};
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

TEST_CASE("bands that do not hold a row are reported, not waited for")
{
    TestBoard board{5};
    board.scene = compiled("kfast 1\ncanvas 6 10\nobject a fill=white { rect 0 0 6 10 }");
    board.durations = {0};
    run(board);
    CHECK(board.reported == Error::block_too_small);
    CHECK(board.reports.empty());
}

TEST_CASE("bytes that are no scene are reported, and nothing is shown")
{
    TestBoard board{12};
    board.scene = bytes({'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.',
                         'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.',
                         'n', 'o', ' ', 's', 'c', 'e', 'n', 'e', ' ', 'a', 't', ' ', 'a', 'l', 'l', '.'});
    board.durations = {0};
    run(board);
    CHECK(board.reported == Error::bad_magic);
    CHECK(board.reports.empty());
    CHECK(board.panel().areas.empty());
}

}
