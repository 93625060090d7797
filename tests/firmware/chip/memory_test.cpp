#include <algorithm>
#include <array>
#include <cstddef>
#include <doctest/doctest.h>
#include <numeric>

extern "C" {
void* device_memcpy(void* to, const void* from, std::size_t count);
void* device_memmove(void* to, const void* from, std::size_t count);
void* device_memset(void* to, int value, std::size_t count);
int device_memcmp(const void* left, const void* right, std::size_t count);
std::size_t device_strlen(const char* text);
}

namespace kfast::test {
namespace {

struct Memory {
    alignas(4) std::array<unsigned char, 64> bytes{};

    Memory() { std::iota(bytes.begin(), bytes.end(), static_cast<unsigned char>(1)); }
};

constexpr std::size_t max = 40;

}

TEST_CASE("bytes are copied from any place to any other, as many as told")
{
    for (std::size_t to = 0; to < 4; ++to)
        for (std::size_t from = 0; from < 4; ++from)
            for (std::size_t count = 0; count <= max; ++count) {
                const Memory source;
                Memory target;
                Memory expected;
                target.bytes.fill(99);
                expected.bytes.fill(99);
                std::copy_n(source.bytes.begin() + from, count, expected.bytes.begin() + to);
                CHECK(device_memcpy(&target.bytes[to], &source.bytes[from], count) == &target.bytes[to]);
                REQUIRE(target.bytes == expected.bytes);
            }
}

TEST_CASE("bytes are moved onto themselves, up and down")
{
    for (std::size_t to = 0; to < 20; ++to)
        for (std::size_t from = 0; from < 20; ++from)
            for (std::size_t count = 0; count <= max; ++count) {
                const Memory before;
                Memory memory;
                Memory expected;
                std::copy_n(before.bytes.begin() + from, count, expected.bytes.begin() + to);
                CHECK(device_memmove(&memory.bytes[to], &memory.bytes[from], count) == &memory.bytes[to]);
                REQUIRE(memory.bytes == expected.bytes);
            }
}

TEST_CASE("any stretch of bytes is set, and nothing else")
{
    for (std::size_t to = 0; to < 4; ++to)
        for (std::size_t count = 0; count <= max; ++count) {
            Memory memory;
            Memory expected;
            std::fill_n(expected.bytes.begin() + to, count, static_cast<unsigned char>(0xAB));
            CHECK(device_memset(&memory.bytes[to], 0x5AB, count) == &memory.bytes[to]);
            REQUIRE(memory.bytes == expected.bytes);
        }
}

TEST_CASE("bytes are compared as unsigned, the first difference decides")
{
    const std::array<unsigned char, 3> a{1, 200, 5};
    const std::array<unsigned char, 3> b{1, 100, 9};
    CHECK(device_memcmp(a.data(), b.data(), 1) == 0);
    CHECK(device_memcmp(a.data(), b.data(), 3) > 0);
    CHECK(device_memcmp(b.data(), a.data(), 3) < 0);
}

TEST_CASE("strlen counts up to the zero")
{
    CHECK(device_strlen("") == 0);
    CHECK(device_strlen("top") == 3);
    CHECK(device_strlen("top\0below") == 3);
}

}
