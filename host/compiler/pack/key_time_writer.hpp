#pragma once

#include "core/time/time.hpp"
#include "host/compiler/pack/byte_writer.hpp"

#include <compare>
#include <cstdint>
#include <vector>

namespace kfast {

/// When a key is, and the number of the pair of laws that governs the way from it; 0 for the last.
struct WrittenKeyTime {
    Time time;
    std::uint32_t laws = 0;

    friend auto operator<=>(const WrittenKeyTime&, const WrittenKeyTime&) = default;
};

using KeyTimes = std::vector<WrittenKeyTime>;

/// KeyTimes, and what their times count.
struct DrivenKeyTimes {
    KeyTimes key_times = {};
    Driver driver = {};

    friend auto operator<=>(const DrivenKeyTimes&, const DrivenKeyTimes&) = default;
};

/// Appends at least one key time as the core's KeyTimeCursor reads them (docs/format.md, "Key times"); only
/// says so if they are `default_key_times` where they stand.
void write_key_times(const DrivenKeyTimes& driven, const DrivenKeyTimes& default_key_times,
                     ByteWriter& bytes);

/// The usual key times of what has keys of its own: a single one, at 0.
inline const DrivenKeyTimes one_key_time{{{}}};

}
