#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

/// Stretches of pixels of the same colour, stored in words as far as they lie at their places in memory.
namespace kfast {

using Halfword [[gnu::may_alias]] = std::uint16_t;
using Word [[gnu::may_alias]] = std::uint32_t;

static_assert(std::endian::native == std::endian::little, "pixels are stored in words");

inline std::uintptr_t beyond_word(const std::byte* at) { return reinterpret_cast<std::uintptr_t>(at) % 4; }

/// Stores `halfword` `count` times. `at` is aligned to 2.
inline void fill_halfwords(std::byte* at, int count, std::uint32_t halfword)
{
    auto* single = reinterpret_cast<Halfword*>(at);
    if (count > 0 && beyond_word(at) != 0) {
        *single++ = static_cast<std::uint16_t>(halfword);
        --count;
    }
    const std::uint32_t both = halfword << 16 | halfword;
    auto* word = reinterpret_cast<Word*>(single);
    for (; count >= 8; count -= 8, word += 4) {
        word[0] = both;
        word[1] = both;
        word[2] = both;
        word[3] = both;
    }
    for (; count >= 2; count -= 2)
        *word++ = both;
    if (count > 0)
        *reinterpret_cast<Halfword*>(word) = static_cast<std::uint16_t>(halfword);
}

inline void store_triple(std::byte* at, std::uint32_t triple)
{
    at[0] = static_cast<std::byte>(triple & 255);
    at[1] = static_cast<std::byte>(triple >> 8 & 255);
    at[2] = static_cast<std::byte>(triple >> 16);
}

/// Stores three bytes, that in the lowest bits first, `count` times.
inline void fill_triples(std::byte* at, int count, std::uint32_t triple)
{
    for (; count > 0 && beyond_word(at) != 0; --count, at += 3)
        store_triple(at, triple);
    for (; count >= 4; count -= 4, at += 12) {
        auto* word = reinterpret_cast<Word*>(at);
        word[0] = triple << 24 | triple;
        word[1] = triple << 16 | triple >> 8;
        word[2] = triple << 8 | triple >> 16;
    }
    for (; count > 0; --count, at += 3)
        store_triple(at, triple);
}

/// Takes the bits `mask` of `at` from `byte`.
inline void merge(std::byte& at, std::uint32_t byte, std::uint32_t mask)
{
    at = static_cast<std::byte>((std::to_integer<std::uint32_t>(at) & ~mask) | (byte & mask));
}

/// Repeats `byte` in the bits `begin` … `end` - 1 of the row at `first`, counted from the highest of its
/// first byte; the others stay.
inline void fill_bits(std::byte* first, int begin, int end, std::uint32_t byte)
{
    if (begin >= end)
        return;
    const std::uint32_t from_begin = 0xFFU >> (begin & 7);
    const std::uint32_t until_end = 0xFF00U >> (end & 7);
    std::byte* at = first + (begin >> 3);
    std::byte* const last = first + (end >> 3);
    if (at == last)
        return merge(*at, byte, from_begin & until_end);
    merge(*at, byte, from_begin);
    std::fill(at + 1, last, static_cast<std::byte>(byte));
    if ((end & 7) != 0)
        merge(*last, byte, until_end & 0xFF);
}

}
