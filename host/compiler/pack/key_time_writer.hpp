#pragma once

#include "core/time/time.hpp"
#include "core/time/velocity_law.hpp"
#include "host/compiler/pack/byte_writer.hpp"
#include "host/text/source.hpp"

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

namespace kfast {

/// The pairs of velocity laws that keys refer to by their numbers: each pair is stored once, constant and
/// constant (number 0) never.
class LawTable {
public:
    /// `place` is that of the key. A pair for which there is no number left is noted, and has number 0.
    std::uint32_t number_of(const LawPair& laws, SourceSpan place);

    /// At most kfb::max_law_pairs.
    std::size_t count() const { return pairs_.size(); }
    /// The pairs as the format has them.
    std::vector<std::byte> bytes() const;
    /// The first key for whose pair there was no number left.
    std::optional<SourceSpan> first_beyond() const { return first_beyond_; }

private:
    std::vector<LawPair> pairs_;
    std::optional<SourceSpan> first_beyond_;
};

/// The time of a key, and the number of the pair of laws to the next; 0 for the last.
struct WrittenKeyTime {
    Time time;
    std::uint32_t laws = 0;

    friend auto operator<=>(const WrittenKeyTime&, const WrittenKeyTime&) = default;
};

using KeyTimes = std::vector<WrittenKeyTime>;

/// KeyTimes, and what they go by.
struct DrivenKeyTimes {
    KeyTimes key_times = {};
    Driver driver = {};

    friend auto operator<=>(const DrivenKeyTimes&, const DrivenKeyTimes&) = default;
};

/// Appends at least one key time as the core's KeyTimeCursor reads them (docs/format.md, "Key times"); only
/// says so if they are `default_key_times`.
void write_key_times(const DrivenKeyTimes& driven, const DrivenKeyTimes& default_key_times,
                     ByteWriter& bytes);

/// The default key times of what has keys of its own: a single one, at 0.
inline const DrivenKeyTimes one_key_time{{{}}};

}
