#pragma once

#include "core/bytes/bit_reader.hpp"
#include "core/bytes/byte_reader.hpp"
#include "core/time/time.hpp"

#include <cstdint>

namespace kfast {

/// A moment at which something has a key, on the clock that it goes by, and what governs the way from it to
/// the next.
struct KeyTime {
    Time time;
    std::uint32_t laws = 0;  ///< number of the pair of laws
    std::uint32_t index = 0; ///< how many come before
};

/// Reads key times in the order of their times (docs/format.md, "Key times").
class KeyTimeCursor {
public:
    /// No key times.
    KeyTimeCursor() = default;
    /// A single key time, at 0.
    static KeyTimeCursor one();
    /// Takes `bytes` as far as the key times go; `default_key_times` if they say so. What breaks off or has a
    /// form without a meaning is past the end of `bytes`.
    static KeyTimeCursor take(ByteReader& bytes, const KeyTimeCursor& default_key_times);

    bool at_end() const { return index_ == count_; }
    /// Only when not at the end, and when no time before was beyond the format's limit.
    KeyTime next();
    /// As if `last` had just been read.
    void go_on_behind(const KeyTime& last);
    /// Where take() has found them; null of one().
    const std::byte* place() const { return place_; }
    /// Of all of them.
    std::uint32_t count() const { return count_; }
    /// What their times count.
    Driver driver() const { return driver_; }

private:
    const std::byte* place_ = nullptr;
    BitReader bits_;
    std::uint32_t count_ = 0;
    std::uint32_t index_ = 0;
    Time time_;
    std::uint8_t time_bits_ = 0;
    std::uint8_t time_shift_ = 0;
    std::uint8_t law_bits_ = 0;
    Driver driver_;
};

}
