#pragma once

#include "core/colour.hpp"
#include "core/fill_rule.hpp"
#include "core/law_pair.hpp"
#include "core/property.hpp"
#include "core/size.hpp"
#include "core/stroke_style.hpp"
#include "core/time.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
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

/// As the format counts them: one where a stroke begins and one for each of its segments.
inline std::size_t point_count(const Drawing& drawing)
{
    std::size_t points = drawing.strokes.size();
    for (const Stroke& stroke : drawing.strokes)
        points += stroke.segments.size();
    return points;
}

/// Which points of a drawing meet which of the next, where their numbers differ.
enum class Match : std::uint8_t {
    count,  ///< added points are spread evenly over the segments (core/equalize.hpp)
    length, ///< added points are placed by arc length, closed strokes begin where it fits best
};

/// A drawing at a moment; laws and match govern the way to the next key.
struct Key {
    Time time;
    LawPair laws;
    Match match = Match::count;
    Drawing drawing;
    Place place;
};

/// A value at a moment, in the unit of its property; the laws govern the way to the next key.
struct TrackKey {
    Time time;
    LawPair laws;
    std::int32_t value = 0;
    Place place = {};
};

/// One quantity of an item over time; holds its first value before the first key and its last one behind the
/// last. Has at least one key, and the times of its keys rise.
struct Track {
    Property property = Property::x;
    std::vector<TrackKey> keys;
};

using kfast::Cap;
using kfast::FillRule;
using kfast::Join;

struct StrokeStyle {
    std::size_t colour = 0; ///< index into Scene::palette
    int width = 16;         ///< 1/16 px, at least 1
    Cap cap = Cap::butt;
    Join join = Join::miter;
    int miter_limit = default_miter_limit; ///< the longest miter, in 1/8 widths, 8 … 255
};

/// Has a fill or a stroke or both, and at least one key; the times of its keys rise.
struct Object {
    std::optional<std::size_t> fill; ///< index into Scene::palette
    FillRule fill_rule = FillRule::nonzero;
    std::optional<StrokeStyle> stroke;
    std::vector<Key> keys;
};

struct Item;

/// Items that move and fade together.
struct Group {
    std::vector<Item> items; ///< the first lies lowest
};

/// A symbol as if its items stood here.
struct Use {
    std::size_t symbol = 0; ///< index into Scene::symbols
};

/// Something that is painted; `tracks` has each property at most once, in the order of their values.
struct Item {
    std::string name; ///< may be empty for groups and uses
    std::vector<Track> tracks;
    std::variant<Object, Group, Use> content;
    Place place;
};

/// Items that are stored once, however often they are used. Uses only symbols before it.
struct Symbol {
    std::string name;
    std::vector<Item> items;
};

/// A named stretch of the timeline.
struct Clip {
    std::string name;
    Time begin;
    Time end; ///< later than `begin`, at most the length of the scene
    Loop loop = Loop::once;
};

/// A named moment of the timeline.
struct Event {
    std::string name;
    Time time;
};

struct Scene {
    Size canvas;
    std::uint32_t frame_rate = 30'000; ///< frames in 1000 seconds
    Time length;                       ///< at least one frame
    Loop loop = Loop::repeat;
    std::vector<Colour> palette; ///< the colours in use, each once; the first is the background
    std::vector<Symbol> symbols;
    std::vector<Item> items; ///< the first lies lowest
    std::vector<Clip> clips;
    std::vector<Event> events; ///< in the order of their times
};

}
