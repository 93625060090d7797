#pragma once

#include "core/time/time.hpp"
#include "host/compiler/pack/byte_writer.hpp"

#include <compare>
#include <cstdint>
#include <vector>

namespace kfast {

/// When a key is, and the number of the pair of laws that governs the way from it; 0 for the last.
struct WrittenBeat {
    Time time;
    std::uint32_t laws = 0;

    friend auto operator<=>(const WrittenBeat&, const WrittenBeat&) = default;
};

using Beats = std::vector<WrittenBeat>;

/// Beats, and what their times count.
struct ClockedBeats {
    Beats beats = {};
    Clock clock = {};

    friend auto operator<=>(const ClockedBeats&, const ClockedBeats&) = default;
};

/// Appends at least one beat as the core's BeatCursor reads them (docs/format.md, "Beats"); only says so if
/// they are `usual` where they stand.
void write_beats(const ClockedBeats& clocked, const ClockedBeats& usual, ByteWriter& bytes);

/// The usual beats of what has keys of its own: a single one, at 0.
inline const ClockedBeats one_beat{{{}}};

}
