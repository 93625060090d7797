#pragma once

#include "host/simulator/controller_model.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace kfast {

/// What an emulator recorded on the wires of a panel, and of the board's text.
enum class TraceKind : std::uint8_t {
    command,    ///< bytes with D/C low
    data,       ///< bytes with D/C high
    reset_low,  ///< the reset line
    reset_high, //
    selected,   ///< chip select is active
    deselected, //
    note,       ///< a line of text that the board printed
};

struct TraceRecord {
    TraceKind kind = TraceKind::note;
    std::chrono::nanoseconds time{}; ///< since power-on; of the first byte
    std::span<const std::byte> bytes;
    std::size_t position = 0; ///< in the trace, in bytes
};

/// Reads a trace, little-endian:
///
///     "KFTRACE1"
///     records: kind u8, time u64 in nanoseconds, count u32, `count` bytes
///
/// The records refer to `bytes`. Throws Failure with the position when the trace is damaged, times go back,
/// or a line's record carries bytes.
std::vector<TraceRecord> read_trace(std::span<const std::byte> bytes);

/// Plays what an emulator recorded into a model. Chip select counts only in traces that record it, and is
/// inactive at their beginning.
class TraceReplay {
public:
    /// `model` must outlive the replay.
    explicit TraceReplay(ControllerModel& model) : model_{model} {}

    /// Calls `on_note` with each note, when the model has received all that came before it. Throws Failure
    /// for the first mistake on the wires.
    void play(std::span<const TraceRecord> trace, const std::function<void(std::string_view note)>& on_note);

private:
    void play(const TraceRecord& record);
    void raise_reset(const TraceRecord& record);
    void expect_listener(const TraceRecord& record) const;

    ControllerModel& model_;
    bool is_selected_ = true;
    std::optional<std::chrono::nanoseconds> reset_began_; ///< the line is low
};

}
