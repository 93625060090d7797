#pragma once

#include "core/colour.hpp"
#include "core/size.hpp"
#include "core/stroke_style.hpp"
#include "core/time.hpp"
#include "core/velocity_law.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// A scene as it is written, with every number already rounded to what the binary stores.
namespace kfast::scene {

/// Canvas pixels in 1/16.
struct Point {
    std::int16_t x = 0;
    std::int16_t y = 0;
    friend bool operator==(Point, Point) = default;
};

/// From the point before it to `to`; c1 and c2 are the control points of a cubic Bézier (0, 0 in a line).
struct Segment {
    bool cubic = false;
    Point c1;
    Point c2;
    Point to;
    friend bool operator==(const Segment&, const Segment&) = default;
};

/// Closed when its first and last point coincide. A single point has no segments; no segment has all of its
/// points in one place.
struct Stroke {
    Point from;
    std::vector<Segment> segments;
    friend bool operator==(const Stroke&, const Stroke&) = default;
};

/// May be empty: the object is not seen.
struct Drawing {
    std::vector<Stroke> strokes;
    friend bool operator==(const Drawing&, const Drawing&) = default;
};

/// A drawing at a moment; the laws govern the way to the next key.
struct Key {
    Time time;
    VelocityLaw law_x = VelocityLaw::constant;
    VelocityLaw law_y = VelocityLaw::constant;
    Drawing drawing;
    Place place;
};

using kfast::Cap;
using kfast::Join;

struct StrokeStyle {
    std::size_t colour = 0; ///< index into Scene::palette
    int width = 16;         ///< 1/16 px, at least 1
    Cap cap = Cap::butt;
    Join join = Join::miter;
};

/// Has a fill or a stroke or both, and at least one key; the times of its keys rise.
struct Object {
    std::string name;
    std::optional<std::size_t> fill; ///< index into Scene::palette
    std::optional<StrokeStyle> stroke;
    std::vector<Key> keys;
    Place place;
};

struct Scene {
    Size canvas;
    std::uint32_t frame_rate = 30'000; ///< frames in 1000 seconds
    Time length;                       ///< at least one frame
    Loop loop = Loop::repeat;
    std::vector<Colour> palette; ///< the colours in use, each once; the first is the background
    std::vector<Object> objects; ///< the first lies lowest
};

}
