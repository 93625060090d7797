#include "host/beam/beam_source.hpp"

#include "core/bytes/crc32.hpp"

#include <array>
#include <cstddef>

namespace kfast {

BeamSource::BeamSource(const SceneView& scene, const BeamProfile& profile, std::uint32_t budget)
    : block_{BeamPlayer::block_bytes(scene, profile)},
      player_{*BeamPlayer::create(scene, profile, budget, block_.bytes())}
{
}

std::span<const BeamPoint> BeamSource::show(Time moment)
{
    player_.show_moment(moment);
    points_.clear();
    PointStream plot = player_.plot();
    std::array<BeamPoint, 256> piece;
    while (const std::size_t count = plot.next(piece))
        points_.insert(points_.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(count));
    return points_;
}

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
