#pragma once

#include "core/playhead.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/scene/scene_view.hpp"
#include "firmware/chip/microseconds.hpp"
#include "firmware/run/placed_input.hpp"
#include "firmware/settings/board_settings.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace kfast {

// Compound requirements would be torn apart.
// clang-format off

/// Where the state of controls is read.
template <class T>
concept TouchedPins = requires(T& pins, Pin pin) {
    /// Whether the button is closed, or has been since the last query.
    { pins.pressed(pin) } -> std::same_as<bool>;
    /// The position of the knob: 0 … Controls::full_level.
    { pins.level(pin) } -> std::same_as<int>;
};

// clang-format on

/// What the buttons and knobs of a board do to what is played, and what others may ask for: of two
/// that want different things, the one that moved last wins. A clip that the scene does not have
/// represents the whole scene, and an input that it does not have is ignored.
class Controls {
public:
    static constexpr int full_level = 4095;
    /// The noise of a knob that is not touched is less than this.
    static constexpr int tremble = 24;
    /// Changes of a switch within this time after it has changed are bouncing.
    static constexpr Microseconds bounce{20'000};

    /// `clip` is played at first. The bytes of `scene` must outlive the controls.
    Controls(const BoardSettings& settings, const SceneView& scene, const StoredName& clip);
    /// Begins with the clip of the settings.
    Controls(const BoardSettings& settings, const SceneView& scene) : Controls{settings, scene, settings.clip}
    {
    }

    /// Another scene was played until now, on the same board: what was touched then has had its effect. But
    /// an input of this scene is set by its control.
    void follow(const Controls& before);

    /// What is played at first.
    Playhead playhead() const { return playhead_of(start_); }

    /// Reads every control and does what it asks.
    template <TouchedPins Pins>
    void steer(Playhead& playhead, Pins& pins, Microseconds now)
    {
        go_back_when_finished(playhead);
        obey(playhead);
        for (Touch& touch : touches_) {
            if (touch.control.kind == ControlKind::button) {
                if (has_switched(touch, pins.pressed(touch.control.pin), now))
                    press_or_release(touch, playhead);
            } else if (touch.control.kind == ControlKind::knob) {
                if (is_turned(touch, pins.level(touch.control.pin)))
                    turn(touch, playhead);
            }
        }
    }

    /// Called between two calls of steer(), which may be seconds: reads the buttons that arm, and no others.
    template <TouchedPins Pins>
    void watch_arming(Pins& pins, Microseconds now)
    {
        for (Touch& touch : touches_) {
            const Control& control = touch.control;
            if (control.kind == ControlKind::button && control.action == ControlAction::arm &&
                has_switched(touch, pins.pressed(control.pin), now) && touch.pressed)
                wants_arming_ = !wants_arming_;
        }
    }

    // Requests of those who have no control. They are executed by the next steer().
    void pause() { set_paused(true); }
    void resume() { set_paused(false); }
    /// Within ±Playhead::fastest. A button's clip is played as authored all the same.
    void set_speed(std::int32_t speed);
    /// Any time of the scene (Playhead::seek). A button's clip ends.
    void seek(Time time) { sought_ = time; }
    /// `number` is less than the scene's input_count().
    void place_input(std::uint32_t number, Time place);

    bool is_paused() const { return paused_; }
    /// The speed when it is not paused, Q16 of the authored one.
    std::int32_t speed() const;
    /// What is played; empty: the whole scene.
    StoredName clip() const;

    /// The values of inputs that were set, each once with its last value. Valid until steer()
    /// or place_input() is called again.
    std::span<const PlacedInput> inputs() const { return std::span{inputs_}.first(input_count_); }
    /// Whether the display is to be off.
    bool wants_rest() const { return wants_rest_; }
    /// Whether a button to arm was pressed an odd number of times since the last query.
    bool take_arming() { return std::exchange(wants_arming_, false); }
    /// The brightness of the display, as the settings or a knob set it.
    std::uint8_t brightness() const { return brightness_; }

private:
    static constexpr int untouched = -1;

    struct Touch {
        Control control;
        std::optional<std::uint32_t> input; ///< the number of the input of the scene that the control sets
        bool pressed = false;
        bool settled = true;    ///< whether the button has stopped bouncing
        Microseconds changed{}; ///< if not settled, when it was last pressed or released
        Microseconds asked{};   ///< if not settled, when it was last queried
        int level = untouched;  ///< the level of a knob when it last did something
    };

    PlayRange range_named(const StoredName& clip) const;
    Playhead playhead_of(const StoredName& clip) const;
    static bool has_switched(Touch& touch, bool pressed, Microseconds now);
    static bool is_turned(Touch& touch, int level);
    void press_or_release(const Touch& touch, Playhead& playhead);
    void press(const Touch& touch, Playhead& playhead);
    void release(const Touch& touch) { place_input(touch, {}); }
    void set_paused(bool paused);
    void obey(Playhead& playhead);
    void turn(const Touch& touch, Playhead& playhead);
    void play(const StoredName& clip, Playhead& playhead);
    void place(const Touch& touch, Playhead& playhead);
    void place_input(const Touch& touch, Time place);
    void go_back(Playhead& playhead);
    void go_back_when_finished(Playhead& playhead);
    void apply_speed(Playhead& playhead) const;

    SceneView scene_;
    StoredName start_;
    std::array<Touch, BoardSettings::max_controls> touches_;
    std::array<PlacedInput, kfb::max_inputs> inputs_;
    std::size_t input_count_ = 0;                ///< of inputs_
    std::optional<Playhead> before_;             ///< what was played before a button's clip
    StoredName clip_;                            ///< of the button that is being played
    std::int32_t speed_ = Playhead::as_authored; ///< a button's clip is always played as authored
    bool is_placed_ = false;                     ///< whether a knob sets the position of playing
    bool end_is_shown_ = false;                  ///< of a button's clip
    bool paused_ = false;
    bool is_speed_asked_ = false; ///< requested by somebody without a control, and not yet executed
    std::optional<Time> sought_;  ///< requested by somebody without a control, and not yet executed
    bool wants_rest_ = false;
    bool wants_arming_ = false;
    std::uint8_t brightness_;
};

}
