#include "firmware/run/controls.hpp"

#include "tests/compiled.hpp"
#include "tests/firmware/run/pretend_pins.hpp"
#include "tests/firmware/settings/control_settings.hpp"

#include <doctest/doctest.h>

/// What controls make of a switch that bounces.
namespace kfast::test {
namespace {

/// A button that switches the display off and on, and is an input of the scene, asked about at moments in
/// microseconds.
class AskedButton {
public:
    /// Whether the display rests then.
    bool at(std::uint32_t time, bool closed)
    {
        pins_.closed[4] = closed;
        controls_.steer(playhead_, pins_, Microseconds{time});
        return controls_.wants_rest();
    }
    /// Whether the input is at its greatest value then, and not at its least.
    bool holds_at(std::uint32_t time, bool closed)
    {
        at(time, closed);
        REQUIRE(controls_.inputs().size() == 1);
        const Time place = controls_.inputs().front().place;
        CHECK((place == Time{} || place == whole_input));
        return place == whole_input;
    }

private:
    static constexpr Control sleep_button{ControlKind::button, ControlAction::sleep, 4, {}};
    static constexpr Control input_button{ControlKind::button, ControlAction::input, 4, {"open"}};

    std::vector<std::byte> scene_ = compiled(
        "kfast 1\ncanvas 8 8 frames=9\ninput open min=0 max=100\n"
        "group g { track x input=open { at 0 0; at 100 2 }; object a fill=white { rect 1 1 2 2 } }\n");
    Controls controls_{settings_with({sleep_button, input_button}), *SceneView::parse(scene_)};
    Playhead playhead_ = controls_.playhead();
    PretendPins pins_;
};

}

TEST_CASE("what a switch does within 20 ms of a change is bouncing")
{
    AskedButton button;
    CHECK(button.at(100'000, true));
    CHECK(button.at(105'000, false));
    CHECK(button.at(110'000, true));
    CHECK(button.at(120'000, false)); // tells of what happened since 110 ms
    CHECK(button.at(130'000, false)); // open
    CHECK(button.at(150'000, true));
    CHECK_FALSE(button.at(151'000, true));
}

TEST_CASE("a release that bounces after it was seen is no press, however late the next question comes")
{
    AskedButton button;
    CHECK(button.at(100'000, true));
    CHECK(button.at(133'000, true));
    CHECK(button.at(166'000, true));
    CHECK(button.at(200'000, false)); // the release, in the middle of its bouncing
    CHECK(button.at(233'000, true));  // an edge at 201 ms, remembered by the pin
    CHECK(button.at(266'000, false));
    CHECK_FALSE(button.at(300'000, true));
}

TEST_CASE("a button that nobody has touched for an hour works, whatever the clock's bits are by then")
{
    constexpr std::uint32_t minute = 60'000'000;
    for (const std::uint32_t pause : {34 * minute, 36 * minute, 50 * minute, 71 * minute}) {
        AskedButton button;
        CHECK_FALSE(button.at(100'000, false));
        CHECK(button.at(pause, true));
        CHECK(button.at(pause + 33'000, false));
        CHECK(button.at(pause + 66'000, false));
        CHECK(button.at(pause + 99'000, false));
        CHECK(button.at(pause + 132'000, false));
        CHECK_FALSE(button.at(2 * pause + 132'000, true));
    }
}

TEST_CASE("a button's input follows the button and not its bouncing")
{
    AskedButton button;
    CHECK_FALSE(button.holds_at(50'000, false));
    CHECK(button.holds_at(100'000, true));
    CHECK(button.holds_at(105'000, false));
    CHECK(button.holds_at(110'000, true));
    CHECK(button.holds_at(125'000, true));
    CHECK(button.holds_at(200'000, true));
    CHECK_FALSE(button.holds_at(300'000, false)); // let go
    CHECK_FALSE(button.holds_at(305'000, true));
    CHECK_FALSE(button.holds_at(315'000, false));
    CHECK_FALSE(button.holds_at(330'000, false));
    CHECK(button.holds_at(400'000, true));
}

}
