#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace kfast {

/// A pattern that repeats along strokes: a dash, a gap, a dash, a gap, …
struct Dashes {
    static constexpr std::uint32_t max_lengths = 6;

    std::array<std::uint32_t, max_lengths> lengths{}; ///< of dashes and gaps alternately, in 1/4096 px
    std::uint32_t count = 0;                          ///< of the lengths; even. 0: strokes are not dashed
    std::uint32_t period = 0;                         ///< the sum of the lengths
    std::uint32_t offset = 0; ///< into the pattern, where strokes begin; below the period
    std::uint32_t max = 0;    ///< dashes in an object; beyond them its strokes are drawn whole

    /// In 1/16384 px: a track has 1/64 px. A length below 0 is 0; without any length there are no dashes.
    /// With dots, a dash without length is a short one, so that caps know its direction; else it is not
    /// drawn.
    [[gnu::cold]] static Dashes of(std::span<const std::int32_t> lengths, std::int32_t offset, bool has_dots);

    /// A place in the pattern: which length it is in, and how far from its end.
    struct Place {
        std::uint32_t index = 0;
        std::uint32_t left = 0; ///< above 0

        bool is_dash() const { return index % 2 == 0; }
    };

    /// Where a stroke is that far from where the pattern began; at a border, behind it.
    [[gnu::cold]] Place at(std::uint32_t length) const;
    /// Whether a dash ends there, or goes on.
    bool is_drawn_before(std::uint32_t length) const { return at(length % period + period - 1).is_dash(); }
};

}
