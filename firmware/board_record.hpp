#pragma once

#include "core/byte_reader.hpp"
#include "core/crc32.hpp"
#include "firmware/board_settings.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kfast {

/// The settings as they lie in flash, little-endian:
///
///     "KFBS"  version u16 (1)  bytes of the fields u16
///     fields: controller, rotation, flags (1 bgr, 2 inverted, 4 tearing effect), brightness: u8 each
///             glass width, height, column, row: u16 each
///             bus u8, I²C address u8, pins u8 x 8 (255: none), bus clock u32, clip 24 bytes
///             controls x 8: kind, action, pin: u8 each, 0, name of clip or input 24 bytes
///     CRC-32 of all that, u32
inline constexpr std::size_t board_record_fields = 4 + 8 + 2 + 8 + 4 + 24 + 8 * 28;
inline constexpr std::size_t board_record_bytes = 8 + board_record_fields + 4;
using BoardRecord = std::array<std::byte, board_record_bytes>;

/// Any settings, right or wrong.
BoardRecord board_record(const BoardSettings& settings);

/// What a record holds; nothing if it is damaged, of another version, or no record, or if a number in it has
/// no meaning. Pins and sizes may still contradict each other or the chip (board_rules.hpp). More bytes
/// may follow.
std::optional<BoardSettings> read_board_record(std::span<const std::byte> bytes);

}
