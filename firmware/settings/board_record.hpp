#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/bytes/crc32.hpp"
#include "firmware/settings/board_settings.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kfast {

/// The settings as they are stored in flash, little-endian:
///
///     "KFBS"  version u16 (1, or 2)  bytes of the fields u16
///     fields: controller, rotation, flags (1 bgr, 2 inverted, 4 tearing effect), brightness: u8 each
///             glass width, height, column, row: u16 each
///             bus u8, I²C address u8, pins u8 x 8 (255: none), bus clock u32, clip 24 bytes
///             controls x 8: kind, action, pin: u8 each, 0, name of clip or input 24 bytes
///     fields of version 2 besides: pins of ldac and blank, u8 each
///             the beam's rate u32, lit step u16, travel step u16
///             its dwells at corners, lit, at arrival, before it leaves, light delay, least refresh: u8 each
///             resolution u16, brightness u8, flags (1 laser) u8, where it is parked: x, y, i16 each
///     CRC-32 of all that, u32
///
/// Settings that are about no beam are written as version 1, which older firmware reads.
inline constexpr std::size_t panel_record_fields = 4 + 8 + 2 + 8 + 4 + 24 + 8 * 28;
inline constexpr std::size_t beam_record_fields = panel_record_fields + 2 + 4 + 2 + 2 + 6 + 2 + 1 + 1 + 4;
/// The size of the longest record.
inline constexpr std::size_t board_record_bytes = 8 + beam_record_fields + 4;

/// A record as long as its version.
class BoardRecord {
public:
    explicit BoardRecord(std::size_t size) : size_{size} {}

    std::size_t size() const { return size_; }
    std::byte* begin() { return bytes_.data(); }
    std::byte* end() { return begin() + size_; }
    const std::byte* begin() const { return bytes_.data(); }
    const std::byte* end() const { return begin() + size_; }
    std::byte& operator[](std::size_t at) { return bytes_[at]; }

private:
    std::array<std::byte, board_record_bytes> bytes_{};
    std::size_t size_;
};

/// The record of any settings, valid or not.
BoardRecord board_record(const BoardSettings& settings);

/// The settings in a record of either version; nothing if it is damaged, of another version, or no record, or
/// if a number in it has no meaning in its version. Pins and sizes may still contradict each other or the
/// chip (board_rules.hpp). More bytes may follow.
[[gnu::cold]] std::optional<BoardSettings> read_board_record(std::span<const std::byte> bytes);

}
