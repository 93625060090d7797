#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kfast {

/// What an emulator saw on the wires of a panel, and heard from the board.
enum class TraceKind : std::uint8_t {
    command,    ///< bytes with D/C low
    data,       ///< bytes with D/C high
    reset_low,  ///< the reset line
    reset_high, //
    selected,   ///< chip select is active
    deselected, //
    note,       ///< a line of text that the board told
};

struct TraceRecord {
    TraceKind kind = TraceKind::note;
    std::chrono::nanoseconds time{}; ///< since the power came on; of the first byte
    std::span<const std::byte> bytes;
    std::size_t position = 0; ///< in the trace, in bytes
};

/// Reads a trace, little-endian:
///
///     "KFTRACE1"
///     records: kind u8, time u64 in nanoseconds, count u32, `count` bytes
///
/// The records look into `bytes`. Throws Failure with the position when the trace is damaged, times go back,
/// or a line's record carries bytes.
std::vector<TraceRecord> read_trace(std::span<const std::byte> bytes);

}
