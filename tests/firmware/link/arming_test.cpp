#include "core/scene/scene_view.hpp"
#include "firmware/link/playback_session.hpp"
#include "tests/compiled.hpp"

#include <doctest/doctest.h>

#include <vector>

/// Whether a dangerous beam may shine, as its Stage has it.
namespace kfast::test {

using namespace link;

namespace {

constexpr std::string_view scene_text = R"(kfast 1
canvas 100 100 fps=30 frames=60
object stroke stroke=white { line 20 20 80 50 }
)";

constexpr Pin arm_pin = 12;

/// Somebody at the board.
struct Finger {
    bool is_down = false;
    bool pressed(Pin pin) const { return is_down && pin == arm_pin; }
    int level(Pin) const { return 0; }
};

class Bench {
public:
    explicit Bench(bool is_laser = true)
    {
        is_armed = false;
        settings_.controls[0] = {ControlKind::button, ControlAction::arm, arm_pin, {}};
        playback_.emplace(BoardFacts{.settings = settings_,
                                     .panel_size = {256, 256},
                                     .player_bytes = beam_player_bytes,
                                     .block = std::as_writable_bytes(std::span{block_}),
                                     .built_in = scene_,
                                     .set_armed = is_laser ? set_armed : nullptr});
        playback_->begin();
        playback_->scene_started(*SceneView::parse(scene_));
    }

    PlaybackSession& playback() { return *playback_; }

    /// Long enough to be no bouncing.
    void press()
    {
        for (const bool is_down : {true, true, false, false}) {
            finger_.is_down = is_down;
            now_ = now_ + Microseconds{50'000};
            Playhead playhead = playback_->playhead();
            playback_->steer(playhead, finger_, now_);
        }
    }

    /// While no frame is drawn.
    void press_between_frames()
    {
        for (const bool is_down : {true, true, false, false}) {
            finger_.is_down = is_down;
            now_ = now_ + Microseconds{50'000};
            playback_->watch_arming(finger_, now_);
        }
    }

    static inline bool is_armed = false;

private:
    static void set_armed(bool armed) { is_armed = armed; }

    std::vector<std::byte> scene_ = compiled(scene_text);
    BoardSettings settings_;
    std::vector<std::uint32_t> block_ = std::vector<std::uint32_t>(20'000);
    std::optional<PlaybackSession> playback_;
    Finger finger_;
    Microseconds now_{};
};

}

TEST_CASE("a laser begins disarmed")
{
    Bench bench;
    CHECK(bench.playback().playing().arming == Arming::disarmed);
    CHECK_FALSE(Bench::is_armed);
}

TEST_CASE("a button arms a laser, and disarms it")
{
    Bench bench;
    bench.press();
    CHECK(Bench::is_armed);
    CHECK(bench.playback().playing().arming == Arming::armed);
    bench.press();
    CHECK_FALSE(Bench::is_armed);
    CHECK(bench.playback().playing().arming == Arming::disarmed);
}

TEST_CASE("a button disarms between frames, and when nothing plays any more")
{
    Bench bench;
    bench.press();
    bench.press_between_frames();
    CHECK_FALSE(Bench::is_armed);
    bench.press();
    CHECK(Bench::is_armed);
    bench.playback().fault();
    bench.press_between_frames();
    CHECK_FALSE(Bench::is_armed);
}

TEST_CASE("a computer arms a laser, and it is dark when the computer is gone")
{
    Bench bench;
    CHECK(bench.playback().arm() == Status::ok);
    CHECK(Bench::is_armed);
    bench.playback().lose_computer();
    CHECK_FALSE(Bench::is_armed);
    CHECK(bench.playback().playing().arming == Arming::disarmed);
    bench.playback().arm();
    CHECK(bench.playback().disarm() == Status::ok);
    CHECK_FALSE(Bench::is_armed);
}

TEST_CASE("what somebody at the board has armed does not depend on a computer")
{
    Bench bench;
    bench.press();
    bench.playback().lose_computer();
    CHECK(Bench::is_armed);
    bench.playback().arm(); // changes nothing, not even whose it is
    bench.playback().lose_computer();
    CHECK(Bench::is_armed);
}

TEST_CASE("who stands at the board disarms what the computer has armed")
{
    Bench bench;
    bench.playback().arm();
    bench.press();
    CHECK_FALSE(Bench::is_armed);
}

TEST_CASE("another scene leaves a laser as it is")
{
    Bench bench;
    bench.press();
    bench.playback().play_nothing();
    bench.playback().begin();
    bench.playback().fault();
    CHECK(Bench::is_armed);
    CHECK(bench.playback().playing().arming == Arming::armed);
}

TEST_CASE("what is no laser is not armed")
{
    Bench bench{false};
    CHECK(bench.playback().arm() == Status::no_laser);
    CHECK(bench.playback().disarm() == Status::no_laser);
    bench.press();
    CHECK(bench.playback().playing().arming == Arming::none);
    CHECK_FALSE(Bench::is_armed);
}

}
