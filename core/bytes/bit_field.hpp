#pragma once

#include <cstdint>

namespace kfast {

/// Some bits of a number of `size` bits: `width` of them, at least one, from bit `shift` on; bit 0 is the
/// lowest. As parameters of a template they cost no more than numbers in an expression, also where a compiler
/// keeps programs small.
template <unsigned shift, unsigned width, unsigned size = 32>
struct BitField {
    static_assert(width >= 1 && shift + width <= size && size <= 32);

    /// The largest value that the bits hold.
    static constexpr std::uint32_t max() { return 0xFFFF'FFFFU >> (32 - width); }
    /// The value that they have in `bits`, a number of no more than `size` bits.
    static constexpr std::uint32_t get(std::uint32_t bits)
    {
        return shift + width == size ? bits >> shift : bits >> shift & max();
    }
    /// As get(), and the bits above them as higher ones of the value: 0 in what means something.
    static constexpr std::uint32_t get_with_above(std::uint32_t bits) { return bits >> shift; }
    /// A number whose other bits are 0. `value` is 0 … max(), of any integer or enumeration type.
    template <class T>
    static constexpr std::uint32_t put(T value)
    {
        return static_cast<std::uint32_t>(value) << shift;
    }
};

/// One bit of a number, which says yes (1) or no.
template <unsigned bit>
struct BitFlag {
    static constexpr std::uint32_t mask() { return std::uint32_t{1} << bit; }
    static constexpr bool get(std::uint32_t bits) { return (bits & mask()) != 0; }
    /// A number whose other bits are 0.
    static constexpr std::uint32_t put(bool is_set) { return is_set ? mask() : 0; }
};

}
