#pragma once

#include "core/math/point.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/scene/input_view.hpp"
#include "core/scene/property.hpp"
#include "core/scene/skeleton_view.hpp"
#include "core/time/clock.hpp"
#include "core/time/time.hpp"
#include "core/time/velocity_law.hpp"
#include "host/geometry/drawing.hpp"
#include "host/geometry/outline.hpp"
#include "host/text/source.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// A scene as it is written, with every number already rounded to what the binary stores.
namespace kfast::scene {

/// Which points of a drawing match which of the next, if their numbers differ.
enum class Match : std::uint8_t {
    count,   ///< added points are spread evenly over the segments (core/pose/equalize.hpp)
    length,  ///< added points are placed by arc length, closed strokes begin where they fit best
    letters, ///< so are those of each letter of a text, of which the first becomes the first, and so on
};

constexpr std::string_view match_name(Match match)
{
    return match == Match::count ? "count" : match == Match::length ? "length" : "letters";
}

enum class SectorForm : std::uint8_t { arc, pie, ring_piece };

/// A stroke of a drawing that is written as an arc or a pie.
struct SectorStroke {
    std::size_t stroke = 0;
    Sector sector;
    SectorForm form = SectorForm::arc;
};

/// A drawing at a time; laws and match govern the transition to the next key.
struct Key {
    Time time;
    LawPair laws;
    Match match = Match::count;
    Drawing drawing;
    /// For a wire frame, whose segments are lines: structured as `drawing`, x being the depths of its points,
    /// towards the viewer, and y 0. Else empty.
    Drawing depths = {};
    SourceSpan place;
    std::vector<SectorStroke> sectors = {}; ///< of the drawing
    /// The first stroke of each letter of its texts, and of each other shape. Needed only for Match::letters.
    std::vector<std::size_t> letters = {};
};

/// A value at a time, in the unit of its property; the laws govern the transition to the next key.
struct TrackKey {
    Time time;
    LawPair laws;
    std::int32_t value = 0;
    SourceSpan place = {};
};

/// One quantity of an item over time, or by an input; holds its first value before the first key and its last
/// one after the last. Has at least one key, and the times of its keys rise.
struct Track {
    Property property = Property::x;
    std::vector<TrackKey> keys;
    bool is_smooth = false; ///< by cubic Hermite curves (core/time/track.hpp) instead of laws
    Driver driver = {};     ///< of its keys
};

/// What an item with a track of Property::along follows: its pivot moves on the stroke.
struct Path {
    Stroke stroke;      ///< has an extent
    bool turns = false; ///< the item rotates with the stroke
};

/// A bone as set up and what animates it, in the frame of its parent: the origin at the parent's origin, x
/// along the parent. The frame of a root is the canvas.
struct Bone {
    std::string name;
    std::optional<std::size_t> parent; ///< index of an earlier bone
    /// Indexed by BoneQuantity, in its units; the length is at least 1.
    std::array<std::int32_t, bone_quantity_count> set_up = {};
    /// For each quantity; none where it stays as set up. Times rise.
    std::array<std::vector<TrackKey>, bone_quantity_count> keys = {};
    bool is_at_tip = false;        ///< the origin moves with the length of the parent
    bool turns_as_written = false; ///< angles tween as numbers, instead of the shorter way round
    Driver driver = {};            ///< of all its keys
    SourceSpan place = {};
};

/// A tree of bones, or several: roots first, then their children, then theirs.
struct Bones {
    std::string name;
    std::vector<Bone> bones; ///< at least one
    SourceSpan place;
};

/// How far a point follows a bone.
struct BoneWeight {
    std::size_t bone = 0; ///< index into Bones::bones
    int weight = 0;       ///< in 1/65536, at least 1
    friend bool operator==(const BoneWeight&, const BoneWeight&) = default;
};

/// One to four bones, their weights adding up to 65,536; the heaviest first.
using Binding = std::vector<BoneWeight>;

/// Which bones deform an object.
struct Skin {
    std::size_t bones = 0; ///< index into Scene::bones
    /// For each point of the object's first drawing that is not empty (each stroke's first point and the ends
    /// of its segments).
    std::vector<Binding> bindings;
    SourceSpan place;
    bool turns_changes = false; ///< the changes of the drawings rotate and scale with the bones
};

/// A line of nodes with an outline point on either side of each: cells between them deform the points of a
/// drawing.
struct Backbone {
    std::vector<Point> nodes; ///< at least two
    std::vector<Point> left;  ///< one for each node; on the left as seen along the nodes, y down
    std::vector<Point> right;
    friend bool operator==(const Backbone&, const Backbone&) = default;
};

/// The backbones of an object at a time; the laws govern the transition to the next.
struct BackboneKey {
    Time time;
    LawPair laws;
    std::vector<Backbone> backbones; ///< at least one; of the same form in all keys of the object
    SourceSpan place;
};

using kfast::BeamParts;
using kfast::BeamStyle;
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

/// A character of a label: its drawing, and how far from its beginning the next one begins.
struct LabelGlyph {
    Drawing drawing;
    std::int32_t advance = 0; ///< in 1/4096 px
};

/// What is added between two glyphs of a label, in 1/4096 px.
struct Kerning {
    std::uint8_t left = 0;
    std::uint8_t right = 0;
    std::int32_t by = 0;
};

using kfast::Align;

/// How a label writes a number: as kfast::NumberFormat, which refers to glyphs of the label.
struct NumberFormat {
    std::uint32_t decimals = 0;
    std::uint32_t digits = 1;
    std::uint32_t places = 0;
    std::vector<std::uint8_t> before;
    std::vector<std::uint8_t> behind;
};

/// The text or the number of an input, laid out on one line.
struct Label {
    std::size_t input = 0; ///< index into Scene::inputs
    Point at;              ///< on the baseline, where `align` says
    Point pivot;           ///< unless the object has another one
    Align align = Align::left;
    std::int32_t spacing = 0; ///< added between glyphs, in 1/4096 px
    /// Of each character of a text, in their order; of a number as kfb::number_glyph says.
    std::vector<LabelGlyph> glyphs;
    std::vector<Kerning> kerning; ///< in the order of their glyphs, of the left ones first; none is 0
    std::optional<NumberFormat> format = {}; ///< only of a number
};

/// Has a fill or a stroke or both, and at least one key, unless it shows an input; the times of its keys
/// rise.
struct Object {
    std::optional<std::size_t> fill; ///< index into Scene::palette
    FillRule fill_rule = FillRule::nonzero;
    std::optional<StrokeStyle> stroke;
    std::vector<Key> keys;
    std::optional<Skin> skin = {};               ///< then no backbones, and all drawings have as many strokes
    std::vector<BackboneKey> backbone_keys = {}; ///< their times rise
    Driver driver = {};                          ///< of both
    std::optional<std::size_t> live = {}; ///< index into Scene::inputs: a drawing; nothing deforms it then
    std::optional<Label> label = {};
    BeamStyle beam = {};     ///< hatched only if there is a fill
    bool has_depths = false; ///< it is a wire frame: only stroked, not deformed, matched by count
};

struct Item;

/// Items that move and fade together.
struct Group {
    std::vector<Item> items; ///< the first is the lowest
};

/// A symbol as if its items were here.
struct Use {
    std::size_t symbol = 0; ///< index into Scene::symbols
    /// While the scene is read, what the keys of the symbol go by; then they go by it themselves.
    Driver inner = {};
    int colour_step = 0; ///< while it is read, the steps of its colours along the palette
};

/// Something that is painted; `tracks` has each property at most once, in the order of their values.
struct Item {
    std::string name; ///< may be empty for groups and uses
    std::vector<Track> tracks;
    std::variant<Object, Group, Use> content;
    SourceSpan place;
    std::optional<Path> path = {}; ///< if there is a track of Property::along
};

/// Items that are stored once, however often they are used. Uses only symbols before it.
struct Symbol {
    std::string name;
    std::vector<Item> items;
};

/// A named range of the timeline.
struct Clip {
    std::string name;
    Time begin;
    Time end; ///< later than `begin`, at most the length of the scene
    Loop loop = Loop::once;
};

/// A named time on the timeline.
struct Event {
    std::string name;
    Time time;
};

/// The part of an input that is a text.
struct TextInput {
    std::u32string glyphs;        ///< the characters that it may have, in the order of their code points
    std::uint32_t max = 1;        ///< characters
    std::u32string default_value; ///< of these glyphs
};

/// A drawing that objects show until another is set, and what that one may have.
struct DrawingInput {
    std::size_t strokes = 1;    ///< at most `points`
    std::size_t points = 1;     ///< of all strokes together
    Drawing default_value = {}; ///< lines, and no more than that
};

/// What the scene takes from outside: a number that may drive keys, its values in 1/1000, or a text or a
/// drawing.
struct Input {
    std::string name;
    std::int32_t min = 0;
    std::int32_t max = 1000;        ///< more than `min`
    std::int32_t default_value = 0; ///< within both
    InputType type = InputType::number;
    TextInput text = {};       ///< only of a text
    DrawingInput drawing = {}; ///< only of a drawing
};

struct Scene {
    Size canvas;
    std::uint32_t frame_rate = 30'000; ///< frames in 1000 seconds
    Time length;                       ///< at least one frame
    Loop loop = Loop::repeat;
    bool has_routes = false; ///< strokes that never change are put in the order in which a beam travels least
    int camera = 480;        ///< distance of the viewer from the canvas, in pixels, 16 … 32767
    std::vector<Colour> palette; ///< the colours in use, each once; the first is the background
    std::vector<Input> inputs;
    std::vector<Bones> bones;
    std::vector<Clock> clocks; ///< each goes by the time of the scene or by one before it
    std::vector<Symbol> symbols;
    std::vector<Item> items; ///< the first is the lowest
    std::vector<Clip> clips;
    std::vector<Event> events; ///< in the order of their times
};

}
