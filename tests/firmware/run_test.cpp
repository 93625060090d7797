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
    static constexpr int window_bytes = 9;

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
            arrive();
        return true;
    }

    bool is_sending() const { return polls_left_ != 0; }

    std::vector<Rect> areas;
    std::array<std::byte, 3 * 10> shown{};

private:
    void arrive()
    {
        const Rect area = areas.back();
        const std::size_t stride = row_bytes(format, area.width);
        for (int row = 0; row < area.height; ++row)
            std::copy_n(on_their_way_.begin() + static_cast<std::ptrdiff_t>(stride) * row, stride,
                        shown.begin() + 3 * (area.y + row) + area.x / 2);
    }

    std::span<const std::byte> on_their_way_;
    int polls_left_ = 0;
};

/// Fills every row with its number when the panel has to be drawn; then nothing changes any more.
class NumberedRows {
public:
    void show_moment(Time moment) { shown.push_back(moment.ticks / Time::ticks_per_frame); }
    void redraw()
    {
        ++redraws;
        row_ = 0;
    }

    template <PixelFormat format>
    std::span<const Change> draw_changes(std::span<std::byte> pixels, Size granularity, int)
    {
        const int room = static_cast<int>(pixels.size()) / 3;
        const int rows = std::min(room - room % granularity.height, 10 - row_);
        if (rows == 0)
            return {};
        change_ = {{0, row_, 6, rows}, pixels.first(static_cast<std::size_t>(3 * rows))};
        for (int i = 0; i < 3 * rows; ++i)
            pixels[static_cast<std::size_t>(i)] = static_cast<std::byte>(row_ + i / 3);
        row_ += rows;
        return {&change_, 1};
    }

    std::vector<int> shown;
    int redraws = 0;

private:
    int row_ = 0;
    Change change_;
};

/// An area filled with a byte.
struct Patch {
    Rect area;
    std::byte fill{};
};

/// Draws patches, the next few with every call, and spoils what the buffer held before.
class Patches {
public:
    Patches(const SlowPanel& panel, std::vector<std::vector<Patch>> strips)
        : panel_{panel}, strips_{std::move(strips)}
    {
    }

    template <PixelFormat format>
    std::span<const Change> draw_changes(std::span<std::byte> pixels, Size granularity, int window_bytes)
    {
        CHECK(granularity == SlowPanel::granularity);
        CHECK(window_bytes == SlowPanel::window_bytes);
        was_sending.push_back(panel_.is_sending());
        std::ranges::fill(pixels, std::byte{0xEE});
        changes_.clear();
        if (was_sending.size() <= strips_.size())
            for (const Patch& patch : strips_[was_sending.size() - 1]) {
                const auto count =
                    row_bytes(format, patch.area.width) * static_cast<std::size_t>(patch.area.height);
                std::ranges::fill(pixels.first(count), patch.fill);
                changes_.push_back({patch.area, pixels.first(count)});
                pixels = pixels.subspan(count);
            }
        return changes_;
    }

    std::vector<bool> was_sending; ///< at each call

private:
    const SlowPanel& panel_;
    std::vector<std::vector<Patch>> strips_;
    std::vector<Change> changes_;
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
    void watch(Rect area, std::span<const std::byte> pixels)
    {
        watched_areas.push_back(area);
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
    std::vector<Rect> watched_areas;
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
static_assert(!RedrawingBoard<TestBoard>);

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

std::array<std::byte, 30> ten_numbered_rows()
{
    std::array<std::byte, 30> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i] = static_cast<std::byte>(i / 3);
    return rows;
}

/// Whose display loses its memory before some of the frames.
class ForgetfulBoard : public TestBoard {
public:
    using TestBoard::TestBoard;

    bool wants_redraw() { return std::ranges::count(lost_before, static_cast<int>(asked++)) != 0; }

    std::vector<int> lost_before;
    int asked = 0;
};

static_assert(RedrawingBoard<ForgetfulBoard>);

/// Notes how many areas have been sent when it listens.
class CuriousBoard : public TestBoard {
public:
    using TestBoard::TestBoard;

    void listen() { heard_after.push_back(panel().areas.size()); }

    std::vector<std::size_t> heard_after;
};

static_assert(ListeningBoard<CuriousBoard>);
static_assert(!ListeningBoard<TestBoard>);

}

TEST_CASE("the bands make up the picture although each is sent while the next is drawn")
{
    TestBoard board{12};
    NumberedRows player;
    draw_frame(board, player);
    CHECK(board.panel().shown == ten_numbered_rows());
    CHECK(board.panel().areas == std::vector<Rect>{{0, 0, 6, 4}, {0, 4, 6, 4}, {0, 8, 6, 2}});
}

TEST_CASE("areas of one buffer are sent one after another, the last while the other buffer is drawn")
{
    TestBoard board{12};
    Patches player{
        board.panel(),
        {{{{0, 0, 2, 2}, std::byte{0x11}}, {{4, 0, 2, 4}, std::byte{0x22}}, {{0, 2, 2, 2}, std::byte{0x33}}},
         {{{0, 4, 6, 2}, std::byte{0x44}}},
         {{{2, 6, 4, 2}, std::byte{0x55}}, {{0, 8, 2, 2}, std::byte{0x66}}}}};
    draw_frame(board, player);
    CHECK(board.panel().shown ==
          std::array<std::byte, 30>{std::byte{0x11}, std::byte{},     std::byte{0x22},
                                    std::byte{0x11}, std::byte{},     std::byte{0x22}, //
                                    std::byte{0x33}, std::byte{},     std::byte{0x22},
                                    std::byte{0x33}, std::byte{},     std::byte{0x22}, //
                                    std::byte{0x44}, std::byte{0x44}, std::byte{0x44},
                                    std::byte{0x44}, std::byte{0x44}, std::byte{0x44}, //
                                    std::byte{},     std::byte{0x55}, std::byte{0x55},
                                    std::byte{},     std::byte{0x55}, std::byte{0x55}, //
                                    std::byte{0x66}, std::byte{},     std::byte{},
                                    std::byte{0x66}, std::byte{},     std::byte{}});
    CHECK(player.was_sending == std::vector{false, true, true, true});
    CHECK_FALSE(board.panel().is_sending());
}

TEST_CASE("a band has as many rows as its buffer holds and the panel's granularity allows")
{
    TestBoard board{17};
    CHECK(rows_per_band(board.panel(), 17) == 4);
    CHECK(rows_per_band(board.panel(), 5) == 0);
}

TEST_CASE("a watching board sees every area and its pixels, in the order in which they are sent")
{
    TestBoard board{12};
    NumberedRows player;
    draw_frame(board, player);
    CHECK(board.watched_areas == board.panel().areas);
    CHECK(std::ranges::equal(board.watched, ten_numbered_rows()));
}

TEST_CASE("a board listens before each part of a picture")
{
    CuriousBoard board{12};
    NumberedRows player;
    draw_frame(board, player);
    CHECK(board.heard_after == std::vector<std::size_t>{0, 1, 2, 3});
}

TEST_CASE("a frame in which nothing changes sends nothing and is shown all the same")
{
    TestBoard board{12};
    NumberedRows player;
    board.durations = {0, 0, 0, 0};
    play(board, player, hundred_frames(), {50'000, board.now()});
    CHECK(board.panel().areas.size() == 3);
    CHECK(board.reports.size() == 4);
    CHECK(board.reports.back().time == Time::frame(3));
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

TEST_CASE("frames do not drift in an hour, nor when the clock wraps")
{
    constexpr std::uint32_t rate = 29'970; // in 1000 s
    constexpr std::uint32_t minutes = 100; // the clock wraps every 71.6
    TestBoard board{12};
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
    TestBoard board{12};
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
    CHECK(board.panel().areas.empty());
}

TEST_CASE("bytes that are no scene are reported, and the panel is drawn once")
{
    TestBoard board{12};
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
