#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/time/velocity_law.hpp"

namespace kfast {

/// The laws that govern the way from one key to the next: that of x, which also governs what has no axis, and
/// that of y.
struct LawPair {
    VelocityLaw x = {};
    VelocityLaw y = {};
    friend constexpr bool operator==(const LawPair&, const LawPair&) = default;
};

/// Reads a pair as the scene format stores it.
LawPair read_law_pair(ByteReader& bytes);

}
