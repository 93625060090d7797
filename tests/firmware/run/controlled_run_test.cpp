#include "firmware/run/run.hpp"

#include "tests/compiled.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

/// A panel that can rest, and tells what is done with it.
class StoryPanel {
public:
    static constexpr PixelFormat format = PixelFormat::rgb565;
    static constexpr Size granularity{.width = 1, .height = 1};
    static constexpr int window_bytes = 11;

    explicit StoryPanel(std::string& story) : story_{story} {}

    Size size() const { return {.width = 80, .height = 60}; }
    template <class Pause>
    void begin(Pause&&)
    {
    }
    void start(Rect area, std::span<const std::byte> pixels)
    {
        story_ += area.height == 60 ? "whole " : "part ";
        first_row_is_white =
            std::ranges::all_of(pixels.first(160), [](std::byte b) { return b == std::byte{0xFF}; });
    }
    bool busy() { return false; }
    void light() { story_ += "lit "; }
    void set_brightness(std::uint8_t) {}
    template <class Pause>
    void sleep(Pause&& pause)
    {
        story_ += "asleep ";
        pause(Microseconds{5'000});
    }
    template <class Pause>
    void wake(Pause&& pause)
    {
        story_ += "awake ";
        pause(Microseconds{120'000});
    }

    bool first_row_is_white = false;

private:
    std::string& story_;
};

static_assert(PoweredPanel<StoryPanel>);
static_assert(LightedPanel<StoryPanel>);

/// A board at 10 frames a second whose display rests during some of the calls of steer().
class TouchedBoard {
public:
    StoryPanel& panel() { return panel_; }
    Microseconds now() const { return now_; }
    void sleep_until(Microseconds moment)
    {
        if (!reached(now_, moment))
            now_ = moment;
    }
    std::span<const std::byte> scene_bytes() const { return scene; }
    std::span<std::byte> block() { return std::as_writable_bytes(std::span{block_}); }
    std::array<std::span<std::byte>, 2> bands() { return {bands_[0], bands_[1]}; }
    bool running() const { return frames_left > 0; }
    void scene_started(const SceneView&) {}
    void frame_shown(FrameReport report)
    {
        story += std::to_string(report.time.ticks / Time::ticks_per_frame) + " ";
        --frames_left;
    }
    void fault(Error error) { reported = error; }
    void steer(Playhead& playhead)
    {
        ++steered;
        if (steered == seek_at)
            playhead.seek(Time::frame(50));
    }
    bool wants_rest() { return steered >= rest_from && steered < rest_until; }
    void wait_for_blank() { story += "blank "; }
    BoardNames names() const { return {"a board", "a panel"}; }

    std::vector<std::byte> scene;
    int frames_left = 4;
    int steered = 0;
    int seek_at = 0;
    int rest_from = 0;
    int rest_until = 0;
    std::string story;
    std::optional<Error> reported;

private:
    StoryPanel panel_{story};
    std::array<std::uint32_t, 4096> block_{};
    std::array<std::vector<std::byte>, 2> bands_{std::vector<std::byte>(9600), std::vector<std::byte>(9600)};
    Microseconds now_{1'000};
};

static_assert(SteeredBoard<TouchedBoard>);
static_assert(RestingBoard<TouchedBoard>);
static_assert(SynchronizedBoard<TouchedBoard>);
static_assert(NamedBoard<TouchedBoard>);

/// Such a board that moves inputs during some of the calls of inputs().
class SensingBoard : public TouchedBoard {
public:
    std::span<const PlacedInput> inputs()
    {
        ++asked;
        return asked == move_at ? std::span{moved} : std::span<PlacedInput>{};
    }

    std::vector<PlacedInput> moved;
    int asked = 0;
    int move_at = 0;
};

static_assert(InputBoard<SensingBoard>);
static_assert(!InputBoard<TouchedBoard>);

std::vector<std::byte> moving_dot()
{
    return compiled("kfast 1\ncanvas 80 60 fps=10 frames=100\n"
                    "object a fill=white { rect 1 1 4 4; key 0 x=0; key 100 x=50 }");
}

std::vector<std::byte> still_dot()
{
    return compiled("kfast 1\ncanvas 80 60 fps=10 frames=100\nobject a fill=white { rect 1 1 4 4 }");
}

}

TEST_CASE("a board steers what is played before each frame")
{
    TouchedBoard board;
    board.scene = still_dot();
    board.seek_at = 3;
    run(board);
    CHECK(board.steered == 4);
    CHECK(board.story == "blank whole lit 0 1 50 51 ");
}

/// White reaches the upper edge if `lift` is at its most and `shift` at its least.
std::vector<std::byte> moved_square()
{
    return compiled("kfast 1\ncanvas 80 60 fps=10 frames=100\ninput shift min=0 max=1 default=1\n"
                    "input lift min=-10 max=10\ngroup g {\n"
                    "track x input=shift { at 0 0; at 1 80 }\ntrack y input=lift { at -10 120; at 10 0 }\n"
                    "object a fill=white { rect 0 0 80 60 }\n}");
}

TEST_CASE("inputs stand where the board says from then on, seen in that very frame")
{
    SensingBoard board;
    board.scene = moved_square();
    board.moved = {{0, Time{}}, {1, whole_input}};
    board.move_at = 3;
    run(board);
    CHECK(board.asked == 4);
    CHECK(board.story == "blank whole lit 0 1 blank whole 2 3 ");
    CHECK(board.panel().first_row_is_white);
}

TEST_CASE("an input that is not moved stays at its usual value")
{
    SensingBoard board;
    board.scene = moved_square();
    board.moved = {{1, whole_input}}; // what is lifted stays outside, on the right
    board.move_at = 2;
    run(board);
    CHECK(board.story == "blank whole lit 0 1 2 3 ");
    CHECK_FALSE(board.panel().first_row_is_white);
}

TEST_CASE("what is moved while the display rests is seen when it wakes")
{
    SensingBoard board;
    board.scene = moved_square();
    board.moved = {{0, Time{}}, {1, whole_input}};
    board.move_at = 1;
    board.rest_from = 1;
    board.rest_until = 4;
    run(board);
    CHECK(board.story == "asleep awake blank whole lit 0 1 2 3 ");
    CHECK(board.panel().first_row_is_white);
}

TEST_CASE("sending waits for the blank of every frame that changes anything, once")
{
    TouchedBoard board;
    board.scene = moving_dot();
    board.frames_left = 3;
    run(board);
    const auto blanks = [&board] {
        std::size_t count = 0;
        for (std::size_t at = board.story.find("blank"); at != board.story.npos;
             at = board.story.find("blank", at + 1))
            ++count;
        return count;
    };
    CHECK(blanks() == 3);
    CHECK(board.story.starts_with("blank whole lit 0 blank part "));
}

TEST_CASE("at rest nothing is shown and time stands still; then the whole picture is sent")
{
    TouchedBoard board;
    board.scene = still_dot();
    board.rest_from = 3;
    board.rest_until = 8;
    run(board);
    CHECK(board.story == "blank whole lit 0 1 asleep awake blank whole lit 2 3 ");
    CHECK(board.steered == 8 + 1);
}

TEST_CASE("a board that stops running at rest wakes its display and is done")
{
    TouchedBoard board;
    board.scene = still_dot();
    board.frames_left = 1;
    board.rest_from = 1;
    board.rest_until = 4;
    run(board);
    CHECK(board.story == "asleep awake blank whole lit 0 ");
}

TEST_CASE("where nothing was ever written a board with a name shows its test card, else the fault")
{
    for (const auto& [place, is_test_card] :
         {std::pair{std::vector<std::byte>(64, std::byte{0xFF}), true},
          std::pair{std::vector<std::byte>(64), true}, std::pair{std::vector<std::byte>{}, true},
          std::pair{std::vector<std::byte>(64, std::byte{'x'}), false}}) {
        TouchedBoard board;
        board.scene = place;
        run(board);
        CHECK(board.story == "whole lit ");
        CHECK(board.panel().first_row_is_white == is_test_card);
        CHECK(board.reported == (place.empty() ? Error::truncated : Error::bad_magic));
    }
}

}
