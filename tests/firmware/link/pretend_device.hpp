#pragma once

#include "core/player.hpp"
#include "core/scene/scene_view.hpp"
#include "firmware/link/device.hpp"
#include "firmware/link/input_message.hpp"
#include "firmware/link/received_drawing.hpp"
#include "host/player/received_drawing.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::test {

/// A device that keeps what it was asked for.
class PretendDevice {
public:
    link::DeviceFacts facts() const
    {
        return {.panel = {240, 135},
                .block_bytes = 100'000,
                .ram_bytes = ram_bytes,
                .serial = {"E66058388341A22C"},
                .names = {.firmware = {"0.1.0"}, .board = {"pico"}, .panel = {"st7789"}},
                .start_clip = start_clip};
    }
    link::Playing playing() const { return now; }
    link::Statistics statistics() const
    {
        return {.frames = 1000, .late = 3, .skipped = 2, .link_errors = 0, .coarse = 1};
    }
    std::span<const std::byte> played() const { return selection.scene; }
    std::span<const std::byte> built_in() const { return built_in_scene; }

    link::InputState input(std::uint8_t number) const
    {
        const auto found = inputs.find(number);
        return {.input = number,
                .name = {"gaze"},
                .min = -1000,
                .max = 1000,
                .place = found == inputs.end() ? Time{} : found->second};
    }

    Status play(const link::SceneSelection& next, const SceneView& scene)
    {
        if (next.scene.size() > largest_that_plays)
            return Status::block_too_small;
        selection = next;
        shown.assign(next.scene.begin(), next.scene.end());
        now = {};
        now.is_playing = true;
        now.home = next.home;
        now.slot = next.slot;
        now.inputs = static_cast<std::uint8_t>(scene.input_count());
        now.clip = next.clip;
        begin_player();
        return Status::ok;
    }
    void play_nothing()
    {
        stop();
        says_that_nothing_plays = true;
    }
    /// As long as asked for, so that a byte beyond is noticed.
    std::span<std::byte> lease_ram(std::uint32_t size)
    {
        if (puts_off > 0) {
            --puts_off;
            return {};
        }
        if (selection.home == link::Home::ram)
            stop();
        ram.assign(size, std::byte{0});
        ram.shrink_to_fit();
        return leased = ram;
    }
    std::span<std::byte> leased_ram() const { return leased; }
    void end_lease()
    {
        leased = {};
        ++leases_ended;
    }
    bool is_idle() const { return is_left_alone; }
    void pause() { now.is_paused = true; }
    void resume() { now.is_paused = false; }
    void seek(Time time) { now.moment = time; }
    void set_speed(std::int32_t speed) { now.speed = speed; }
    Status arm() { return set_armed(true); }
    Status disarm() { return set_armed(false); }
    void lose_computer() { ++computers_lost; }
    Status set_brightness(std::uint8_t brightness)
    {
        now.brightness = brightness;
        return Status::ok;
    }
    void set_input(std::uint32_t number, Time place) { inputs[number] = place; }
    Status set_text(std::uint32_t number, std::string_view text)
    {
        if (number == no_text)
            return Status::no_text;
        texts[number] = text;
        return Status::ok;
    }
    Status deliver(const link::DrawingPart& part) { return link::deliver(*player, part); }
    Status enter_boot_loader(Microseconds)
    {
        is_in_boot_loader = true;
        return Status::ok;
    }
    Status set_armed(bool is_armed)
    {
        if (now.arming == link::Arming::none)
            return Status::no_laser;
        now.arming = is_armed ? link::Arming::armed : link::Arming::disarmed;
        return Status::ok;
    }
    void stop()
    {
        selection = {};
        now = {};
    }

    /// What an input shows.
    ReceivedDrawing drawing(std::uint32_t input) const { return received_drawing(player->drawing(input)); }

    link::Name start_clip;
    static constexpr std::uint32_t ram_bytes = 20'000;
    static constexpr std::uint32_t no_text = 0; ///< number of an input that is none

    std::size_t largest_that_plays = 1'000'000;
    link::Playing now;
    link::SceneSelection selection;
    std::vector<std::byte> shown; ///< the scene as it was when it began to play
    std::vector<std::byte> ram;
    std::vector<std::byte> built_in_scene;
    std::map<std::uint32_t, Time> inputs;
    std::map<std::uint32_t, std::string> texts;
    bool is_in_boot_loader = false;
    int computers_lost = 0;
    bool says_that_nothing_plays = false;
    int puts_off = 0; ///< how often lease_ram() is to be called in vain
    std::span<std::byte> leased;
    int leases_ended = 0;
    bool is_left_alone = false;

private:
    /// Of a copy of the scene: that of the programme may be gone when it is told something.
    void begin_player()
    {
        const SceneView scene = *SceneView::parse(shown);
        block.assign((Player::block_bytes(scene, player_panel) + 3) / 4, 0);
        player.emplace(
            *Player::create(scene, player_panel, Fit::contain, std::as_writable_bytes(std::span{block})));
    }

    static constexpr Size player_panel{24, 17};

    std::vector<std::uint32_t> block; // words, for the player asks for an alignment of 4
    std::optional<Player> player;
};

}
