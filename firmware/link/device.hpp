#pragma once

#include "core/time.hpp"
#include "firmware/link/drawing_part.hpp"
#include "firmware/link/message.hpp"
#include "firmware/status.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::link {

/// What a device is by its build and its settings.
struct DeviceFacts {
    Size panel{};
    std::uint32_t block_bytes = 0; ///< lent to the player
    std::uint32_t ram_bytes = 0;   ///< of the largest scene that can be played from RAM
    StoredText<24> serial{};       ///< unique to the chip
    Names names{};
};

/// A scene that was found whole (SceneView::parse), and what of it is to be played.
struct Programme {
    std::span<const std::byte> scene{}; ///< as long as it plays, its bytes stay as they are
    Home home = Home::built_in;         ///< not Home::here
    std::uint8_t slot = no_slot;
    Name clip{}; ///< one of the scene's; empty: all of it
};

// Compound requirements would be torn apart.
// clang-format off

/// What the link asks of a device. All of it returns soon: what takes time begins.
template <class D>
concept Device = requires(D& device, const D& same, const Programme& programme, const DrawingPart& part,
                          std::uint32_t size, Time time, std::int32_t speed, std::uint8_t number) {
    { same.facts() } -> std::same_as<DeviceFacts>;
    { same.playing() } -> std::same_as<Playing>;
    /// Without link_errors, which the link counts.
    { same.statistics() } -> std::same_as<Statistics>;
    /// The bytes of the scene that plays; none if none does. As long as they are told here, nothing writes to them.
    { same.played() } -> std::same_as<std::span<const std::byte>>;
    /// Where a UF2 file puts a scene, perhaps with more bytes after it.
    { same.built_in() } -> std::same_as<std::span<const std::byte>>;

    /// From the beginning, as authored, not paused. Fails with block_too_small, and then what played plays on.
    { device.play(programme) } -> std::same_as<Status>;
    /// Memory of `size` bytes for a scene, at most ram_bytes, of which nothing is played: what was played from
    /// there gives way to something else before this returns. It is lent until the next call.
    { device.lend_ram(size) } -> std::same_as<std::span<std::byte>>;
    { device.pause() } -> std::same_as<void>;
    { device.resume() } -> std::same_as<void>;
    /// Any time of the scene (Playhead::seek).
    { device.seek(time) } -> std::same_as<void>;
    /// Within ±Playhead::fastest.
    { device.set_speed(speed) } -> std::same_as<void>;
    /// Fails with unsupported where the display has none to set.
    { device.set_brightness(number) } -> std::same_as<Status>;
    /// `number` is one of playing().inputs, and `time` within 0 … whole_input.
    { device.set_input(std::uint32_t{number}, time) } -> std::same_as<void>;
    /// Its input is one of playing().inputs. Tells it to the player that plays: tell() does it (told_drawing.hpp).
    { device.tell(part) } -> std::same_as<Status>;
    /// Soon, when the answer has gone out: about a tenth of a second later. Fails with unsupported.
    { device.enter_boot_loader() } -> std::same_as<Status>;
};

// clang-format on

}
