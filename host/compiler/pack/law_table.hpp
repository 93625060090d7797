#pragma once

#include "core/time/velocity_law.hpp"
#include "host/compiler/pack/byte_writer.hpp"
#include "host/text/source.hpp"

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

}
