#include "host/beam/point_hash.hpp"

#include "core/bytes/crc32.hpp"

#include <array>
#include <cstddef>

namespace kfast {
namespace {

std::array<std::byte, 8> bytes_of(const BeamPoint& point)
{
    const auto low = [](int value) { return static_cast<std::byte>(value & 0xFF); };
    const auto high = [](int value) { return static_cast<std::byte>(value >> 8 & 0xFF); };
    const auto [red, green, blue, opacity] = point.colour;
    return {low(point.at.x), high(point.at.x), low(point.at.y), high(point.at.y),
            low(red),        low(green),       low(blue),       low(opacity)};
}

}

std::uint32_t hash(std::span<const BeamPoint> points)
{
    Crc32 crc;
    for (const BeamPoint& point : points)
        crc.add(bytes_of(point));
    return crc.value();
}

}
