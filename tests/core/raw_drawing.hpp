#pragma once

#include "host/compiler/pack/pack_drawing.hpp"
#include "host/scene/model.hpp"
#include "tests/core/raw_scene.hpp"

#include <cstdint>
#include <random>
#include <vector>

/// Drawings as a scene stores them.
namespace kfast::test {

inline Bytes packed(const scene::Drawing& drawing)
{
    ByteWriter bytes;
    pack_drawing(drawing, bytes);
    return bytes.bytes();
}

/// Coordinates in 1/16 px.
inline scene::Stroke polyline_of(const std::vector<scene::Point>& points)
{
    scene::Stroke stroke{.from = points.front(), .segments = {}};
    for (std::size_t i = 1; i < points.size(); ++i)
        stroke.segments.push_back({.cubic = false, .c1 = {}, .c2 = {}, .to = points[i]});
    return stroke;
}

/// Within 0 … 512 px.
inline scene::Point random_point(std::mt19937& random)
{
    const auto coordinate = [&random] { return static_cast<std::int16_t>(random() % (512 * 16 + 1)); };
    const std::int16_t x = coordinate();
    return {x, coordinate()};
}

/// Other points, in strokes and segments as `built` has them.
inline scene::Drawing random_drawing_like(const scene::Drawing& built, std::mt19937& random)
{
    scene::Drawing drawing = built;
    for (scene::Stroke& stroke : drawing.strokes) {
        stroke.from = random_point(random);
        for (scene::Segment& segment : stroke.segments) {
            segment.to = random_point(random);
            if (segment.cubic) {
                segment.c1 = random_point(random);
                segment.c2 = random_point(random);
            }
        }
    }
    return drawing;
}

/// Lines and curves, at least one stroke; a stroke may be a single point.
inline scene::Drawing random_drawing(std::mt19937& random)
{
    scene::Drawing built;
    built.strokes.resize(1 + random() % 3);
    for (scene::Stroke& stroke : built.strokes)
        for (auto left = random() % 5; left > 0; --left)
            stroke.segments.push_back({.cubic = random() % 2 == 0, .c1 = {}, .c2 = {}, .to = {}});
    return random_drawing_like(built, random);
}

/// Puts drawings and skins one after the other.
class RawDrawings {
public:
    /// Its offset.
    std::uint32_t add(const Bytes& bytes)
    {
        const auto offset = static_cast<std::uint32_t>(bytes_.size());
        bytes_ = joined({bytes_, bytes});
        return offset;
    }
    std::uint32_t add(const scene::Drawing& drawing) { return add(packed(drawing)); }

    const Bytes& bytes() const { return bytes_; }

private:
    Bytes bytes_;
};

}
