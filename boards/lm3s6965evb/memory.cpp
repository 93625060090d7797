// What the compiler calls for copies and fills even without a C library. Compiled with
// -fno-tree-loop-distribute-patterns, or these loops would become calls to themselves.

#include <cstddef>
#include <cstring>

extern "C" {

void* memcpy(void* __restrict to, const void* __restrict from, std::size_t count)
{
    auto* target = static_cast<std::byte*>(to);
    const auto* source = static_cast<const std::byte*>(from);
    for (std::size_t i = 0; i < count; ++i)
        target[i] = source[i];
    return to;
}

void* memmove(void* to, const void* from, std::size_t count)
{
    auto* target = static_cast<std::byte*>(to);
    const auto* source = static_cast<const std::byte*>(from);
    if (target < source)
        return memcpy(to, from, count);
    while (count-- > 0)
        target[count] = source[count];
    return to;
}

void* memset(void* to, int value, std::size_t count)
{
    auto* target = static_cast<std::byte*>(to);
    for (std::size_t i = 0; i < count; ++i)
        target[i] = static_cast<std::byte>(value);
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
}
