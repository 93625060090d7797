#include "firmware/run/controls.hpp"

#include <algorithm>

namespace kfast {
namespace {

/// From backwards to twice as fast; around the middle it stops.
std::int32_t speed_at(int level)
{
    constexpr int middle = (Controls::full_level + 1) / 2;
    constexpr int still = 2 * Controls::tremble;
    const int away = level - middle;
    if (away >= -still && away <= still)
        return 0;
    return 2 * Playhead::as_authored / middle * away;
}

/// Rounded to nearest.
Time input_place_at(int level)
{
    return {(whole_input.ticks * level + Controls::full_level / 2) / Controls::full_level};
}

}

Controls::Controls(const BoardSettings& settings, const SceneView& scene, const StoredName& clip)
    : scene_{scene}, start_{clip}, brightness_{settings.panel.brightness}
{
    std::ranges::transform(settings.controls, touches_.begin(), [&scene](const Control& control) {
        return Touch{.control = control,
                     .input = has_input(control.action) ? scene.input(control.name.view()) : std::nullopt};
    });
    for (const Touch& touch : touches_)
        if (touch.control.kind == ControlKind::button)
            release(touch); // a knob has its position when it is first read
}

void Controls::follow(const Controls& before)
{
    for (std::size_t i = 0; i < touches_.size(); ++i) {
        Touch& touch = touches_[i];
        const auto input = touch.input;
        touch = before.touches_[i];
        touch.input = input;
        if (touch.control.kind == ControlKind::knob && has_input(touch.control.action))
            touch.level = untouched;
        if (touch.control.kind == ControlKind::button && touch.pressed)
            place_input(touch, whole_input);
    }
    brightness_ = before.brightness_;
}

PlayRange Controls::range_named(const StoredName& clip) const
{
    const auto found = clip.view().empty() ? std::nullopt : scene_.clip(clip.view());
    return found ? play_range_of(*found) : play_range_of(scene_);
}

Playhead Controls::playhead_of(const StoredName& clip) const { return {range_named(clip), scene_.events()}; }

/// What is read covers the time since the last query: it counts if the bouncing was over by then.
bool Controls::has_switched(Touch& touch, bool pressed, Microseconds now)
{
    if (!touch.settled) {
        touch.settled = reached(touch.asked, touch.changed + bounce);
        touch.asked = now;
    }
    if (!touch.settled || pressed == touch.pressed)
        return false;
    touch.pressed = pressed;
    touch.settled = false;
    touch.changed = touch.asked = now;
    return true;
}

bool Controls::is_turned(Touch& touch, int level)
{
    const bool is_at_end = level == 0 || level == full_level;
    const int way = level < touch.level ? touch.level - level : level - touch.level;
    if (touch.level != untouched && way < (is_at_end ? 1 : tremble))
        return false;
    touch.level = level;
    return true;
}

void Controls::press_or_release(const Touch& touch, Playhead& playhead)
{
    if (touch.pressed)
        press(touch, playhead);
    else
        release(touch);
}

void Controls::press(const Touch& touch, Playhead& playhead)
{
    switch (touch.control.action) {
    case ControlAction::play:
        return play(touch.control.name, playhead);
    case ControlAction::pause:
        paused_ = !paused_;
        return apply_speed(playhead);
    case ControlAction::sleep:
        wants_rest_ = !wants_rest_;
        return;
    case ControlAction::input:
        return place_input(touch, whole_input);
    case ControlAction::arm:
        wants_arming_ = !wants_arming_;
        return;
    case ControlAction::place:
    case ControlAction::speed:
    case ControlAction::brightness:
        return; // only a knob can do that
    }
}

void Controls::turn(const Touch& touch, Playhead& playhead)
{
    switch (touch.control.action) {
    case ControlAction::place:
        return place(touch, playhead);
    case ControlAction::speed:
        speed_ = speed_at(touch.level);
        return apply_speed(playhead);
    case ControlAction::brightness:
        brightness_ = static_cast<std::uint8_t>(touch.level / 16);
        return;
    case ControlAction::input:
        return place_input(touch, input_place_at(touch.level));
    case ControlAction::play:
    case ControlAction::pause:
    case ControlAction::sleep:
    case ControlAction::arm:
        return; // only a button can do that
    }
}

/// A clip that repeats ends when its button is pressed again.
void Controls::play(const StoredName& clip, Playhead& playhead)
{
    const bool is_playing_it = before_ && clip_ == clip;
    if (is_playing_it && playhead.range().loop != Loop::once)
        return go_back(playhead);
    if (!before_)
        before_ = playhead;
    clip_ = clip;
    paused_ = false;
    playhead = playhead_of(clip);
    apply_speed(playhead);
}

/// A button's clip goes first: the knob's position is used when it has finished.
void Controls::place(const Touch& touch, Playhead& playhead)
{
    PlayRange range = range_named(touch.control.name);
    range.loop = Loop::once; // or the end would look like the beginning
    Playhead placed{range, scene_.events()};
    placed.seek(range.begin + Time{static_cast<std::int32_t>(std::int64_t{range.length().ticks} *
                                                             touch.level / full_level)});
    (before_ ? *before_ : playhead) = placed;
    is_placed_ = true;
    apply_speed(playhead);
}

void Controls::place_input(const Touch& touch, Time place)
{
    if (touch.input)
        place_input(*touch.input, place);
}

void Controls::place_input(std::uint32_t number, Time place)
{
    const auto end = inputs_.begin() + input_count_;
    const auto found = std::ranges::find(inputs_.begin(), end, number, &PlacedInput::number);
    if (found == end)
        ++input_count_;
    *found = {number, place};
}

void Controls::set_paused(bool paused)
{
    paused_ = paused;
    is_speed_asked_ = true;
}

void Controls::set_speed(std::int32_t speed)
{
    speed_ = speed;
    is_placed_ = false;
    is_speed_asked_ = true;
}

std::int32_t Controls::speed() const
{
    if (before_)
        return Playhead::as_authored;
    return is_placed_ ? 0 : speed_;
}

StoredName Controls::clip() const
{
    const StoredName& clip = before_ ? clip_ : start_;
    return scene_.clip(clip.view()) ? clip : StoredName{};
}

void Controls::obey(Playhead& playhead)
{
    if (sought_) {
        if (before_)
            go_back(playhead);
        playhead.seek(*sought_);
        sought_.reset();
    }
    if (is_speed_asked_)
        apply_speed(playhead);
    is_speed_asked_ = false;
}

void Controls::go_back(Playhead& playhead)
{
    playhead = *before_;
    before_.reset();
    apply_speed(playhead);
}

/// The end of a clip is shown for a frame before that.
void Controls::go_back_when_finished(Playhead& playhead)
{
    if (before_ && playhead.finished() && end_is_shown_)
        go_back(playhead);
    end_is_shown_ = before_ && playhead.finished();
}

void Controls::apply_speed(Playhead& playhead) const { playhead.set_speed(paused_ ? 0 : speed()); }

}
