#include "core/scene/track_view.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/bytes.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

namespace kfast::test {
namespace {

std::vector<std::byte> varint(std::uint32_t value)
{
    std::vector<std::byte> result;
    for (; value >= 0x80; value >>= 7)
        result.push_back(static_cast<std::byte>(value | 0x80));
    result.push_back(static_cast<std::byte>(value));
    return result;
}

std::int32_t ticks(std::uint32_t code)
{
    const auto coded = varint(code);
    ByteReader reader{coded};
    const Time time = read_time_code(reader);
    CHECK(reader.left() == 0);
    return time.ticks;
}

}

TEST_CASE("an even time code counts frames, an odd one ticks")
{
    CHECK(ticks(0) == 0);
    CHECK(ticks(1) == 0);
    CHECK(ticks(2) == 1024);
    CHECK(ticks(3) == 1);
    CHECK(ticks(2 * 1'000'000) == kfb::max_time);
    CHECK(ticks(2 * kfb::max_time + 1) == kfb::max_time);
}

TEST_CASE("a time code beyond the limit stays just beyond it")
{
    for (const std::uint32_t code :
         {2'000'002U, 2U * kfb::max_time + 3, 4'194'304U, 1U << 23, 0xFFFF'FFFEU, 0xFFFF'FFFFU})
        CHECK(ticks(code) == kfb::max_time + 1);
}

TEST_CASE("a time code that breaks off is noticed")
{
    const auto broken = bytes({0x80});
    ByteReader reader{broken};
    CHECK(read_time_code(reader) == Time{0});
    CHECK(reader.overrun());
}

}
