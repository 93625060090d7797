#pragma once

#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"
#include "firmware/chip/microseconds.hpp"
#include "firmware/link/drawing_part.hpp"
#include "firmware/link/input_message.hpp"
#include "firmware/link/message.hpp"
#include "firmware/status.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace kfast::link {

/// What a device is by its build and its settings.
struct DeviceFacts {
    Size panel{};
    std::uint32_t block_bytes = 0; ///< lent to the player
    std::uint32_t ram_bytes = 0;   ///< of the largest scene that can be played from RAM
    StoredText<24> serial{};       ///< unique to the chip
    Names names{};
    Name start_clip{}; ///< played at the start if the scene has it; empty: all of the scene
    Restarts restarts{};
};

/// A valid scene (SceneView::parse), and what of it is to be played.
struct SceneSelection {
    std::span<const std::byte> scene{}; ///< as long as it plays, its bytes stay as they are
    Home home = Home::built_in;         ///< one of the first three
    std::uint8_t slot = no_slot;
    Name clip{}; ///< one of the scene's; empty: all of it
};

// Compound requirements would be torn apart.
// clang-format off

/// What the link requires of a device. All of it returns soon: what takes time is only begun.
template <class D>
concept Device = requires(D& device, const D& same, const SceneSelection& selection, const SceneView& scene,
                          const DrawingPart& part, std::string_view text, std::uint32_t size, Time time,
                          std::int32_t speed, std::uint8_t number, Microseconds now) {
    { same.facts() } -> std::same_as<DeviceFacts>;
    { same.playing() } -> std::same_as<Playing>;
    /// Does not include link_errors, which the link counts.
    { same.statistics() } -> std::same_as<Statistics>;
    /// `number` is less than playing().inputs.
    { same.input(number) } -> std::same_as<InputState>;
    /// The bytes of the scene that plays, or shall go on; none if none does. As long as they are given here, nothing
    /// writes to them.
    { same.played() } -> std::same_as<std::span<const std::byte>>;
    /// Where a UF2 file puts a scene, perhaps with more bytes after it.
    { same.built_in() } -> std::same_as<std::span<const std::byte>>;

    /// Plays from the beginning, as authored, not paused; `scene` is that of the selection. Fails with
    /// block_too_small or unsupported, and then the scene that played plays on.
    { device.play(selection, scene) } -> std::same_as<Status>;
    /// From now on nothing plays, and the display says so.
    { device.play_nothing() } -> std::same_as<void>;
    /// Memory of `size` bytes for a scene, 1 … ram_bytes, of which nothing is played. None if what plays has to give
    /// way first: it does so soon, and this is to be called again. The memory is lent until the next call.
    { device.lease_ram(size) } -> std::same_as<std::span<std::byte>>;
    /// The memory that lease_ram() has returned; none once it is needed for something else.
    { same.leased_ram() } -> std::same_as<std::span<std::byte>>;
    /// No scene comes into the lent memory: what gave way plays again, if it can.
    { device.end_lease() } -> std::same_as<void>;
    /// Whether nothing plays because what gave way cannot play again.
    { same.is_idle() } -> std::same_as<bool>;
    { device.pause() } -> std::same_as<void>;
    { device.resume() } -> std::same_as<void>;
    /// Any time of the scene (Playhead::seek).
    { device.seek(time) } -> std::same_as<void>;
    /// Within ±Playhead::fastest.
    { device.set_speed(speed) } -> std::same_as<void>;
    /// Lets a dangerous beam shine until disarm(), or until the computer that asked for it is gone. Both fail with
    /// no_laser.
    { device.arm() } -> std::same_as<Status>;
    { device.disarm() } -> std::same_as<Status>;
    /// The computer has fallen silent for longer than it wanted to, or is gone.
    { device.lose_computer() } -> std::same_as<void>;
    /// Fails with unsupported where the display has no brightness to set.
    { device.set_brightness(number) } -> std::same_as<Status>;
    /// `number` is one of playing().inputs, and `time` within 0 … whole_input.
    { device.set_input(std::uint32_t{number}, time) } -> std::same_as<void>;
    /// UTF-8. `number` is one of playing().inputs. Fails with no_text where the input is none, and nothing_plays.
    { device.set_text(std::uint32_t{number}, text) } -> std::same_as<Status>;
    /// Its input is one of playing().inputs. Adds it to the player, by deliver() of received_drawing.hpp.
    { device.deliver(part) } -> std::same_as<Status>;
    /// Does it soon, when the answer has gone out: about a tenth of a second later. Fails with unsupported.
    { device.enter_boot_loader(now) } -> std::same_as<Status>;
};

// clang-format on

}
