#include "firmware/run/controls.hpp"

#include "tests/compiled.hpp"
#include "tests/firmware/run/pretend_pins.hpp"
#include "tests/firmware/settings/control_settings.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace kfast::test {
namespace {

constexpr Microseconds frame{33'333};

/// A scene of 60 frames with clips, and what is touched while it plays, frame by frame.
class ControlsBench {
public:
    explicit ControlsBench(BoardSettings settings)
        : controls_{settings, scene()}, playhead_{controls_.playhead()}
    {
    }

    int frame_shown() const { return playhead_.moment().ticks / Time::ticks_per_frame; }
    const Controls& controls() const { return controls_; }
    /// Where the controls want the scene's input to stand; -1 if they say nothing about it.
    int place_of(std::string_view input) const
    {
        const auto places = controls_.inputs();
        const auto found = std::ranges::find(places, *scene().input(input), &PlacedInput::number);
        return found == places.end() ? -1 : found->place.ticks;
    }

    void steer()
    {
        controls_.steer(playhead_, pins, now_);
        now_ = now_ + frame;
    }
    /// Lets frames pass.
    void run(int frames)
    {
        for (int i = 0; i < frames; ++i) {
            playhead_.advance(Time::ticks_per_frame);
            steer();
        }
    }
    /// As short as a finger can.
    void click(Pin pin)
    {
        pins.closed[pin] = true;
        steer();
        pins.closed[pin] = false;
        for (int bouncing = 3; bouncing > 0; --bouncing)
            steer();
    }

    PretendPins pins;

private:
    SceneView scene() const { return *SceneView::parse(scene_); }

    std::vector<std::byte> scene_ = compiled(
        "kfast 1\ncanvas 8 8 frames=60\ninput gaze min=-1 max=1\ninput open min=0 max=100 default=30\n"
        "group g { track x input=gaze { at -1 0; at 1 2 }; track y input=open { at 0 0; at 100 2 }\n"
        "object a fill=white { rect 1 1 2 2 } }\n"
        "clip wink from=10 to=14\nclip spin from=20 to=30 loop=repeat\n"
        "clip idle from=40 to=50 loop=repeat\n");
    Controls controls_;
    Playhead playhead_;
    Microseconds now_{1'000'000};
};

constexpr Control wink{ControlKind::button, ControlAction::play, 1, {"wink"}};
constexpr Control spin{ControlKind::button, ControlAction::play, 2, {"spin"}};
constexpr Control pause_button{ControlKind::button, ControlAction::pause, 3, {}};
constexpr Control sleep_button{ControlKind::button, ControlAction::sleep, 4, {}};
constexpr Control speed_knob{ControlKind::knob, ControlAction::speed, 26, {}};
constexpr Control place_knob{ControlKind::knob, ControlAction::place, 27, {"idle"}};
constexpr Control light_knob{ControlKind::knob, ControlAction::brightness, 28, {}};
constexpr Control gaze_knob{ControlKind::knob, ControlAction::input, 26, {"gaze"}};
constexpr Control open_knob{ControlKind::knob, ControlAction::input, 27, {"open"}};
constexpr Control open_button{ControlKind::button, ControlAction::input, 5, {"open"}};

}

TEST_CASE(
    "the whole scene is played, or the clip of the settings; one that the scene lacks is the whole scene")
{
    CHECK(ControlsBench{{}}.frame_shown() == 0);
    BoardSettings settings;
    settings.clip = {"idle"};
    CHECK(ControlsBench{settings}.frame_shown() == 40);
    settings.clip = {"gone"};
    CHECK(ControlsBench{settings}.frame_shown() == 0);
}

TEST_CASE("a button plays its clip once, then what was played before goes on where it was")
{
    ControlsBench bench{settings_with({wink})};
    bench.run(5);
    bench.click(1);
    CHECK(bench.frame_shown() == 10);
    bench.run(3);
    CHECK(bench.frame_shown() == 13);
    bench.run(2);
    CHECK(bench.frame_shown() == 5);
    bench.run(1);
    CHECK(bench.frame_shown() == 6);
}

TEST_CASE("a clip starts anew when its button is pressed again, and another button's clip takes its place")
{
    ControlsBench bench{settings_with({wink, spin})};
    bench.run(5);
    bench.click(1);
    bench.run(2);
    bench.click(1);
    CHECK(bench.frame_shown() == 10);
    bench.click(2);
    CHECK(bench.frame_shown() == 20);
    bench.click(2);
    CHECK(bench.frame_shown() == 5);
}

TEST_CASE("a clip that repeats is played until its button is pressed again")
{
    ControlsBench bench{settings_with({spin})};
    bench.run(5);
    bench.click(2);
    bench.run(35);
    CHECK(bench.frame_shown() == 25);
    bench.click(2);
    CHECK(bench.frame_shown() == 5);
}

TEST_CASE("a button that is held counts once")
{
    ControlsBench bench{settings_with({pause_button})};
    bench.pins.closed[3] = true;
    bench.run(10);
    CHECK(bench.frame_shown() == 1); // the frame that had passed before it was pressed
}

TEST_CASE("pausing stands still and goes on; a clip's button ends it")
{
    ControlsBench bench{settings_with({wink, pause_button})};
    bench.run(5);
    bench.click(3);
    bench.run(10);
    CHECK(bench.frame_shown() == 5);
    bench.click(3);
    bench.run(2);
    CHECK(bench.frame_shown() == 7);
    bench.click(3);
    bench.click(1);
    bench.run(6);
    CHECK(bench.frame_shown() == 8);
}

TEST_CASE("the sleep button asks for rest, and ends it")
{
    ControlsBench bench{settings_with({sleep_button})};
    CHECK_FALSE(bench.controls().wants_rest());
    bench.click(4);
    CHECK(bench.controls().wants_rest());
    bench.click(4);
    CHECK_FALSE(bench.controls().wants_rest());
}

TEST_CASE("a knob sets the speed: backwards, still around the middle, twice as fast")
{
    ControlsBench bench{settings_with({speed_knob})};
    bench.pins.levels[26] = Controls::full_level;
    bench.steer();
    bench.run(10);
    CHECK(bench.frame_shown() == 19); // a little less than twice: 2047 of 2048 steps
    bench.pins.levels[26] = 2048 + 40;
    bench.run(1);
    const int stood = bench.frame_shown();
    bench.run(10);
    CHECK(bench.frame_shown() == stood);
    bench.pins.levels[26] = 1024;
    bench.steer();
    bench.run(10);
    CHECK(bench.frame_shown() == stood - 10);
}

TEST_CASE("a knob says where in its clip playing stands, from its beginning to its end")
{
    ControlsBench bench{settings_with({place_knob})};
    bench.steer();
    CHECK(bench.frame_shown() == 40);
    bench.run(5);
    CHECK(bench.frame_shown() == 40);
    bench.pins.levels[27] = 2048;
    bench.steer();
    CHECK(bench.frame_shown() == 45);
    bench.pins.levels[27] = 4094;
    bench.steer();
    CHECK(bench.frame_shown() == 49);
    bench.pins.levels[27] = Controls::full_level;
    bench.steer();
    CHECK(bench.frame_shown() == 50);
}

TEST_CASE("a knob that trembles does nothing, but its ends are reached")
{
    ControlsBench bench{settings_with({light_knob})};
    bench.pins.levels[28] = 1600;
    bench.steer();
    CHECK(bench.controls().brightness() == 100);
    bench.pins.levels[28] = 1600 + Controls::tremble - 1;
    bench.steer();
    CHECK(bench.controls().brightness() == 100);
    bench.pins.levels[28] = 1600 + Controls::tremble;
    bench.steer();
    CHECK(bench.controls().brightness() == 101);
    bench.pins.levels[28] = 4090;
    bench.steer();
    bench.pins.levels[28] = Controls::full_level;
    bench.steer();
    CHECK(bench.controls().brightness() == 255);
}

TEST_CASE("a knob puts its input where it is turned, from the least to the greatest value")
{
    ControlsBench bench{settings_with({gaze_knob})};
    CHECK(bench.place_of("gaze") == -1); // not before it was read
    bench.steer();
    CHECK(bench.place_of("gaze") == 0);
    const auto turned = [&](int level) {
        bench.pins.levels[26] = level;
        bench.steer();
        return bench.place_of("gaze");
    };
    CHECK(turned(Controls::full_level) == 65536);
    CHECK(turned(819) == 13107);  // a fifth: 13107.2
    CHECK(turned(2048) == 32776); // 32776.003
    CHECK(turned(2048 + Controls::tremble - 1) == 32776);
    CHECK(turned(3000) == 48012); // 48011.7
    CHECK(turned(0) == 0);
    CHECK(bench.place_of("open") == -1);
    CHECK(bench.frame_shown() == 0); // the time goes on by itself
}

TEST_CASE("a button's input is at its greatest value while it is pressed, else at its least")
{
    ControlsBench bench{settings_with({open_button})};
    CHECK(bench.place_of("open") == 0); // whatever is usual
    bench.run(3);
    CHECK(bench.place_of("open") == 0);
    bench.pins.closed[5] = true;
    for (int i = 0; i < 10; ++i) {
        bench.run(1);
        CHECK(bench.place_of("open") == 65536);
    }
    bench.pins.closed[5] = false;
    bench.run(2);
    CHECK(bench.place_of("open") == 0);
    CHECK(bench.frame_shown() == 15);
    CHECK(bench.place_of("gaze") == -1);
}

TEST_CASE("of two controls for one input the one that moved last has it")
{
    ControlsBench bench{settings_with({open_button, open_knob, gaze_knob})};
    bench.pins.levels[27] = 819;
    bench.steer();
    CHECK(bench.place_of("open") == 13107);
    bench.pins.closed[5] = true;
    bench.steer();
    CHECK(bench.place_of("open") == 65536);
    bench.pins.levels[27] = 2 * 819;
    bench.steer();
    CHECK(bench.place_of("open") == 26214);
    bench.pins.closed[5] = false;
    bench.steer();
    CHECK(bench.place_of("open") == 0);
    CHECK(bench.controls().inputs().size() == 2);
}

TEST_CASE("an input that the scene lacks is nowhere, and the other controls do what they do")
{
    ControlsBench bench{settings_with({{ControlKind::knob, ControlAction::input, 28, {"gone"}},
                                       {ControlKind::button, ControlAction::input, 6, {"blink"}},
                                       gaze_knob})};
    bench.pins.closed[6] = true;
    bench.pins.levels[28] = 3000;
    bench.pins.levels[26] = Controls::full_level;
    bench.steer();
    CHECK(bench.controls().inputs().size() == 1);
    CHECK(bench.place_of("gaze") == 65536);
}

TEST_CASE("a button's clip goes before a knob's place, which is taken up when it has finished")
{
    ControlsBench bench{settings_with({wink, place_knob})};
    bench.steer();
    bench.click(1);
    CHECK(bench.frame_shown() == 10);
    bench.pins.levels[27] = 2048;
    bench.run(2);
    CHECK(bench.frame_shown() == 12);
    bench.run(3);
    CHECK(bench.frame_shown() == 45);
    bench.run(3);
    CHECK(bench.frame_shown() == 45);
}

}
