// What the compiler calls for copies and fills, and the library's headers for the length of a text, even
// without a C library. Copies and fills go in words as far as the addresses allow it, because a Cortex-M0
// reads and writes words only at multiples of four. Only for device images, compiled with
// -fno-tree-loop-distribute-patterns, or these loops would become calls to themselves.

#include "core/pixel/pixel_coding.hpp"

#include <cstddef>
#include <cstdint>

namespace {

using kfast::beyond_word;
using kfast::Word;

bool lie_alike(const std::byte* a, const std::byte* b) { return beyond_word(a) == beyond_word(b); }

/// Most copies and fills are of small structures: whole words, which take a loop of four instructions each.
constexpr std::size_t small_size = 64;

bool is_small(std::uintptr_t places, std::size_t count)
{
    return ((places | count) & 3) == 0 && count - 1 < small_size;
}

std::uintptr_t place_of(const void* at) { return reinterpret_cast<std::uintptr_t>(at); }

void set_words(std::byte*& at, std::size_t& count, std::uint32_t word)
{
    for (; count >= 16; count -= 16, at += 16) {
        auto* words = reinterpret_cast<Word*>(at);
        words[0] = word;
        words[1] = word;
        words[2] = word;
        words[3] = word;
    }
    for (; count >= 4; count -= 4, at += 4)
        *reinterpret_cast<Word*>(at) = word;
}

void copy_words(std::byte*& to, const std::byte*& from, std::size_t& count)
{
    for (; count >= 16; count -= 16, to += 16, from += 16) {
        auto* target = reinterpret_cast<Word*>(to);
        const auto* source = reinterpret_cast<const Word*>(from);
        const std::uint32_t first = source[0];
        const std::uint32_t second = source[1];
        const std::uint32_t third = source[2];
        const std::uint32_t fourth = source[3];
        target[0] = first;
        target[1] = second;
        target[2] = third;
        target[3] = fourth;
    }
    for (; count >= 4; count -= 4, to += 4, from += 4)
        *reinterpret_cast<Word*>(to) = *reinterpret_cast<const Word*>(from);
}

/// All bytes of the word are the same.
[[gnu::noinline]] void set_bytes(std::byte* at, std::size_t count, std::uint32_t word)
{
    for (; count > 0 && beyond_word(at) != 0; --count)
        *at++ = static_cast<std::byte>(word);
    set_words(at, count, word);
    for (; count > 0; --count)
        *at++ = static_cast<std::byte>(word);
}

/// From the lower end up: also for overlapping memory, if `to` is below `from`.
[[gnu::noinline]] void copy_up(std::byte* to, const std::byte* from, std::size_t count)
{
    if (lie_alike(to, from)) {
        for (; count > 0 && beyond_word(to) != 0; --count)
            *to++ = *from++;
        copy_words(to, from, count);
    }
    for (; count > 0; --count)
        *to++ = *from++;
}

/// From the ends down, where `to` and `from` point.
void copy_down(std::byte* to, const std::byte* from, std::size_t count)
{
    if (lie_alike(to, from)) {
        for (; count > 0 && beyond_word(to) != 0; --count)
            *--to = *--from;
        for (; count >= 4; count -= 4) {
            to -= 4;
            from -= 4;
            *reinterpret_cast<Word*>(to) = *reinterpret_cast<const Word*>(from);
        }
    }
    for (; count > 0; --count)
        *--to = *--from;
}

}

extern "C" {

void* memcpy(void* __restrict to, const void* __restrict from, std::size_t count)
{
    auto* const target = static_cast<std::byte*>(to);
    const auto* const source = static_cast<const std::byte*>(from);
    if (is_small(place_of(to) | place_of(from), count)) {
        do {
            count -= 4;
            *reinterpret_cast<Word*>(target + count) = *reinterpret_cast<const Word*>(source + count);
        } while (count != 0);
        return to;
    }
    copy_up(target, source, count);
    return to;
}

void* memmove(void* to, const void* from, std::size_t count)
{
    auto* target = static_cast<std::byte*>(to);
    const auto* source = static_cast<const std::byte*>(from);
    if (target < source)
        copy_up(target, source, count);
    else
        copy_down(target + count, source + count, count);
    return to;
}

void* memset(void* to, int value, std::size_t count)
{
    auto* const at = static_cast<std::byte*>(to);
    const std::uint32_t word = static_cast<std::uint8_t>(value) * 0x0101'0101U;
    if (is_small(place_of(to), count)) {
        do {
            count -= 4;
            *reinterpret_cast<Word*>(at + count) = word;
        } while (count != 0);
        return to;
    }
    set_bytes(at, count, word);
    return to;
}

int memcmp(const void* left, const void* right, std::size_t count)
{
    const auto* a = static_cast<const unsigned char*>(left);
    const auto* b = static_cast<const unsigned char*>(right);
    for (std::size_t i = 0; i < count; ++i) {
        if (a[i] != b[i])
            return a[i] - b[i];
    }
    return 0;
}

std::size_t strlen(const char* text)
{
    const char* end = text;
    while (*end != 0)
        ++end;
    return static_cast<std::size_t>(end - text);
}
}
