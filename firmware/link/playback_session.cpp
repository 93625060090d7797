#include "firmware/link/playback_session.hpp"

#include "firmware/link/received_drawing.hpp"

#include "core/beam/beam_player.hpp"
#include "core/player.hpp"
#include "firmware/version.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>

namespace kfast::link {
namespace {

/// As much of a text as fits into a name, in whole letters of UTF-8.
Name beginning_of(std::string_view text)
{
    constexpr std::size_t max = std::tuple_size_v<decltype(Name::bytes)>;
    if (text.size() <= max)
        return {text};
    const auto continues_letter = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; };
    std::size_t size = max;
    while (size > 0 && continues_letter(text[size]))
        --size;
    return {text.substr(0, size)};
}

}

std::size_t panel_player_bytes(const SceneView& scene, const BoardFacts& facts)
{
    return Player::block_bytes(scene, facts.panel_size);
}

std::size_t beam_player_bytes(const SceneView& scene, const BoardFacts& facts)
{
    return BeamPlayer::block_bytes(scene, facts.settings.beam);
}

PlaybackSession::PlaybackSession(const BoardFacts& facts)
    : facts_{facts},
      memory_{facts.block},
      interlock_{facts.set_armed},
      restarts_{facts.restarts, facts.keep},
      now_{built_in_item()},
      brightness_{facts.settings.panel.brightness},
      turned_brightness_{facts.settings.panel.brightness}
{
}

[[gnu::cold]] PlaybackSession::PlaybackItem PlaybackSession::built_in_item() const
{
    const bool is_allowed = facts_.restarts.allows_built_in();
    return {{.scene = is_allowed ? facts_.built_in : std::span<const std::byte>{},
             .home = Home::built_in,
             .clip = facts_.settings.clip},
            std::nullopt};
}

DeviceFacts PlaybackSession::facts() const
{
    return {.panel = facts_.panel_size,
            .block_bytes = static_cast<std::uint32_t>(memory_.size()),
            .ram_bytes = static_cast<std::uint32_t>(memory_.size() / 2),
            .serial = facts_.serial,
            .names = {.firmware = {version}, .board = facts_.board, .panel = facts_.panel},
            .start_clip = facts_.settings.clip,
            .restarts = facts_.restarts};
}

Playing PlaybackSession::playing() const
{
    if (!now_.scene)
        return {.brightness = brightness_, .arming = interlock_.state(), .restarts = facts_.restarts};
    return {.is_playing = true,
            .is_paused = controls_->is_paused(),
            .home = now_.selection.home,
            .slot = now_.selection.slot,
            .brightness = brightness_,
            .inputs = static_cast<std::uint8_t>(now_.scene->input_count()),
            .canvas = now_.scene->canvas(),
            .frame_rate = now_.scene->frame_rate(),
            .length = now_.scene->length(),
            .moment = moment_,
            .speed = controls_->speed(),
            .clip = controls_->clip(),
            .arming = interlock_.state(),
            .restarts = facts_.restarts};
}

InputState PlaybackSession::input(std::uint8_t number) const
{
    const InputView input = now_.scene->input(number);
    if (input.type == InputType::drawing)
        return {.input = number, .takes = input_kind(input.type), .name = beginning_of(input.name)};
    const bool is_text = input.type == InputType::text;
    return {.input = number,
            .takes = input_kind(input.type),
            .name = beginning_of(input.name),
            .min = input.min,
            .max = is_text ? static_cast<std::int32_t>(input.text.max) : input.max,
            .default_value = input.default_value,
            .place = place_of(number, input)};
}

Time PlaybackSession::place_of(std::uint32_t number, const InputView& input) const
{
    const auto placed = controls_->inputs();
    const auto found = std::ranges::find(placed, number, &PlacedInput::number);
    return found == placed.end() ? input.place_of(input.default_value) : found->place;
}

std::span<const std::byte> PlaybackSession::played() const
{
    if (now_.scene)
        return now_.selection.scene;
    return gave_way_ ? gave_way_->selection.scene : std::span<const std::byte>{};
}

Status PlaybackSession::play(const SceneSelection& selection, const SceneView& scene)
{
    if (!has_display())
        return Status::unsupported;
    const std::size_t bytes = player_bytes(scene);
    if (bytes > memory_.offset_of(selection.scene)) {
        if (now_.holds)
            end_lease();
        return Status::block_too_small;
    }
    if (bytes > memory_.offset_of(memory_.leased()))
        memory_.end_lease();
    gave_way_.reset();
    change({.selection = selection, .scene = scene});
    return Status::ok;
}

void PlaybackSession::play_nothing()
{
    memory_.end_lease();
    gave_way_.reset();
    change(built_in_item());
}

std::span<std::byte> PlaybackSession::lease_ram(std::uint32_t size)
{
    memory_.end_lease();
    if (!is_changing() && lease(size).empty()) {
        give_way();
        if (!is_changing())
            lease(size);
    }
    return memory_.leased();
}

std::span<std::byte> PlaybackSession::lease(std::uint32_t size)
{
    return memory_.lease(size, now_.scene ? player_bytes(*now_.scene) : 0, now_.selection.scene);
}

/// What plays from RAM cannot play again: its place will be used for something else.
void PlaybackSession::give_way()
{
    if (now_.selection.home != Home::ram)
        gave_way_ = now_;
    change({.selection = {}, .scene = {}, .holds = true});
}

void PlaybackSession::end_lease()
{
    memory_.end_lease();
    if (next_ && next_->holds) {
        next_.reset();
        gave_way_.reset();
    } else if (now_.holds && gave_way_) {
        change(*gave_way_);
        gave_way_.reset();
    }
}

void PlaybackSession::change(const PlaybackItem& item)
{
    if (is_drawn_)
        next_ = item;
    else
        set_current(item);
}

void PlaybackSession::set_current(const PlaybackItem& item)
{
    now_ = item;
    is_new_ = true;
    if (now_.scene)
        set_up_controls();
}

bool PlaybackSession::begin()
{
    if (next_)
        set_current(*next_);
    next_.reset();
    is_new_ = false;
    is_drawn_ = !now_.holds;
    restarts_.begins(is_drawn_ ? now_.selection.home : Home::start, now_.selection.slot);
    return is_drawn_;
}

void PlaybackSession::scene_started(const SceneView& scene)
{
    skipped_of_scene_ = 0;
    if (now_.scene)
        return;
    now_.scene = scene;
    now_.selection.scene = now_.selection.scene.first(scene.size());
    set_up_controls();
}

void PlaybackSession::set_up_controls()
{
    Controls controls{facts_.settings, *now_.scene, now_.selection.clip};
    if (controls_)
        controls.follow(*controls_);
    controls_ = controls;
    moment_ = controls_->playhead().moment();
}

void PlaybackSession::steered(const Playhead& playhead)
{
    moment_ = playhead.moment();
    obey_arming();
    if (controls_->brightness() != turned_brightness_)
        brightness_ = turned_brightness_ = controls_->brightness();
}

void PlaybackSession::obey_arming()
{
    if (controls_->take_arming())
        interlock_.toggle();
}

void PlaybackSession::frame_shown(const FrameReport& report)
{
    ++frames_;
    late_ += report.is_late ? 1 : 0;
    coarse_ += report.is_coarse ? 1 : 0;
    skipped_ += report.skipped - skipped_of_scene_;
    skipped_of_scene_ = report.skipped;
}

void PlaybackSession::fault()
{
    now_.scene.reset();
    is_drawn_ = false;
    restarts_.begins(Home::start, no_slot);
}

void PlaybackSession::pause()
{
    if (now_.scene)
        controls_->pause();
}

void PlaybackSession::resume()
{
    if (now_.scene)
        controls_->resume();
}

void PlaybackSession::seek(Time time)
{
    if (!now_.scene)
        return;
    controls_->seek(time);
    Playhead sought = controls_->playhead(); // playing() returns it before a frame shows it
    sought.seek(time);
    moment_ = sought.moment();
}

void PlaybackSession::set_speed(std::int32_t speed)
{
    if (now_.scene)
        controls_->set_speed(speed);
}

Status PlaybackSession::set_brightness(std::uint8_t brightness)
{
    if (!facts_.is_dimmable)
        return Status::unsupported;
    brightness_ = brightness;
    return Status::ok;
}

void PlaybackSession::set_input(std::uint32_t number, Time place) { controls_->place_input(number, place); }

Status PlaybackSession::set_text(std::uint32_t number, std::string_view text)
{
    if (player_ == nullptr)
        return Status::nothing_plays;
    if (now_.scene->input(number).type != InputType::text)
        return Status::no_text;
    player_->set_text(number, text);
    return Status::ok;
}

Status PlaybackSession::deliver(const DrawingPart& part)
{
    return player_ == nullptr ? Status::nothing_plays : link::deliver(*player_, part);
}

Status PlaybackSession::enter_boot_loader(Microseconds now)
{
    constexpr Microseconds time_for_the_answer{100'000};
    if (!facts_.has_boot_loader)
        return Status::unsupported;
    leaves_ = now + time_for_the_answer;
    return Status::ok;
}

}
