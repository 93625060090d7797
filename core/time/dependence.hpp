#pragma once

#include <cstdint>

namespace kfast {

/// On which timelines and inputs something depends at a moment: a bit for each. There are as many as there
/// are, so that several may share a bit: then more is taken to move than does.
struct Dependence {
    std::uint32_t keys = 0; ///< all of them
    std::uint32_t ways = 0; ///< those between two keys that differ: it moves as these go on

    static constexpr std::uint32_t bit(std::uint32_t number) { return std::uint32_t{1} << (number % 32); }

    /// `moved` has what came to other keys, or was told something new, and what went on between its keys.
    constexpr bool is_touched_by(const Dependence& moved) const
    {
        return ((keys & moved.keys) | (ways & moved.ways)) != 0;
    }
    friend constexpr Dependence operator|(const Dependence& a, const Dependence& b)
    {
        return {a.keys | b.keys, a.ways | b.ways};
    }
    friend constexpr bool operator==(const Dependence&, const Dependence&) = default;
};

}
