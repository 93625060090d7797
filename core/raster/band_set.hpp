#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// A set of bands, in memory that the caller lends.
class BandSet {
public:
    BandSet() = default;
    /// `words` has a bit for each band, at least.
    explicit BandSet(std::span<std::uint32_t> words) : words_{words} { clear(); }

    static constexpr std::size_t words_for(int bands) { return (static_cast<std::size_t>(bands) + 31) / 32; }

    void clear() { std::ranges::fill(words_, 0U); }
    /// From `begin` up to but not including `end`.
    void add(int begin, int end)
    {
        for (int band = begin; band < end; ++band)
            word(band) |= bit(band);
    }
    bool has(int band) const { return (word(band) & bit(band)) != 0; }

private:
    std::uint32_t& word(int band) const { return words_[static_cast<unsigned>(band) / 32]; }
    static constexpr std::uint32_t bit(int band)
    {
        return std::uint32_t{1} << (static_cast<unsigned>(band) % 32);
    }

    std::span<std::uint32_t> words_;
};

}
